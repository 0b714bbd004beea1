// Brach & Dunn's way from measured restitutions to the damping of their simulation.
#pragma once
#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/closed_form/hunt_crossley.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/compose.hpp>
#include <ricochet/solve/collide.hpp>

#include <boost/math/tools/toms748_solve.hpp>

namespace ricochet {

/// Laws of the simulation as fitted, and their damping ratios at the speed of the fit.
struct brach_dunn_fit {
  double zeta_h, zeta_a;
  ricochet::hunt_crossley damping;
  ricochet::line_force adhesion;
};

/// One after the other [Brach & Dunn 1995, section on the dynamical simulation]: without adhesion, the damping of the
/// body is what gives the restitution R of the material alone; with it and the ring force, the damping of the rebound
/// is what gives the restitution measured. pair: a sphere and a wall, or two spheres; v: speed of the impact, m/s, > 0;
/// force_per_length: f_0, N/m, > 0; material_restitution: R, 0 < R <= 1; restitution: e, 0 < e < 1, both of that speed.
/// relative error of both ratios: 1e-8 over the slope of e. \throws bad_input naming what is out of range; where the
/// ring force alone takes more than was measured, the restitution that it leaves
inline brach_dunn_fit fit_brach_dunn(const contact_pair& pair, speed v, energy_per_area force_per_length,
                                     double material_restitution, double restitution) {
  require("speed", v, positive);
  require("force_per_length", force_per_length, positive);
  require("material_restitution", material_restitution, range{.high = 1, .low_included = false, .high_included = true});
  require("restitution", restitution, range{.high = 1, .low_included = false});
  const double unit_h = in_si(closed_form::damping_coefficient_of_brach_dunn(1, pair, v));
  const auto root_above = [](const auto& excess, double first) { // of a function that falls from zero on
    double low = 0, high = first, at_low = excess(0), at_high = excess(high);
    for (; at_high > 0; high *= 4) {
      low = high;
      at_low = at_high;
      at_high = excess(4 * high);
    }
    std::uintmax_t rounds = 100;
    const auto close = [](double a, double b) { return std::abs(b - a) <= 1e-12 * b; };
    const auto bracket = boost::math::tools::toms748_solve(excess, low, high, at_low, at_high, close, rounds);
    return (bracket.first + bracket.second) / 2;
  };

  brach_dunn_fit found{0, 0, {}, {.force_per_length = force_per_length}};
  if (material_restitution < 1)
    found.zeta_h = root_above(
        [&](double zeta) {
          return closed_form::restitution(zeta * unit_h * units::seconds_per_metre, v) - material_restitution;
        },
        1);
  found.damping.damping_coefficient = found.zeta_h * unit_h * units::seconds_per_metre;

  const auto with = [&](double zeta) {
    found.adhesion.rebound_coefficient = zeta * unit_h * units::seconds_per_metre;
    const auto out = collide(compose(pair, hertz{}, found.adhesion, found.damping), impact{v}, {.tolerance = 1e-10});
    if (out.ending != ending::separated && out.ending != ending::captured)
      throw bad_input("fit_brach_dunn: the collision with zeta_A = " + shown(zeta) + " ended " + name_of(out.ending) +
                      ": " + out.reason);
    return out.restitution.value_or(0) - restitution;
  };
  const double without = with(0);
  if (without <= -restitution)
    throw bad_input("force_per_length = " + shown(in_si(force_per_length)) +
                    " N/m: the pair sticks without any damping of the rebound, where restitution = " +
                    shown(restitution) + " was measured");
  if (without < -1e-9)
    throw bad_input("restitution = " + shown(restitution) + " is outside (0, " + shown(without + restitution) +
                    "]: that much is left without damping of the rebound");
  found.zeta_a = without <= 1e-9 ? 0 : root_above(with, 1); // the collisions' errors are smaller
  found.adhesion.rebound_coefficient = found.zeta_a * unit_h * units::seconds_per_metre;
  return found;
}

} // namespace ricochet
