#include "utf8.hpp"

#include <boost/locale/utf.hpp>
#include <fmt/format.h>

namespace collisions {

namespace {

/// Calls `character` with each character and `fault` with each byte that is none.
template <class Character, class Fault>
void walk(std::string_view bytes, const Character& character, const Fault& fault) {
  namespace utf = boost::locale::utf;
  for (const char *at = bytes.data(), *const end = at + bytes.size(); at != end;) {
    const char* const first = at;
    const utf::code_point point = utf::utf_traits<char>::decode(at, end);
    if (point != 0 && point != utf::illegal && point != utf::incomplete) {
      character(std::string_view(first, static_cast<std::size_t>(at - first)));
    } else {
      at = first + 1; // decode() may have swallowed good ones behind it
      fault(static_cast<unsigned char>(*first));
    }
  }
}

} // namespace

std::string why_no_text(std::string_view bytes) {
  std::string why;
  walk(
      bytes, [](std::string_view) {},
      [&](unsigned char byte) {
        if (why.empty())
          why = byte == 0 ? "a NUL byte, so the file is damaged, or UTF-16: it is to be UTF-8"
                          : fmt::format("byte 0x{:02X} is no UTF-8 here: save the file as UTF-8", byte);
      });
  return why;
}

std::string as_text(std::string_view bytes) {
  std::string text;
  walk(
      bytes, [&](std::string_view character) { text += character; }, [&](unsigned char) { text += "\xEF\xBF\xBD"; });
  return text;
}

} // namespace collisions
