// Records of a CSV file, one at a time, by libcsv.
#pragma once
#include <csv.h>

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace collisions {

/// One line of cells; of several lines where a quoted cell holds line ends.
struct csv_record {
  std::size_t line = 0;           ///< in which it begins, from 1
  std::vector<std::string> cells; ///< text as it stands, without the quotes
  std::string error;              ///< empty, or why the rest of it could not be read
};

/// Comma-separated; lines end in LF, CR LF or CR; blank lines are skipped; a UTF-8 byte order mark is tolerated. Quotes
/// are strict: a cell that holds a quote begins and ends with one, and doubles those within.
class csv_reader {
public:
  explicit csv_reader(std::istream& in);
  ~csv_reader();
  csv_reader(const csv_reader&) = delete;
  csv_reader& operator=(const csv_reader&) = delete;

  /// The lines beginning with # up to the first that does not, which is left to next().
  /// \throws file_error if the input cannot be read.
  std::vector<std::string> comments();

  /// Reads the next record; false at the end. \throws file_error if the input cannot be read.
  bool next(csv_record& record);

private:
  bool read_line();
  void parse(csv_record& record);
  void start_afresh();

  std::istream& in_;
  csv_parser parser_{};
  std::string line_; ///< with its line end
  std::size_t line_number_ = 0;
  bool unread_ = false; ///< line_ has not been parsed yet
};

} // namespace collisions
