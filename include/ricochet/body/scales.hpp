#pragma once
#include <ricochet/body/pair.hpp>

namespace ricochet {

namespace detail {
/// x to the power Twice/2.
template <int Twice, class T>
T halves(const T& x) {
  if constexpr (Twice < 0)
    return T(1) / halves<-Twice>(x);
  else if constexpr (Twice == 0)
    return T(1);
  else if constexpr (Twice == 1)
    return sqrt(x);
  else
    return Twice == 2 ? x : T(x * halves<Twice - 2>(x));
}
} // namespace detail

/// Units of length, time and mass in which a collision is computed, in SI. Chosen so that mass, speed, approach and
/// force are of order one whatever the scene.
template <class T>
struct basic_scales {
  T length = T(1);
  T duration = T(1);
  T mass = T(1);

  /// SI value of one reduced unit of the quantity's dimension.
  template <class Quantity>
  T factor(const Quantity&) const {
    static constexpr exponents e = exponents_of(Quantity{});
    return detail::halves<int(2 * e.length)>(length) * detail::halves<int(2 * e.mass)>(mass) *
           detail::halves<int(2 * e.time)>(duration);
  }
};
using scales = basic_scales<double>;
/// Scales of an impact at speed v under work of adhesion w (zero where there is none): the larger of v and the speed
/// that adhesion gives, (w^5 R^4/E*^2)^{1/6} m*^{-1/2}, and the Hertzian approach belonging to it. All in SI.
template <class T>
basic_scales<T> scales_of(const basic_pair<reduced<T>>& pair, const T& v, const T& w) {
  const T E = pair.reduced_modulus, R = pair.reduced_radius, m = pair.reduced_mass;
  const T adhesive = cube_root(w * R * R / E) * sqrt(w / m);
  const T fastest = max(v, adhesive);
  const T approach = pow(m * fastest * fastest / (E * sqrt(R)), T(0.4));
  return {.length = approach, .duration = approach / fastest, .mass = m};
}
inline scales scales_of(const contact_pair& pair, speed v, energy_per_area w) {
  return scales_of<double>({in_si(pair.reduced_modulus), in_si(pair.reduced_radius), in_si(pair.reduced_mass)},
                           in_si(v), in_si(w));
}

template <class T, class Quantity>
T reduce(const Quantity& quantity, const scales& unit) {
  return T(in_si(quantity)) / T(unit.factor(quantity));
}

} // namespace ricochet
