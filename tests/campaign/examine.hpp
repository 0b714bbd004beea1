// Composes a random scene's laws, solves it and looks at what must hold of every outcome.
#pragma once
#include "instance.hpp"

#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>
#include <ricochet/solve/oblique/oblique.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include "support/greenwood_tables.hpp"

#include <cmath>

namespace campaign {
using namespace ricochet;
using namespace ricochet::units;

// A scene's numbers as laws.

template <class Law>
struct law_of;
template <>
struct law_of<hertz> {
  static constexpr const char* name = "hertz";
  static hertz from(const scene&) { return {}; }
};
template <>
struct law_of<linear> {
  static constexpr const char* name = "linear";
  static linear from(const scene& s) { return {s.stiffness * newtons_per_metre}; }
};
template <>
struct law_of<jkr> {
  static constexpr const char* name = "jkr";
  static jkr from(const scene& s) { return {s.work_of_adhesion * joules_per_square_metre}; }
};
template <>
struct law_of<dmt> {
  static constexpr const char* name = "dmt";
  static dmt from(const scene& s) { return {s.work_of_adhesion * joules_per_square_metre}; }
};
template <>
struct law_of<line_force> {
  static constexpr const char* name = "line_force";
  static line_force from(const scene& s) {
    return {s.force_per_length * newtons_per_metre, s.rebound_coefficient / metres_per_second};
  }
};
template <>
struct law_of<maugis_dugdale> {
  static constexpr const char* name = "maugis_dugdale";
  static maugis_dugdale from(const scene& s) {
    return {s.work_of_adhesion * joules_per_square_metre, s.interaction_range * metres};
  }
};
template <>
struct law_of<greenwood> {
  static constexpr const char* name = "greenwood";
  static greenwood from(const scene& s) {
    return {.relaxation_time = s.relaxation_time * seconds,
            .modulus_ratio = s.modulus_ratio,
            .interaction_range = s.interaction_range * metres,
            .table = support::greenwood_table_for(s.modulus_ratio)};
  }
};
template <>
struct law_of<greenwood_fit> {
  static constexpr const char* name = "greenwood_fit";
  static greenwood_fit from(const scene& s) {
    return {.relaxation_time = s.relaxation_time * seconds, .interaction_range = s.interaction_range * metres};
  }
};
template <>
struct law_of<maugis_barquins> {
  static constexpr const char* name = "maugis_barquins";
  static maugis_barquins from(const scene& s) {
    return {.reference_speed = s.edge_speed * metres_per_second, .exponent = s.edge_exponent};
  }
};
template <>
struct law_of<kuwabara_kono> {
  static constexpr const char* name = "kuwabara_kono";
  static kuwabara_kono from(const scene& s) { return {s.bulk_time * seconds}; }
};
template <>
struct law_of<hunt_crossley> {
  static constexpr const char* name = "hunt_crossley";
  static hunt_crossley from(const scene& s) { return {s.hunt_crossley_coefficient / metres_per_second}; }
};
template <>
struct law_of<tsuji> {
  static constexpr const char* name = "tsuji";
  static tsuji from(const scene& s) { return {s.tsuji_coefficient}; }
};
template <>
struct law_of<linear_dashpot> {
  static constexpr const char* name = "linear_dashpot";
  static linear_dashpot from(const scene& s) { return {s.dashpot_coefficient * newtons / metres_per_second}; }
};
template <>
struct law_of<coulomb> {
  static constexpr const char* name = "coulomb";
  static coulomb from(const scene& s) { return {s.friction_coefficient}; }
};
template <>
struct law_of<coulomb_with_peeling> {
  static constexpr const char* name = "coulomb_with_peeling";
  static coulomb_with_peeling from(const scene& s) {
    return {s.friction_coefficient, s.peeling_moment * newton_metres};
  }
};
template <>
struct law_of<mindlin> {
  static constexpr const char* name = "mindlin";
  static mindlin from(const scene& s) { return {s.friction_coefficient, s.stiffness_ratio}; }
};
template <>
struct law_of<thornton_ning> {
  static constexpr const char* name = "thornton_ning";
  static thornton_ning from(const scene& s) { return {s.yield_strength * pascals}; }
};
template <>
struct law_of<thornton_ning_contact> {
  static constexpr const char* name = "thornton_ning_contact";
  static thornton_ning_contact from(const scene& s) { return {s.yield_strength * pascals}; }
};
template <>
struct law_of<end_at_zero_overlap> {
  static constexpr const char* name = "end_at_zero_overlap";
  static end_at_zero_overlap from(const scene&) { return {}; }
};

template <class... Laws>
auto composed(const scene& s, auto... requests) {
  return compose(s.pair(), law_of<Laws>::from(s)..., requests...);
}

// What must hold.

inline std::string with_value(const char* what, double value) { return std::string(what) + " " + shown(value); }

/// Of the motion along the normal.
template <class Outcome>
finding examined(const Outcome& out, double tolerance) {
  finding f{.ending = out.ending,
            .certain = out.ending_is_certain,
            .restitution = out.restitution,
            .error_estimate = out.error_estimate,
            .ledger_residual = out.ledger_residual,
            .evaluations = out.evaluations,
            .reason = out.reason,
            .wrong = ""};
  if (!f.ended()) {
    f.expect(!out.reason.empty(), "no reason given");
    f.expect(!out.ending_is_certain && out.error_estimate >= tolerance, "passes for solved");
    return f;
  }
  f.expect(out.restitution.has_value() == (out.ending == ending::separated), "restitution and ending disagree");
  const double e = out.restitution.value_or(0);
  f.expect(e >= 0 && e <= 1, with_value("restitution", e));
  f.expect(out.error_estimate >= 0 && std::isfinite(out.error_estimate), with_value("estimate", out.error_estimate));
  f.expect(in_si(out.contact_duration) > 0 && std::isfinite(in_si(out.contact_duration)),
           with_value("duration", in_si(out.contact_duration)));
  // The ledger is promised where the tolerance is met.
  if (out.ending_is_certain && out.error_estimate <= tolerance) {
    f.expect(std::abs(out.ledger_residual) <= tolerance + 1e-10, with_value("ledger residual", out.ledger_residual));
    const double allowed = -tolerance - 1e-10;
    f.expect(out.crack_loss >= allowed, with_value("crack loss", out.crack_loss));
    f.expect(out.bulk_loss >= allowed, with_value("bulk loss", out.bulk_loss));
    if constexpr (requires { out.plastic_loss; })
      f.expect(out.plastic_loss >= allowed, with_value("plastic loss", out.plastic_loss));
    f.expect(!out.restitution || std::abs(out.remaining_energy - e * e) <= 2 * (tolerance + out.error_estimate) + 1e-9,
             with_value("remaining energy", out.remaining_energy) + with_value(" with restitution", e));
  }
  f.expect(std::isfinite(out.ledger_residual) && std::isfinite(out.crack_loss) && std::isfinite(out.bulk_loss) &&
               std::isfinite(out.remaining_energy),
           "a number of the ledger is not finite");
  return f;
}

/// Energy of the motion along the surface: of the slip and of the spins.
inline double surface_energy_of_motion(const contact_pair& pair, double speed, double spin_1, double spin_2) {
  const auto& bodies = pair.bodies;
  const auto of_spin = [](mass m, length r, double spin) {
    return spin == 0 ? 0 : in_si(m) * square(in_si(r) * spin) / 5;
  };
  return in_si(pair.reduced_mass) * square(speed) / 2 + of_spin(bodies.mass_1, bodies.radius_1, spin_1) +
         of_spin(bodies.mass_2, bodies.radius_2, spin_2);
}

template <class Stepper, class... Laws>
finding solve_normal(const scene& s, const collide_options& options) {
  const impact motion{s.speed * metres_per_second};
  const auto model = composed<Laws...>(s, energy_ledger{}, contact_duration{});
  finding f = examined(integrate(model, motion, options, Stepper{}), options.tolerance);
  const auto plain = composed<Laws...>(s);
  if constexpr (closed_form::solved<std::remove_const_t<decltype(plain)>>) {
    const auto closed = collide(plain, motion, options);
    f.expect(!f.ended() || !f.certain || !closed.ending_is_certain ||
                 (closed.ending == f.ending && std::abs(closed.restitution.value_or(0) - f.restitution.value_or(0)) <=
                                                   closed.error_estimate + f.error_estimate + 1e-15),
             with_value("closed form", closed.restitution.value_or(0)) +
                 with_value(" where integration gives", f.restitution.value_or(0)));
  }
  return f;
}

template <class Stepper, class... Laws>
finding solve_oblique(const scene& s, const collide_options& options) {
  const auto model = composed<Laws...>(s, energy_ledger{}, contact_duration{});
  const oblique_impact motion{s.speed * metres_per_second, s.angle, s.spin_1 * radians_per_second,
                              s.spin_2 * radians_per_second};
  const auto out = collide(model, motion, options, Stepper{});
  const double tolerance = options.tolerance;
  finding f = examined(out.normal, tolerance);
  if (!f.ended())
    return f;
  const double before = surface_energy_of_motion(model.pair, s.speed * std::sin(s.angle), s.spin_1, s.spin_2);
  const double after =
      surface_energy_of_motion(model.pair, in_si(out.tangential_speed), in_si(out.spin_1), in_si(out.spin_2));
  const double along_normal = in_si(model.pair.reduced_mass) * square(s.speed * std::cos(s.angle)) / 2;
  double lost = out.friction_loss;
  if constexpr (requires { out.peeling_loss; })
    lost += out.peeling_loss;
  f.expect(std::isfinite(after), "a number of the motion along the surface is not finite");
  if (!(f.certain && f.error_estimate <= tolerance)) // else nothing more is promised
    return f;
  f.expect(out.friction_loss >= -tolerance, with_value("friction loss", out.friction_loss));
  const double allowed = 1e-9 + std::max(tolerance, 2 * out.normal.slip_error_estimate);
  f.expect(std::abs(before - after - lost * along_normal) <= allowed * (before + along_normal),
           with_value("friction leaves an energy of", after) + with_value(" of", before) +
               with_value(" and loses", lost * along_normal));
  f.expect(out.normal_turn >= 0 && std::isfinite(out.normal_turn), with_value("turn of the normal", out.normal_turn));
  return f;
}

/// In the precision of long double, by a stepper of order eight; 0 when captured, nothing where that takes too long.
template <class... Laws>
std::optional<double> reference_restitution(const scene& s) {
  const speed v = s.speed * metres_per_second;
  const auto model = composed<Laws...>(s);
  const scales unit = scales_at(model, v);
  const reduced_model<long double, std::remove_const_t<decltype(model)>> numbers(model, unit);
  collision<std::remove_const_t<decltype(numbers)>, stepper::fehlberg78> solver(numbers, 1e-17L, 1'000'000);
  const auto out = solver.solve(reduce<long double>(v, unit));
  if (out.ending != ending::separated && out.ending != ending::captured)
    return std::nullopt;
  return static_cast<double>(out.restitution.value_or(0));
}

// The list.

template <class... Laws>
std::string joined_names() {
  std::string all;
  ((all += (all.empty() ? "" : "+") + std::string(law_of<Laws>::name)), ...);
  return all;
}

template <class... Laws>
void add_normal(std::vector<instance>& all) {
  all.push_back({joined_names<Laws...>(), solve_normal<stepper::automatic, Laws...>});
}
template <class... Laws>
void add_normal_with_reference(std::vector<instance>& all) {
  add_normal<Laws...>(all);
  all.back().reference = reference_restitution<Laws...>;
}
template <class... Laws>
void add_oblique(std::vector<instance>& all) {
  all.push_back({joined_names<Laws...>(), solve_oblique<stepper::automatic, Laws...>});
}

} // namespace campaign
