// What the figures of the papers share.
#pragma once
#include <ricochet/ricochet.hpp>

#include <limits>
#include <string>
#include <vector>

namespace figures {

using namespace ricochet;
using namespace ricochet::units;

/// The numbers of one figure: a CSV file with its curves one below another, each in columns of its own.
class sheet {
public:
  sheet(const std::string& directory, const std::string& name, const std::string& about,
        const std::vector<column>& columns)
      : out_(directory + "/" + name + ".csv", "figures " + directory, about, columns), columns_(columns.size()) {}

  /// A row with the abscissa in the first column, and `values` in the columns from `first` on; the others stay empty.
  void row(double abscissa, std::size_t first, const std::vector<double>& values) {
    std::vector<double> cells(columns_, std::numeric_limits<double>::quiet_NaN());
    cells.at(0) = abscissa;
    for (std::size_t i = 0; i < values.size(); ++i)
      cells.at(first + i) = values[i];
    out_.row(cells);
  }
  void finish() { out_.finish(); }

private:
  table out_;
  std::size_t columns_;
};

/// n numbers from `low` to `high`, both included, in equal steps or in equal ratios.
inline std::vector<double> even(double low, double high, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i)
    x[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(n - 1);
  return x;
}
inline std::vector<double> logarithmic(double low, double high, std::size_t n) {
  std::vector<double> x = even(std::log(low), std::log(high), n);
  for (double& each : x)
    each = std::exp(each);
  return x;
}

void krijt_2013(const std::string& directory);
void brach_dunn_1995(const std::string& directory);
void kharaz_2001(const std::string& directory);

} // namespace figures
