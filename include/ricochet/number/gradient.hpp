// Derivatives with respect to a few quantities at once, for Jacobians within the loop: there Boost.Math's dual numbers
// (autodiff.hpp) take ten times as long.
#pragma once
#include <ricochet/number.hpp>

#include <array>

namespace ricochet {

/// A number with its first derivatives with respect to N quantities.
template <class Real, std::size_t N>
struct gradient {
  Real value{};
  std::array<Real, N> slope{};

  gradient() = default;
  template <std::convertible_to<Real> Other>
  constexpr gradient(const Other& x) : value(static_cast<Real>(x)) {}

  /// The quantity number i itself.
  static gradient seeded(const Real& x, std::size_t i) {
    gradient result(x);
    result.slope[i] = Real(1);
    return result;
  }

  gradient& operator+=(const gradient& b) { return *this = *this + b; }
  gradient& operator-=(const gradient& b) { return *this = *this - b; }
  gradient& operator*=(const gradient& b) { return *this = *this * b; }
  gradient& operator/=(const gradient& b) { return *this = *this / b; }

  friend gradient operator-(const gradient& a) { return a.chain(-a.value, Real(-1)); }
  friend gradient operator+(const gradient& a, const gradient& b) {
    return combine(a.value + b.value, a, Real(1), b, Real(1));
  }
  friend gradient operator-(const gradient& a, const gradient& b) {
    return combine(a.value - b.value, a, Real(1), b, Real(-1));
  }
  friend gradient operator*(const gradient& a, const gradient& b) {
    return combine(a.value * b.value, a, b.value, b, a.value);
  }
  friend gradient operator/(const gradient& a, const gradient& b) {
    const Real inverse = Real(1) / b.value, ratio = a.value * inverse;
    return combine(ratio, a, inverse, b, -ratio * inverse);
  }
  friend bool operator==(const gradient& a, const gradient& b) { return a.value == b.value; }
  friend auto operator<=>(const gradient& a, const gradient& b) { return a.value <=> b.value; }

  friend gradient abs(const gradient& a) { return a.value < Real(0) ? -a : a; }
  /// Of a zero, such as a work of adhesion, the root does not depend on what the zero does not depend on.
  friend gradient sqrt(const gradient& a) {
    const Real root = std::sqrt(a.value);
    gradient out = a.chain(root, Real(0.5) / root);
    if (root == Real(0))
      for (std::size_t i = 0; i < N; ++i)
        if (a.slope[i] == Real(0))
          out.slope[i] = Real(0);
    return out;
  }
  friend gradient log(const gradient& a) { return a.chain(std::log(a.value), Real(1) / a.value); }
  friend gradient exp(const gradient& a) {
    const Real power = std::exp(a.value);
    return a.chain(power, power);
  }
  friend gradient sin(const gradient& a) { return a.chain(std::sin(a.value), std::cos(a.value)); }
  friend gradient cos(const gradient& a) { return a.chain(std::cos(a.value), -std::sin(a.value)); }
  friend gradient atan2(const gradient& a, const gradient& b) {
    const Real square_sum = a.value * a.value + b.value * b.value;
    return combine(std::atan2(a.value, b.value), a, b.value / square_sum, b, -a.value / square_sum);
  }
  friend gradient pow(const gradient& a, const gradient& b) {
    const Real power = std::pow(a.value, b.value);
    return combine(power, a, b.value * power / a.value, b, power * std::log(a.value));
  }

  /// A function of this number, by its value and its derivative here.
  gradient chain(const Real& result, const Real& derivative) const {
    gradient out(result);
    for (std::size_t i = 0; i < N; ++i)
      out.slope[i] = derivative * slope[i];
    return out;
  }

private:
  static gradient combine(const Real& result, const gradient& a, const Real& by_a, const gradient& b,
                          const Real& by_b) {
    gradient out(result);
    for (std::size_t i = 0; i < N; ++i)
      out.slope[i] = by_a * a.slope[i] + by_b * b.slope[i];
    return out;
  }
};

template <class Real, std::size_t N>
struct number_traits<gradient<Real, N>> {
  using real = Real;
  static constexpr bool inverts_exactly = number_traits<Real>::inverts_exactly;
  static gradient<Real, N> pi() { return number_traits<Real>::pi(); }
  static gradient<Real, N> euler_gamma() { return number_traits<Real>::euler_gamma(); }
  static Real value(const gradient<Real, N>& x) { return x.value; }
};

template <class T>
inline constexpr bool is_gradient = false;
template <class Real, std::size_t N>
inline constexpr bool is_gradient<gradient<Real, N>> = true;

template <class T>
requires is_gradient<T> T evaluate(const auto& f, const T& x) { return x.chain(f.value(x.value), f.slope(x.value)); }

} // namespace ricochet
