#pragma once
#include <ricochet/solve/collision.hpp>

namespace ricochet {

/// A head-on impact. speed: of approach at first touch, > 0.
struct impact {
  ricochet::speed speed;
};

/// tolerance: largest error wanted in the restitution, absolute, 1e-12 to 1e-1.
/// max_evaluations: of the equations of motion, for each solution of the collision; spent, the ending is `unresolved`.
struct collide_options {
  double tolerance = 1e-8;
  long max_evaluations = 1'000'000;
};

inline constexpr range tolerance_range{.low = 1e-12, .high = 1e-1, .high_included = true};

namespace detail {

/// Solves at two step tolerances until their difference says that the restitution is known to the tolerance, or until
/// round-off forbids better. The finer solution is the result, the difference the bound of its error.
template <class Stepper, class Reduced>
auto solve_to_tolerance(const Reduced& model, const typename Reduced::number& speed, const collide_options& options) {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using std::abs;
  using std::max;
  using std::min;
  using std::sqrt;
  const real wanted = real(options.tolerance), finest = 4 * std::numeric_limits<real>::epsilon();
  const real refinement = 16, v = value_of(speed), kinetic = v * v * value_of(model.pair.reduced_mass) / 2;
  real tolerance = min<real>(wanted, real(1e-3)) * min<real>(v, real(1)) / 10;
  long evaluations = 0, rejected = 0;
  for (int round = 0;; ++round) {
    tolerance = max(tolerance, finest);
    collision<Reduced, Stepper> coarse(model, tolerance, options.max_evaluations),
        fine(model, tolerance / refinement, options.max_evaluations);
    const auto rough = coarse.solve(speed);
    auto out = fine.solve(speed);
    evaluations += rough.evaluations + out.evaluations;
    rejected += rough.rejected_steps + out.rejected_steps;
    out.evaluations = evaluations;
    out.rejected_steps = rejected;
    if (out.ending == ending::failed || out.ending == ending::unresolved || rough.ending == ending::failed ||
        rough.ending == ending::unresolved) {
      out.error_estimate = 1;
      out.ending_is_certain = false;
      return out;
    }
    // Error of the energy left, in units of the initial one; e = sqrt(energy left).
    const real energy_error = abs(value_of(fine.remaining_energy()) - value_of(coarse.remaining_energy())) / kinetic +
                              32 * std::numeric_limits<real>::epsilon() * fine.largest_energy() / kinetic;
    const real margin = abs(value_of(fine.remaining_energy()) - value_of(model.exit_energy())) / kinetic;
    real error = 0;
    if (out.restitution) {
      const real e = value_of(*out.restitution);
      error = min<real>(energy_error / max<real>(e, std::numeric_limits<real>::min()), sqrt(energy_error));
    } else if (margin < energy_error) {
      error = sqrt(energy_error);
    }
    out.ending_is_certain = rough.ending == out.ending && (out.restitution.has_value() || margin > energy_error);
    out.error_estimate = static_cast<double>(error);
    if ((error <= wanted && out.ending_is_certain) || tolerance <= finest || round == 6)
      return out;
    tolerance *= max<real>(real(1e-4), min<real>(real(0.3), wanted / (2 * error)));
  }
}

template <requests Asked>
outcome<Asked> in_si_units(const reduced_outcome<double, Asked>& numbers, const scales& unit) {
  outcome<Asked> out;
  out.ending = numbers.ending;
  out.restitution = numbers.restitution;
  out.ending_is_certain = numbers.ending_is_certain;
  out.error_estimate = numbers.error_estimate;
  out.contacts = numbers.contacts;
  out.evaluations = numbers.evaluations;
  out.rejected_steps = numbers.rejected_steps;
  out.reason = numbers.reason;
  if constexpr (Asked.ledger)
    static_cast<ledger_result<double>&>(out) = numbers;
  if constexpr (Asked.duration)
    out.contact_duration = numbers.contact_duration * unit.duration * units::seconds;
  if constexpr (Asked.extremes) {
    const double newton = unit.factor(force{});
    out.max_approach = numbers.max_approach * unit.length * units::metres;
    out.max_contact_radius = numbers.max_contact_radius * unit.length * units::metres;
    out.max_tension = numbers.max_tension * newton * units::newtons;
    out.max_compression = numbers.max_compression * newton * units::newtons;
  }
  if constexpr (Asked.trajectory) {
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
  }
  return out;
}

} // namespace detail

/// What comes of this impact: ending, restitution and what compose() was asked for, by integration with the given
/// stepper (solve/stepper.hpp), stepper::automatic unless another is wanted.
/// \throws bad_input if speed is not positive and finite or the tolerance is outside [1e-12, 1e-1].
template <class Stepper = stepper::automatic, class Model>
auto integrate(const Model& model, const impact& impact, const collide_options& options = {}, Stepper = {}) {
  require("speed", impact.speed, positive);
  require("tolerance", options.tolerance, tolerance_range);
  if constexpr (Model::has_crack_law) // an edge of infinite speed, or of no energy, is a static one
    if (in_si(model.crack.relaxation_time) == 0 || in_si(model.adhesion.work_of_adhesion) == 0)
      return integrate(model.with_static_edge(), impact, options, Stepper{});
  const scales unit = model.scales_at(impact.speed);
  const reduced_model<double, Model> numbers(model, unit);
  return detail::in_si_units<Model::asked>(
      detail::solve_to_tolerance<Stepper>(numbers, reduce<double>(impact.speed, unit), options), unit);
}

} // namespace ricochet
