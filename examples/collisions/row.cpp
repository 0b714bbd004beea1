#include "row.hpp"
#include "input_columns.hpp"

#include <fmt/format.h>

#include <charconv>

namespace collisions {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

header::header(const csv_record& record) : cells_(record.cells) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto [place, is_new] = places_.emplace(trimmed(cells_[i]), i);
    if (!is_new)
      throw file_error(fmt::format("line {}: columns {} and {} are both named {}; every column needs a name of its own",
                                   record.line, place->second + 1, i + 1, quoted(place->first)));
  }
}

row::row(const header& header, const csv_record& record)
    : header_(header), record_(record), read_(record.cells.size()) {
  if (!record.error.empty()) {
    const std::size_t at = record.bad_cell.value_or(header.cells().size());
    throw row_error(at < header.cells().size() ? fmt::format("column {}, value {}", quoted(trimmed(header.cells()[at])),
                                                             quoted(record.cells[at]))
                                               : "",
                    record.error);
  }
  if (record.cells.size() != header.cells().size())
    throw row_error("", fmt::format("the row has {} cells, the header {}", record.cells.size(), header.cells().size()));
}

bool row::is_blank(const std::string& column) const { return !header_.has(column) || trimmed(cell(column)).empty(); }

std::string row::text(const std::string& column, std::string_view needed_by) const {
  if (is_blank(column)) {
    if (!header_.has(column))
      throw missing_column(column, needed_by);
    throw row_error(place(column), fmt::format("blank, but needed by {}", needed_by));
  }
  return trimmed(cell(column));
}

std::string row::place(const std::string& column) const {
  return header_.has(column) ? fmt::format("column {}, value {}", column, quoted(cell(column))) : "column " + column;
}

std::vector<std::string> row::unread() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < read_.size(); ++i)
    if (const std::string name = trimmed(header_.cells()[i]);
        !read_[i] && unit_of(name) && !trimmed(record_.cells[i]).empty() && name != "density_2") // a wall has none
      names.push_back(name);
  return names;
}

double row::number(const std::string& column, std::string_view needed_by) const {
  const std::string digits = text(column, needed_by);
  const bool has_plus = digits.starts_with('+') && !digits.starts_with("+-");
  const char* const first = digits.data() + (has_plus ? 1 : 0);
  const char* const last = digits.data() + digits.size();
  double x = 0;
  const auto [end, problem] = std::from_chars(first, last, x);
  if (problem == std::errc::invalid_argument || end != last)
    throw row_error(place(column), "not a number: write it with a decimal point and without its unit, like 2.5e-6");
  if (problem == std::errc::result_out_of_range)
    throw row_error(place(column), "too large or too small for a double-precision number");
  return x;
}

} // namespace collisions
