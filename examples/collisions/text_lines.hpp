// Lines of a text file, one at a time; some can be put back.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <istream>
#include <string>
#include <vector>

namespace collisions {

struct text_line {
  std::string text;       ///< with its line end
  std::size_t number = 0; ///< from 1
  std::uintmax_t end = 0; ///< bytes of the input up to its end
  bool too_long = false;  ///< then the text is not the whole
};

/// Lines end in LF, CR LF or CR; a UTF-8 byte order mark is tolerated.
class text_lines {
public:
  static constexpr std::size_t longest = 1 << 20; ///< in bytes

  explicit text_lines(std::istream& in) : in_(in) {}

  /// The next line; false at the end. \throws file_error if the input cannot be read, or is of another encoding.
  bool take(text_line& line);

  /// These come next.
  void put_back(std::vector<text_line> lines);

private:
  std::istream& in_;
  std::deque<text_line> waiting_;
  std::size_t lines_read_ = 0;
  std::uintmax_t bytes_read_ = 0;
};

} // namespace collisions
