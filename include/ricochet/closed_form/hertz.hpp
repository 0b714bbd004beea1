// Elastic impact of spheres without adhesion.
#pragma once
#include <ricochet/body/pair.hpp>

#include <cmath>

namespace ricochet::closed_form {

namespace detail {

/// \throws bad_input naming quantity, value and range.
inline void validate(const contact_pair& pair, const speed& v) {
  validate(pair);
  require("speed", v, positive);
}

} // namespace detail

/// Largest approach of an elastic impact.
/// delta_max = (15 m* v^2/(16 E* sqrt R))^{2/5}
/// pair: E* (Pa), R (m), m* (kg), all > 0; v: speed of approach at touch, m/s, > 0.
/// Valid without adhesion and losses, for contact radii much below R and speeds much below that of sound.
/// Source: energy balance with Krijt 2013 (5); the length in (33) is sqrt(R delta_max).
inline length max_approach(const contact_pair& pair, speed v) {
  using boost::units::pow;
  detail::validate(pair, v);
  return boost::units::root<5>(pow<2>(15.0 * pair.reduced_mass * v * v / (16.0 * pair.reduced_modulus)) /
                               pair.reduced_radius);
}

/// Largest contact radius of an elastic impact.
/// a_max = sqrt(R delta_max)
/// pair: E* (Pa), R (m), m* (kg), all > 0; v: speed of approach at touch, m/s, > 0.
/// Valid as max_approach(pair, v).
/// Source: Krijt 2013 (4), (33).
inline length max_contact_radius(const contact_pair& pair, speed v) {
  return sqrt(pair.reduced_radius * max_approach(pair, v));
}

/// The factor of contact_time(), 2 sqrt(pi) (15/16)^{2/5} Gamma(7/5)/Gamma(9/10) = 2.8682656992...
inline double contact_time_factor() {
  return 2 * std::sqrt(pi<double>()) * std::pow(15. / 16, 0.4) * std::tgamma(1.4) / std::tgamma(0.9);
}

/// Time in contact of an elastic impact.
/// t_H = 2.8682656992... (m*^2/(R E*^2 v))^{1/5}
/// pair: E* (Pa), R (m), m* (kg), all > 0; v: speed of approach at touch, m/s, > 0.
/// Valid as max_approach(pair, v).
/// Source: Krijt 2013 (22), which prints 2.87; 2 int_0^1 dx/sqrt(1 - x^{5/2}) as a beta function gives all digits.
inline duration contact_time(const contact_pair& pair, speed v) {
  using boost::units::pow;
  detail::validate(pair, v);
  return contact_time_factor() *
         boost::units::root<5>(pow<2>(pair.reduced_mass / pair.reduced_modulus) / (pair.reduced_radius * v));
}

} // namespace ricochet::closed_form
