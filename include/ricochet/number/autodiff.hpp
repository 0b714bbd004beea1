// Forward derivatives through every formula of the library: Boost.Math's fvar<Real, 1> as the scalar type.
#pragma once
#include <ricochet/number.hpp>

#include <boost/math/differentiation/autodiff.hpp>

namespace ricochet {

/// A number with its first derivative with respect to one quantity: `dual<>{...}.derivative(1)`.
template <class Real = double>
using dual = boost::math::differentiation::detail::template fvar<Real, 1>;

template <class Real>
struct number_traits<dual<Real>> {
  using real = Real;
  static constexpr bool inverts_exactly = number_traits<Real>::inverts_exactly;
  static dual<Real> pi() { return dual<Real>(number_traits<Real>::pi()); }
  static dual<Real> euler_gamma() { return dual<Real>(number_traits<Real>::euler_gamma()); }
  static Real value(const dual<Real>& x) { return static_cast<Real>(x); }
};

/// x with derivative one: the quantity with respect to which everything is differentiated.
template <class Real>
dual<Real> seeded(const Real& x) {
  return boost::math::differentiation::make_fvar<Real, 1>(x);
}

template <class T>
requires std::same_as<T, dual<real_of<T>>> T evaluate(const auto& f, const T& x) {
  const real_of<T> at = value_of(x);
  return T(f.value(at)) + T(f.slope(at)) * (x - T(at));
}

} // namespace ricochet
