// Validation at the door: a wrong number is refused with its name, value and allowed range.
#pragma once
#include <ricochet/units.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ricochet {

/// Thrown for every wrong input; what() is one sentence naming quantity, value and range.
struct bad_input : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Allowed range of a parameter in SI units. Infinity is allowed only where an end is infinite and closed.
struct range {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = false;

  constexpr bool contains(double x) const {
    return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
  }
  std::string text() const {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "%c%g, %g%c", low_included ? '[' : '(', low, high, high_included ? ']' : ')');
    return buffer;
  }
};

/// A number as messages show it.
inline std::string shown(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}

inline constexpr range positive{.low_included = false};
inline constexpr range non_negative{};
inline constexpr range any_finite{.low = -std::numeric_limits<double>::max()};
inline constexpr range poissons_ratio_range{.high = 0.5};
inline constexpr range modulus_ratio_range{.low = 1e-4, .high = 0.98, .high_included = true};

namespace detail {
[[noreturn]] inline void refuse(std::string_view name, double x, const std::string& unit, const range& allowed) {
  const std::string with_unit = unit.empty() ? "" : " " + unit;
  throw bad_input(std::string(name) + " = " + shown(x) + with_unit + " is outside " + allowed.text() + with_unit);
}
} // namespace detail

/// \throws bad_input if the quantity lies outside its range (NaN always does).
template <class Quantity>
void require(std::string_view name, const Quantity& quantity, const range& allowed) {
  if (!allowed.contains(in_si(quantity)))
    detail::refuse(name, in_si(quantity), unit_symbol(quantity), allowed);
}

/// The quantity itself: for one that is made of others, which may be within their ranges and yet too large or too small
/// together. \throws bad_input if it lies outside its range.
template <class Quantity>
Quantity required(std::string_view name, const Quantity& quantity, const range& allowed) {
  require(name, quantity, allowed);
  return quantity;
}

/// One parameter of a law: its name, where it lives and what it may be.
template <class Member>
struct parameter {
  const char* name;
  Member member;
  range allowed;
};
template <class Member>
parameter(const char*, Member, range) -> parameter<Member>;

} // namespace ricochet
