#pragma once
#include <ricochet/closed_form/closed_outcome.hpp>
#include <ricochet/model/regime.hpp>
#include <ricochet/solve/automatic.hpp>
#include <ricochet/solve/collision.hpp>
#include <ricochet/solve/yielding.hpp>

namespace ricochet {

/// An impact as the contact sees it. speed: of approach at first touch, > 0. slip: speed at which the contact point
/// slides then, >= 0; needs a tangential law. spin: of a sphere with a peeling moment, which alone makes it matter; > 0
/// where it would roll along the slip. oblique.hpp has impacts by angle, velocity and spin.
struct impact {
  ricochet::speed speed;
  ricochet::speed slip{};
  angular_speed spin{};
};

/// tolerance: largest error wanted in the restitution, absolute, 1e-12 to 1e-1.
/// max_evaluations: of the equations of motion, for each solution of the collision; spent, the ending is `unresolved`.
struct collide_options {
  double tolerance = 1e-8;
  long max_evaluations = 3'000'000;
};

inline constexpr range tolerance_range{.low = 1e-12, .high = 1e-1, .high_included = true};

namespace detail {

/// Solves at two step tolerances until their difference says that the restitution is known to the tolerance, or until
/// round-off forbids better. The finer solution is the result, the difference the bound of its error.
template <class Stepper, class Reduced>
auto solve_to_tolerance(const Reduced& model, const typename Reduced::number& speed,
                        const typename Reduced::number& slip_at_touch, const typename Reduced::number& spin,
                        const collide_options& options) {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using Model = typename Reduced::model_type;
  const real wanted = real(options.tolerance), finest = 4 * std::numeric_limits<real>::epsilon();
  const real refinement = 4, v = value_of(speed), kinetic = v * v * value_of(T(model.pair.reduced_mass)) / 2;
  const real usual_error = real(Stepper::usual_error), loosest = real(Reduced::free_edge ? 1e-6 : 1e-5);
  real tolerance = min<real>(wanted * max<real>(1, 1 / (25 * usual_error)), loosest) * min<real>(v, real(1));
  long evaluations = 0, rejected = 0;
  for (int round = 0;; ++round) {
    tolerance = max(tolerance, finest);
    collision<Reduced, Stepper> coarse(model, tolerance, options.max_evaluations),
        fine(model, tolerance / refinement, options.max_evaluations);
    const auto rough = coarse.solve(speed, slip_at_touch, spin);
    auto out = fine.solve(speed, slip_at_touch, spin);
    const long fine_evaluations = out.evaluations;
    out.evaluations = evaluations += rough.evaluations + out.evaluations;
    out.rejected_steps = rejected += rough.rejected_steps + out.rejected_steps;
    const bool last_round = tolerance <= finest || round == 6;
    const auto ended = [](ending e) { return e == ending::separated || e == ending::captured; };
    if (!ended(out.ending) || !ended(rough.ending)) {
      out.error_estimate = 1;
      out.ending_is_certain = false;
      if (last_round || out.ending == ending::unresolved)
        return out;
      tolerance *= real(1e-2);
      continue;
    }
    // Error of the energy left, in units of the initial one. The energy at the turning point is compared too, lest
    // errors of the two legs that happen to cancel pass for accuracy.
    const real roundings =
        16 + static_cast<real>(fine_evaluations / 50); // that add up over the steps, as far as they do
    const real round_off = roundings * std::numeric_limits<real>::epsilon() * fine.largest_energy() / kinetic;
    const real first_leg = abs(value_of(fine.energy_at_turning() - coarse.energy_at_turning())) / kinetic;
    const real excess = abs(value_of(fine.excess_energy())) / kinetic;
    // The errors of both solutions vary in sign and size with the tolerance, and now and then are the same by chance.
    const real by_chance =
        usual_error * tolerance / (refinement * v) * sqrt(max<real>(1, fine.largest_energy() / kinetic));
    real last_difference = abs(value_of(fine.excess_energy() - coarse.excess_energy()));
    if (!out.restitution && !rough.restitution && !fine.margins().empty() && !coarse.margins().empty()) {
      const std::size_t both = std::min(fine.margins().size(), coarse.margins().size()) - 1; // captured later or sooner
      last_difference = abs(fine.margins()[both] - coarse.margins()[both]);
    }
    const real energy_error = max<real>({last_difference / kinetic, first_leg, by_chance}) + round_off;
    real error = 0;
    if (out.restitution) {
      if (value_of(*out.restitution) > real(1)) // losses never are negative: what exceeds one is error
        *out.restitution -= T(value_of(*out.restitution) - real(1));
      const real e = value_of(*out.restitution);
      if (Reduced::free_edge && rough.restitution) // the edge decides when to let go: e passes through zero linearly
        error = max<real>({abs(e - value_of(*rough.restitution)) * 3 / 2, first_leg * 3 / 2,
                           by_chance / max<real>(e, real(1) / 16)}) +
                round_off;
      else // the energy decides: e = sqrt(energy left)
        error = min<real>(energy_error / max<real>(e, std::numeric_limits<real>::min()), sqrt(energy_error));
    } else if (excess < 2 * energy_error) {
      error = sqrt(energy_error);
    }
    out.ending_is_certain = rough.ending == out.ending;
    if (out.restitution) {
      out.ending_is_certain &= value_of(*out.restitution) > 2 * error;
    } else { // captured by its energy, and not by a hair's breadth when the edge let go of bodies already approaching
      const real miss = abs(fine.near_miss() - coarse.near_miss()) + round_off;
      out.ending_is_certain &= excess > 2 * energy_error && !(fine.near_miss() < miss);
    }
    out.error_estimate = static_cast<double>(error);
    if constexpr (Model::has_friction) {
      real size = value_of(slip_at_touch), difference = abs(value_of(out.slip - rough.slip));
      if constexpr (Model::peels) {
        const real radius = value_of(T(model.pair.reduced_radius));
        size = max<real>(size, abs(value_of(spin)) * radius);
        difference = max<real>(difference, abs(value_of(out.spin - rough.spin)) * radius);
      }
      if (size > real(0))
        out.slip_error_estimate += static_cast<double>((difference * 3 / 2 + by_chance * v) / size + round_off);
    }
    if ((error <= wanted && out.ending_is_certain) || last_round)
      return out;
    tolerance *= max<real>(real(1e-4), min<real>(real(0.3), wanted / (2 * error)));
  }
}

template <class Model>
outcome_of<Model> in_si_units(const reduced_outcome_of<double, Model>& numbers, const scales& unit) {
  outcome_of<Model> out;
  out.ending = numbers.ending;
  out.restitution = numbers.restitution;
  out.ending_is_certain = numbers.ending_is_certain;
  out.error_estimate = numbers.error_estimate;
  out.contacts = numbers.contacts;
  out.evaluations = numbers.evaluations;
  out.rejected_steps = numbers.rejected_steps;
  out.reason = numbers.reason;
  if constexpr (Model::asked.ledger)
    static_cast<ledger_result<double>&>(out) = numbers;
  if constexpr (Model::asked.duration)
    out.contact_duration = numbers.contact_duration * unit.duration * units::seconds;
  if constexpr (Model::asked.extremes) {
    const double newton = unit.factor(force{});
    out.max_approach = numbers.max_approach * unit.length * units::metres;
    out.max_contact_radius = numbers.max_contact_radius * unit.length * units::metres;
    out.max_tension = numbers.max_tension * newton * units::newtons;
    out.max_compression = numbers.max_compression * newton * units::newtons;
  }
  if constexpr (Model::flows) {
    out.plastic_loss = numbers.plastic_loss;
    out.residual_approach = numbers.residual_approach * unit.length * units::metres;
  }
  if constexpr (Model::has_friction) {
    const double metre_per_second = unit.length / unit.duration;
    out.slip = numbers.slip * metre_per_second * units::metres_per_second;
    out.slip_error_estimate = numbers.slip_error_estimate;
    out.sticks = numbers.sticks;
    out.slip_distance = numbers.slip_distance * unit.length * units::metres;
    out.elapsed_time = numbers.elapsed_time * unit.duration * units::seconds;
    out.approach_rate = numbers.approach_rate * metre_per_second * units::metres_per_second;
  }
  if constexpr (Model::peels) {
    out.spin = numbers.spin / unit.duration * units::radians_per_second;
    out.rotation = numbers.rotation;
    out.friction_loss = numbers.friction_loss;
    out.peeling_loss = numbers.peeling_loss;
  }
  if constexpr (Model::asked.trajectory) {
    out.trajectory = numbers.trajectory;
    const auto scale = [](std::vector<double>& column, double factor) {
      for (double& x : column)
        x *= factor;
    };
    const double newton = unit.factor(force{}), joule = unit.factor(energy{});
    auto& t = out.trajectory;
    scale(t.time, unit.duration);
    scale(t.mutual_approach, unit.length);
    scale(t.approach_rate, unit.length / unit.duration);
    scale(t.contact_radius, unit.length);
    scale(t.elastic_force, newton);
    scale(t.damping_force, newton);
    for (auto* column : {&t.kinetic_energy, &t.elastic_energy, &t.surface_energy, &t.crack_loss, &t.bulk_loss})
      scale(*column, joule);
    if constexpr (Model::flows)
      scale(t.plastic_loss, joule);
  }
  return out;
}

/// An edge of infinite speed, or of no energy, is a static one.
template <class Model>
bool edge_is_static(const Model& model) {
  if constexpr (requires { model.crack.relaxation_time; })
    if (in_si(model.crack.relaxation_time) == 0)
      return true;
  return in_si(model.adhesion.work_of_adhesion) == 0;
}

/// The outcome, with warnings where the model asks for them.
template <class Model>
outcome_of<Model> warned(const Model& model, speed v, outcome_of<Model> out) {
  if constexpr (Model::asked.warnings)
    out.warnings = regime_of(model, v).warnings();
  return out;
}

template <class Model>
void admit(const impact& impact, const collide_options& options) {
  require("speed", impact.speed, positive);
  require("tolerance", options.tolerance, tolerance_range);
  require("slip", impact.slip, non_negative);
  if (!Model::has_friction && in_si(impact.slip) != 0)
    throw bad_input("slip = " + shown(in_si(impact.slip)) + " m/s needs a tangential law in the model: add coulomb");
  require("spin", impact.spin, any_finite);
  if (!Model::peels && in_si(impact.spin) != 0)
    throw bad_input("spin = " + shown(in_si(impact.spin)) +
                    " rad/s needs a peeling moment in the model: without one, the slip says all");
}

} // namespace detail

/// What comes of this impact: ending, restitution and what compose() was asked for, by integration with the given
/// stepper (solve/stepper.hpp), stepper::automatic unless another is wanted.
/// \throws bad_input if speed is not positive and finite or the tolerance is outside [1e-12, 1e-1].
template <class Stepper = stepper::automatic, class Model>
auto integrate(const Model& model, const impact& impact, const collide_options& options = {}, Stepper = {}) {
  detail::admit<Model>(impact, options);
  if constexpr (Model::yields)
    return detail::warned(model, impact.speed,
                          detail::with_plastic_loss(model, impact.speed,
                                                    integrate(model.without_plasticity(), impact, options, Stepper{})));
  else {
    if constexpr (Model::has_crack_law)
      if (detail::edge_is_static(model))
        return detail::warned<Model>(model, impact.speed,
                                     integrate(model.with_static_edge(), impact, options, Stepper{}));
    const scales unit = scales_at(model, impact.speed);
    const reduced_model<double, Model> numbers(model, unit);
    const auto found = detail::solve_to_tolerance<Stepper>(numbers, reduce<double>(impact.speed, unit),
                                                           reduce<double>(impact.slip, unit),
                                                           reduce<double>(impact.spin, unit), options);
    return detail::warned(model, impact.speed, detail::in_si_units<Model>(found, unit));
  }
}

/// What comes of this impact: from the closed form where one gives all that is asked for, else by integrate().
/// \throws bad_input as integrate().
template <class Model>
auto collide(const Model& model, const impact& impact, const collide_options& options = {}) {
  if constexpr (Model::yields) {
    return detail::warned(
        model, impact.speed,
        detail::with_plastic_loss(model, impact.speed, collide(model.without_plasticity(), impact, options)));
  } else if constexpr (closed_form::solved<Model>) {
    detail::admit<Model>(impact, options);
    if (auto out = closed_form::solve(model, impact.speed))
      return detail::warned(model, impact.speed, std::move(*out));
    return integrate(model, impact, options);
  } else {
    return integrate(model, impact, options);
  }
}

/// The same with a stepper of the caller's choice; always by integration.
template <class Model, class Stepper>
auto collide(const Model& model, const impact& impact, const collide_options& options, Stepper stepper) {
  return integrate(model, impact, options, stepper);
}

} // namespace ricochet
