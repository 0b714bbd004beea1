// Boost.Multiprecision's cpp_bin_float as the scalar type, for reference solutions. Expression templates must be off:
// boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>.
#pragma once
#include <ricochet/number.hpp>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace ricochet {

template <unsigned Digits>
using multiprecise =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

template <unsigned Digits>
struct number_traits<multiprecise<Digits>> {
  using real = multiprecise<Digits>;
  static constexpr bool inverts_exactly = true;
  static real pi() { return boost::math::constants::pi<real>(); }
  static real euler_gamma() { return boost::math::constants::euler<real>(); }
  static const real& value(const real& x) { return x; }
};

} // namespace ricochet
