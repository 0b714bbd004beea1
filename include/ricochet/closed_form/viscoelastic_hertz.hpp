// Impact of viscoelastic spheres (Kuwabara & Kono) where the damping is weak.
#pragma once
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/closed_form/restitution_tables.hpp>

namespace ricochet::closed_form {

namespace detail {

/// C1 = sqrt(pi) Gamma(3/5)/(50^{1/5} Gamma(21/10)) = 1.1534488581..., the slope of the series in y.
inline double weak_damping_slope() {
  return std::sqrt(pi<double>()) * std::tgamma(0.6) / (std::pow(50., 0.2) * std::tgamma(2.1));
}

/// All in SI.
template <class T>
T damping_number(const basic_pair<reduced<T>>& pair, const T& A, const T& v) {
  const T rho_without_root = T(4) / T(3) * T(pair.reduced_modulus) / T(pair.reduced_mass);
  return T(1.5) * A * pow(rho_without_root * rho_without_root * pair.reduced_radius * v, T(0.2));
}

} // namespace detail

/// The one number on which the restitution depends.
/// y = (3/2) A rho^{2/5} v^{1/5}, rho = (4/3) E* sqrt(R)/m*
/// pair: E* (Pa), R (m), m* (kg), all > 0; A: bulk_time, s, >= 0; v: speed of approach at touch, m/s, > 0.
/// Valid without adhesion.
/// Source: Ramirez et al. 1999; Schwager & Poeschel 2008.
inline double damping_number(const contact_pair& pair, duration A, speed v) {
  detail::validate(pair, v);
  require("bulk_time", A, non_negative);
  return detail::damping_number<double>(
      {in_si(pair.reduced_modulus), in_si(pair.reduced_radius), in_si(pair.reduced_mass)}, in_si(A), in_si(v));
}

/// Restitution for weak damping, first order in A.
/// e = 1 - 5.5678109... A/t_H, the number being 1.1534488581 (3/2)(4/3)^{2/5} 2.8682656992
/// pair, A, v: as in damping_number().
/// Valid for A << t_H/6; beyond A = 0.18 t_H it falls below zero, which is no restitution.
/// Source: Krijt 2013 (26), which prints 5.57.
inline double weak_damping_restitution(const contact_pair& pair, duration A, speed v) {
  return 1 - detail::weak_damping_slope() * damping_number(pair, A, v);
}

/// Restitution of a contact that ends where the overlap vanishes, to fourth order in y.
/// e = 1 - 1.1534488581y + 0.7982665609y^2 - 0.5228825681y^3 + 0.34874267y^4
/// y: damping_number(), dimensionless, in [0, 0.5].
/// Valid for small y: too large by about 0.23 y^5, 2e-6 at y = 0.1 and 5e-3 at 0.5.
/// Source: Schwager & Poeschel 2008; their third and fourth coefficients, 0.4836 and 0.2853, do not solve the equation.
inline double restitution_series_to_zero_overlap(double y) {
  require("damping_number", y, range{.high = 0.5, .high_included = true});
  const double c1 = detail::weak_damping_slope();
  return 1 + y * (-c1 + y * (0.6 * c1 * c1 + y * (-0.5228825681 + y * 0.34874267)));
}

/// Largest damping numbers of the two functions below.
inline constexpr double largest_damping_number_to_zero_force = detail::viscoelastic_hertz_to_zero_force.last;
inline constexpr double largest_damping_number_to_zero_overlap = detail::viscoelastic_hertz_to_zero_overlap.last;

/// Restitution of a contact that ends where the force vanishes, at any damping.
/// Polynomials in pieces of ln(1 + sqrt y); error below 1e-15
/// y: damping_number(), dimensionless, in [0, 64]; there e = 0.00127.
/// Valid without adhesion.
/// Source: the equation of Kuwabara & Kono 1987 as Krijt 2013 (19), solved by tests/tables/restitution_tables.cpp.
inline double viscoelastic_restitution_to_zero_force(double y) {
  require("damping_number", y, range{.high = largest_damping_number_to_zero_force, .high_included = true});
  return detail::viscoelastic_hertz_to_zero_force(y);
}

/// Restitution of a contact that ends where the overlap vanishes, at any damping.
/// Polynomials in pieces of ln(1 + y); error below 1e-15
/// y: damping_number(), dimensionless, in [0, 16]; there e = 4.9e-6.
/// Valid without adhesion. Source: as viscoelastic_restitution_to_zero_force().
inline double viscoelastic_restitution_to_zero_overlap(double y) {
  require("damping_number", y, range{.high = largest_damping_number_to_zero_overlap, .high_included = true});
  return detail::viscoelastic_hertz_to_zero_overlap(y);
}

} // namespace ricochet::closed_form
