// A scalar type for the laws that counts floating-point operations.
#pragma once
#include <ricochet/number.hpp>

namespace measure {

/// A number that counts the operations it goes through.
struct counted {
  static inline long operations = 0;
  double x = 0;
  counted() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr counted(Number value) : x(static_cast<double>(value)) {}

  static counted made(double value) { return ++operations, counted(value); }
  friend counted operator+(const counted& a, const counted& b) { return counted::made(a.x + b.x); }
  friend counted operator-(const counted& a, const counted& b) { return counted::made(a.x - b.x); }
  friend counted operator*(const counted& a, const counted& b) { return counted::made(a.x * b.x); }
  friend counted operator/(const counted& a, const counted& b) { return counted::made(a.x / b.x); }
  friend counted operator-(const counted& a) { return counted::made(-a.x); }
  friend counted sqrt(const counted& a) { return counted::made(std::sqrt(a.x)); }
  friend counted pow(const counted& a, const counted& b) { return counted::made(std::pow(a.x, b.x)); }
  friend counted max(const counted& a, const counted& b) { return counted::made(std::max(a.x, b.x)); }
  counted& operator+=(const counted& b) { return *this = *this + b; }
  counted& operator-=(const counted& b) { return *this = *this - b; }
  counted& operator*=(const counted& b) { return *this = *this * b; }
  friend bool operator<(const counted& a, const counted& b) { return a.x < b.x; }
  friend bool operator>(const counted& a, const counted& b) { return a.x > b.x; }
  friend bool operator<=(const counted& a, const counted& b) { return a.x <= b.x; }
};

} // namespace measure

template <>
struct ricochet::number_traits<measure::counted> {
  using real = double;
  static constexpr bool inverts_exactly = false;
  static measure::counted pi() { return std::numbers::pi; }
  static double value(const measure::counted& a) { return a.x; }
};
template <>
struct ricochet::constant_traits<measure::counted> {
  using type = divisor<measure::counted>;
};
