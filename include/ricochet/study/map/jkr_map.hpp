// All pairs of adhesive spheres with a viscous bulk in one map: their restitution depends on two numbers.
#pragma once
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/compose.hpp>
#include <ricochet/study/map/make_family_map.hpp>

namespace ricochet {

/// The two numbers on which e depends for Hertz, JKR and the bulk of Kuwabara & Kono:
/// speed = v/V, V = (w^5 R^4/E*^2)^{1/6}/sqrt(m*), and damping = A V/L, L = (w^2 R/E*^2)^{1/3}. Without damping the
/// pair sticks below speed = 3.766 (closed_form/jkr.hpp).
struct jkr_groups {
  double speed, damping;
};

/// pair: E* (Pa), R (m), m* (kg), all > 0; w: work of adhesion of the pair, J/m^2, > 0; A: bulk_time, s, >= 0; v: speed
/// of approach at touch, m/s, > 0. \throws bad_input naming the first that is not.
inline jkr_groups groups_of(const contact_pair& pair, const jkr& adhesion, const kuwabara_kono& bulk, speed v) {
  validate(pair);
  require("work_of_adhesion", adhesion.work_of_adhesion, positive);
  require("bulk_time", bulk.bulk_time, non_negative);
  require("speed", v, positive);
  const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), w = in_si(adhesion.work_of_adhesion);
  const double neck = w / (E * R), depth = R * std::cbrt(neck * neck); // L
  const double V = std::sqrt(w * R / in_si(pair.reduced_mass) * depth);
  return {in_si(v) / V, in_si(bulk.bulk_time) * V / depth};
}

/// e over both groups: the family of pairs of which V is 1 m/s and L is 1 m, with A = damping as its parameter.
/// \throws bad_input as make_family_map()
inline family_map make_jkr_map(family_map::interval damping, family_map::interval speed,
                               family_map_options options = {}) {
  if (options.about.empty())
    options.about =
        "hertz, jkr and kuwabara_kono of all pairs: v is in units of (w^5 R^4/E*^2)^(1/6)/sqrt(m*), p is A in "
        "units of (w^2 R/E*^2)^(1/3) over that";
  const auto family = [](double p) {
    const contact_pair unit{.reduced_modulus = 1.0 * units::pascals,
                            .reduced_radius = 1.0 * units::metres,
                            .reduced_mass = 1.0 * units::kilograms};
    return compose(unit, hertz{}, jkr{1.0 * units::joules_per_square_metre}, kuwabara_kono{p * units::seconds});
  };
  return make_family_map(family, damping.low, damping.high, speed.low * units::metres_per_second,
                         speed.high * units::metres_per_second, options);
}

/// Restitution of a pair by such a map; NaN where its groups lie outside. \throws bad_input as groups_of()
inline double restitution_by(const family_map& map, const contact_pair& pair, const jkr& adhesion,
                             const kuwabara_kono& bulk, speed v) {
  const jkr_groups at = groups_of(pair, adhesion, bulk, v);
  return map(at.speed, at.damping);
}

} // namespace ricochet
