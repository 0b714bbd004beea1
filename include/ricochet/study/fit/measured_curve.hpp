// Measured restitution curves from files.
#pragma once
#include <ricochet/study/fit/least_squares_search.hpp>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/tokenizer.hpp>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>

namespace ricochet {

/// What a file of measurements says. `columns` and `cells` have all of its columns as they stand, the three that `data`
/// was made of among them: what else is known of each measurement.
struct measured_curve {
  std::vector<measurement> data;
  std::vector<std::string> comments; ///< its lines that begin with #, without that
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> cells; ///< of each measurement, one for each column
  std::vector<std::size_t> lines;              ///< of each measurement, from 1
};

namespace detail {

class measurement_reader {
public:
  measurement_reader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

  measured_curve read() {
    std::string line;
    while (std::getline(in_, line)) {
      ++line_;
      if (!line.empty() && line.back() == '\r')
        line.pop_back();
      if (line.starts_with("\xEF\xBB\xBF") && line_ == 1)
        line.erase(0, 3);
      if (line.find_first_not_of(" \t") == std::string::npos)
        continue;
      if (line.front() == '#')
        curve_.comments.push_back(trimmed(line.substr(1)));
      else if (curve_.columns.empty())
        read_header(line);
      else
        read_row(line);
    }
    if (in_.bad())
      throw std::runtime_error("cannot read " + name_);
    if (curve_.data.empty())
      fail("there are no measurements in it");
    return std::move(curve_);
  }

private:
  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw bad_input(name_ + (line_ ? ", line " + std::to_string(line_) : "") + ": " + why);
  }

  std::vector<std::string> split(const std::string& line) const {
    try {
      std::vector<std::string> cells;
      const boost::escaped_list_separator<char> commas("", ",", "\"");
      for (const std::string& cell : boost::tokenizer(line, commas))
        cells.push_back(trimmed(cell));
      return cells;
    } catch (const boost::escaped_list_error& error) {
      fail(error.what());
    }
  }

  void read_header(const std::string& line) {
    curve_.columns = split(line);
    for (std::size_t i = 0; i < curve_.columns.size(); ++i)
      if (!place_.emplace(curve_.columns[i], i).second)
        fail("there are two columns " + curve_.columns[i]);
    for (const char* needed : {"speed", "restitution"})
      if (!place_.contains(needed))
        fail(std::string("there is no column ") + needed + " in its header, \"" + line + "\"" +
             (curve_.columns.size() == 1 ? "; columns are separated by commas, numbers have a decimal point" : ""));
  }

  void read_row(const std::string& line) {
    std::vector<std::string> cells = split(line);
    if (cells.size() != curve_.columns.size())
      fail(std::to_string(cells.size()) + " cells for " + std::to_string(curve_.columns.size()) + " columns" +
           (cells.size() > curve_.columns.size() ? "; numbers have a decimal point" : ""));
    const auto text = [&](const char* column) { return cells[place_.at(column)]; };
    measurement m;
    m.speed = number("speed", text("speed"), positive) * units::metres_per_second;
    if (!boost::iequals(text("restitution"), "captured"))
      m.restitution = number("restitution", text("restitution"), range{.high = 1.5});
    if (place_.contains("error"))
      m.error = number("error", text("error"), positive);
    curve_.data.push_back(m);
    curve_.cells.push_back(std::move(cells));
    curve_.lines.push_back(line_);
  }

  double number(const std::string& column, const std::string& text, const range& allowed) const {
    double x = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (text.empty() || fault != std::errc() || end != text.data() + text.size())
      fail("column " + column + ", value \"" + text + "\": not a number, with a decimal point and no unit" +
           (column == "restitution" ? "; of a pair that stuck, write captured" : ""));
    try {
      require(column, x, allowed);
    } catch (const bad_input& refused) {
      fail(refused.what());
    }
    return x;
  }

  std::istream& in_;
  std::string name_;
  std::size_t line_ = 0;
  std::map<std::string, std::size_t> place_;
  measured_curve curve_;
};

} // namespace detail

/// Measurements from comma-separated text: lines that begin with # are comments, the first other line has the columns'
/// names, among them `speed` (m/s), `restitution` (a number, or the word captured), and `error`, the standard deviation
/// of the restitution, where it is known; then a line for each measurement.
/// \param name of the text, for messages \throws bad_input naming line, column, value and what is allowed
inline measured_curve read_measurements(std::istream& in, const std::string& name) {
  return detail::measurement_reader(in, name).read();
}

/// The same from a file. \throws std::runtime_error if it cannot be read, too
inline measured_curve read_measurements(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw std::runtime_error("cannot read " + file.string());
  return read_measurements(in, file.string());
}

} // namespace ricochet
