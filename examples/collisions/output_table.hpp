// The text of the output: the input's columns, then the outcome's.
#pragma once
#include "row.hpp"
#include "solve.hpp"

namespace collisions {

/// `# units: SI; ...`
std::string units_line();

/// Output columns with units and meaning, one a line, for the help.
std::string output_help();

/// The names of all columns; one of the input that bears an output's name becomes input_<name>.
std::string header_line(const header& header);

/// The input's cells, unchanged, then the outcome's; where there is none, `failed` and blanks.
std::string row_line(const header& header, const csv_record& record, const outcome* result);

} // namespace collisions
