// In which regime of adhesion and of viscosity a contact lies.
#pragma once
#include <ricochet/closed_form/hertz.hpp>

namespace ricochet::closed_form {

/// Tabor's number: the range of adhesion against the deformation that it makes.
/// mu = (R w^2/(E*^2 z0^3))^{1/3}
/// pair: E* (Pa), R (m), m* (kg), all > 0; w: work of adhesion of the pair, J/m^2, >= 0; z0: interaction_range, m, > 0.
/// JKR is valid for mu > 5, DMT for mu < 0.1, Maugis & Dugdale between.
/// Source: Krijt 2013 (11).
inline double tabor_number(const contact_pair& pair, energy_per_area w, length z0) {
  using boost::units::pow;
  validate(pair);
  require("work_of_adhesion", w, non_negative);
  require("interaction_range", z0, positive);
  return boost::units::root<3>(pow<2>(w / (pair.reduced_modulus * z0)) * pair.reduced_radius / z0);
}

/// Largest relaxation time at which the loss in the bulk is negligible.
/// T_vis < 10^-2 nu^2 t_c
/// poissons_ratio: nu, in (0, 0.5); contact_time: t_c, s, > 0.
/// Valid as an order of magnitude, for A = T_vis/nu^2; F_D/F_E is then below 10^-2.
/// Source: Krijt 2013 (A.2).
inline duration quasi_static_bulk_limit(double poissons_ratio, duration contact_time) {
  require("poissons_ratio", poissons_ratio, range{.high = 0.5, .low_included = false});
  require("contact_time", contact_time, positive);
  return 1e-2 * square(poissons_ratio) * contact_time;
}

/// Largest relaxation time at which the contact edge is static.
/// T_vis < 10^-3 (z0/a)(2 E* z0/w) t_c
/// pair, w > 0, z0: as in tabor_number(); contact_radius: a, m, > 0; contact_time: t_c, s, > 0.
/// Valid as an order of magnitude, with a of the order of the largest; the effective w is then within 1 % of the
/// static. Source: Krijt 2013 (A.4).
inline duration quasi_static_edge_limit(const contact_pair& pair, energy_per_area w, length z0, length contact_radius,
                                        duration contact_time) {
  validate(pair);
  require("work_of_adhesion", w, positive);
  require("interaction_range", z0, positive);
  require("contact_radius", contact_radius, positive);
  require("contact_time", contact_time, positive);
  return 1e-3 * (z0 / contact_radius) * (2.0 * pair.reduced_modulus * z0 / w) * contact_time;
}

} // namespace ricochet::closed_form
