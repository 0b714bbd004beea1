// Records of a CSV file, one at a time, by libcsv.
#pragma once
#include "text_lines.hpp"

#include <csv.h>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace collisions {

/// One line of cells; of several lines where a quoted cell holds line ends.
struct csv_record {
  std::size_t line = 0;                ///< in which it begins, from 1
  std::size_t lines = 1;               ///< how many it has
  std::uintmax_t end = 0;              ///< bytes of the input up to its end
  std::vector<std::string> cells;      ///< UTF-8 text as it stands, without the quotes
  std::string error;                   ///< empty, or why it is none, or the rest of it could not be read
  std::optional<std::size_t> bad_cell; ///< the cell at fault, if it is one
};

/// Comma-separated; blank lines are skipped. Quotes are strict: a cell that holds a quote begins and ends with one, and
/// doubles those within. Where a record of several lines is none, only the first of them is at fault: a forgotten quote
/// does not swallow the rows behind it.
class csv_reader {
public:
  static constexpr std::size_t most_lines = 100; ///< of one record; together they are no longer than a line may be

  explicit csv_reader(std::istream& in);
  ~csv_reader();
  csv_reader(const csv_reader&) = delete;
  csv_reader& operator=(const csv_reader&) = delete;

  /// The lines beginning with # up to the first that does not, which is left to next().
  /// \throws file_error if the input cannot be read.
  std::vector<std::string> comments();

  /// Records of several lines that do not have so many cells are none.
  void expect(std::size_t cells) { expected_ = cells; }

  /// Reads the next record; false at the end. \throws file_error if the input cannot be read.
  bool next(csv_record& record);

private:
  void parse(const text_line& first, csv_record& record);
  void start_afresh();

  text_lines lines_;
  csv_parser parser_{};
  std::optional<std::size_t> expected_;
};

} // namespace collisions
