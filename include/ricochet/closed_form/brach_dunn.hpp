// The groups of Brach & Dunn's simulation.
#pragma once
#include <ricochet/body/pair.hpp>

namespace ricochet::closed_form {

/// Damping coefficient that a damping ratio stands for.
/// c = zeta (m/(R^3 K v^{1/2}))^{2/5}, K = (4/3)E*
/// zeta: zeta_H of the Hertzian force or zeta_A of the ring force, >= 0; pair: E* (Pa), R (m), m* (kg); v: speed of the
/// impact, m/s, > 0. Valid for any; the coefficient depends on the speed. Source: Brach & Dunn 1995 (B6), where the
/// exponent is printed as 5/2.
inline inverse_speed damping_coefficient_of_brach_dunn(double zeta, const contact_pair& pair, speed v) {
  require("damping ratio", zeta, non_negative);
  require("speed", v, positive);
  const double stiffness = 4. / 3 * in_si(pair.reduced_modulus);
  const double group = in_si(pair.reduced_mass) / (cube(in_si(pair.reduced_radius)) * stiffness * std::sqrt(in_si(v)));
  return required("damping_coefficient", inverse_speed(zeta * std::pow(group, 0.4) * units::seconds_per_metre),
                  non_negative);
}

/// Depth at which ring force and Hertzian force balance.
/// delta = 2 pi f_0/K, K = (4/3)E*
/// pair: E* (Pa); force_per_length: f_0, N/m, >= 0. Valid for contact radii well below R.
/// Source: Brach & Dunn 1995, appendix B.
inline length equilibrium_depth(const contact_pair& pair, energy_per_area force_per_length) {
  require("force_per_length", force_per_length, non_negative);
  return 1.5 * pi<double>() * force_per_length / pair.reduced_modulus;
}

} // namespace ricochet::closed_form
