#pragma once
#include <ricochet/version.hpp>

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ricochet {

/// A column of a table: its values' name and SI unit ("1" for a pure number).
struct column {
  std::string name, unit;
};

/// A CSV file that says what is in it: comment lines (#) with version, command and units, a header, and rows of numbers
/// with 17 significant digits. It gets its name only in finish(): an interrupted run leaves no half file behind.
class table {
public:
  /// `about` says, in one line, what the numbers are of. \throws std::runtime_error if the file cannot be written.
  table(std::filesystem::path file, const std::string& command, const std::string& about,
        const std::vector<column>& columns)
      : file_(std::move(file)), unfinished_(file_.string() + ".part"), columns_(columns.size()) {
    if (file_.has_parent_path())
      std::filesystem::create_directories(file_.parent_path());
    out_.open(unfinished_);
    out_ << "# ricochet " << version << "\n# command: " << command << "\n# " << about << "\n# units:";
    for (const column& each : columns)
      out_ << ' ' << each.name << " [" << each.unit << ']';
    out_ << '\n';
    for (std::size_t i = 0; i < columns.size(); ++i)
      out_ << (i ? "," : "") << columns[i].name;
    out_ << '\n';
    check();
  }

  /// One row, a value for each column; a value that is no number (an outcome that is absent) leaves its cell empty.
  void row(const std::vector<double>& values) {
    if (values.size() != columns_)
      throw std::runtime_error("table " + file_.string() + ": a row of " + std::to_string(values.size()) +
                               " values for " + std::to_string(columns_) + " columns");
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i)
        out_ << ',';
      if (values[i] == values[i])
        write(values[i]);
    }
    out_ << '\n';
  }

  /// \throws std::runtime_error if not everything could be written.
  void finish() {
    out_.flush();
    check();
    out_.close();
    std::filesystem::rename(unfinished_, file_);
  }

private:
  void write(double x) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, x, std::chars_format::general, 17);
    out_.write(text, end.ptr - text);
  }
  void check() const {
    if (!out_)
      throw std::runtime_error("cannot write " + unfinished_.string());
  }

  std::filesystem::path file_, unfinished_;
  std::size_t columns_;
  std::ofstream out_;
};

} // namespace ricochet
