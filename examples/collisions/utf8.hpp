// Whether bytes are text.
#pragma once
#include <string>
#include <string_view>

namespace collisions {

/// The sentence of what keeps the bytes from being UTF-8 text without NUL; empty where nothing does.
std::string why_no_text(std::string_view bytes);

/// The bytes with U+FFFD for each that keeps them from being text.
std::string as_text(std::string_view bytes);

} // namespace collisions
