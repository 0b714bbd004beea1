// What a scalar type must offer to be put into the laws' formulas: the few things beyond + - * / sqrt log exp pow.
// Adapters for other types stand in number/: autodiff.hpp, multiprecision.hpp, xsimd.hpp.
#pragma once
#if __cplusplus < 202002L
#error "ricochet: compile as C++20, with -std=c++20 or later"
#endif
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <utility>

#ifdef __FAST_MATH__
#error "ricochet: compile without -ffast-math; error bounds, infinities and signed zeros would lose their meaning"
#endif

namespace ricochet {

// The formulas' functions: of plain numbers from here, of other scalar types by their own namespace, of quantities from
// units.hpp.
using std::abs;
using std::atan2;
using std::cos;
using std::exp;
using std::isfinite;
using std::log;
using std::log1p;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

/// How ricochet sees a scalar type T. `real` is the plain number that steers steps and events;
/// `value` is the part of x that it looks at; `inverts_exactly` is true where a double-precision table is too coarse.
template <class T>
struct number_traits {
  static_assert(std::floating_point<T>,
                "this scalar type is unknown to ricochet: include its adapter from ricochet/number/ first");
  using real = T;
  static constexpr bool inverts_exactly = false;
  static constexpr T pi() { return std::numbers::pi_v<T>; }
  static constexpr T euler_gamma() { return std::numbers::egamma_v<T>; }
  static constexpr real value(const T& x) { return x; }
};

template <class T>
using real_of = typename number_traits<T>::real;

template <class T>
constexpr auto value_of(const T& x) {
  return number_traits<T>::value(x);
}

/// What a comparison of such numbers gives: a bool, or one for each of many numbers side by side.
template <class T>
using truth_of = decltype(std::declval<const T&>() < std::declval<const T&>());
template <class T>
inline constexpr bool is_many = !std::same_as<truth_of<T>, bool>;

template <class T>
T pi() {
  return number_traits<T>::pi();
}

/// A number that stays the same during a collision, with its reciprocal: dividing by it costs a product.
template <class T>
struct divisor {
  T value{}, reciprocal{};

  divisor() = default;
  constexpr divisor(T x) : value(x), reciprocal(T(1) / x) {}
  constexpr operator const T&() const { return value; }
  friend constexpr T operator/(const T& a, const divisor& b) { return a * b.reciprocal; }
};

/// How a number that stays the same during a collision is held: with its reciprocal where that pays.
template <class T>
struct constant_traits {
  using type = T;
};
template <std::floating_point T>
struct constant_traits<T> {
  using type = divisor<T>;
};
template <class T>
using constant = typename constant_traits<T>::type;

/// `condition ? yes() : no()`. A pack evaluates both sides and blends: clamp arguments first, so that neither
/// side makes a NaN.
template <class T, class Yes, class No>
constexpr T select(bool condition, Yes yes, No no) {
  return condition ? T(yes()) : T(no());
}

/// f(x) for a function known only on real numbers through `f.value(x)` and `f.slope(x)`.
template <std::floating_point T, class F>
T evaluate(const F& f, const T& x) {
  return f.value(x);
}

template <class T>
constexpr auto square(const T& x) {
  return x * x;
}

template <class T>
constexpr auto cube(const T& x) {
  return x * x * x;
}

/// Cube root for any scalar with pow: only for set-up, never in a loop.
template <class T>
T cube_root(const T& x) {
  return value_of(x) > 0 ? T(pow(x, T(1) / T(3))) : T(0);
}

} // namespace ricochet
