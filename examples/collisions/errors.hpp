// What can be wrong with a file, and with one of its rows.
#pragma once
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace collisions {

/// Nothing can be done with this file; what() is a sentence for standard error.
struct file_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// This row is bad, the others go on. `place` is empty, or says where in the row: `column radius_1, value "-1"`.
struct row_error : std::runtime_error {
  std::string place;
  row_error(std::string where, const std::string& reason) : std::runtime_error(reason), place(std::move(where)) {}
};

/// A column is not there that somebody needs.
struct missing_column : row_error {
  missing_column(const std::string& column, std::string_view needed_by)
      : row_error("column " + column, "the header has no such column, and " + std::string(needed_by) + " needs it") {}
};

/// Text for a message: in double quotes, on one line and not too long.
inline std::string quoted(const std::string& text) {
  std::size_t shown = std::min<std::size_t>(text.size(), 60);
  while (shown > 0 && shown < text.size() && (static_cast<unsigned char>(text[shown]) & 0xC0) == 0x80)
    --shown; // not within a character
  std::string out = "\"";
  for (const char c : text.substr(0, shown))
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return out + (text.size() > shown ? "...\"" : "\"");
}

} // namespace collisions
