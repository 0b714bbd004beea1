// The text of the output: the input's columns, then the outcome's.
#pragma once
#include "row.hpp"
#include "solve.hpp"

#include <optional>
#include <string>
#include <vector>

namespace collisions {

/// `# units: SI; ...`
std::string units_line();

/// Output columns with units and meaning, one a line, for the help.
std::string output_help();

/// The names of all columns; one of the input that bears an output's name becomes input_<name>.
std::string header_line(const header& header);

/// The cells of the input that are copied: as many as there are columns.
std::vector<std::string> copied_cells(const header& header, const csv_record& record);

/// The input's cells, unchanged, then the outcome's; where there is none, `failed` and blanks.
std::string row_line(const header& header, const csv_record& record, const outcome* result);

/// What row_line() has written.
struct written_row {
  std::vector<std::string> copied; ///< the input's cells
  bool resolved;                   ///< separated or captured
  bool warned;                     ///< a law was used outside its range
};

/// Nothing where the record is no row that row_line() has written to a table with this header.
std::optional<written_row> read_written(const header& header, const csv_record& record);

} // namespace collisions
