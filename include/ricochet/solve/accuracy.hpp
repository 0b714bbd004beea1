// What is known of a collision from two solutions of it.
#pragma once
#include <ricochet/solve/collision.hpp>

namespace ricochet {

/// tolerance: largest error wanted in the restitution, absolute, 1e-12 to 1e-1.
/// max_evaluations: of the equations of motion, for each solution of the collision; spent, the ending is `unresolved`.
struct collide_options {
  double tolerance = 1e-8;
  long max_evaluations = 3'000'000;
};

inline constexpr range tolerance_range{.low = 1e-12, .high = 1e-1, .high_included = true};

namespace detail {

/// Solves at two step tolerances until their difference says that the restitution is known to the tolerance and the
/// ledger, if there is one, closes to it, or until round-off forbids better. The finer solution is the result, the
/// difference the bound of its error; of a ledger that does not close to the tolerance, what it lacks if that is more.
template <class Stepper, class Reduced>
auto solve_to_tolerance(const Reduced& model, const typename Reduced::number& speed,
                        const typename Reduced::number& slip_at_touch, const typename Reduced::number& spin,
                        const collide_options& options) {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using Model = typename Reduced::model_type;
  const real wanted = real(options.tolerance), finest = 4 * std::numeric_limits<real>::epsilon();
  const real refinement = 4, v = value_of(speed), kinetic = v * v * value_of(T(model.pair.reduced_mass)) / 2;
  const real usual_error = real(Stepper::usual_error), loosest = real(Reduced::free_edge ? 5e-5 : 2e-4);
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
    // Long steps err more, all the more at the fold, and most where a free edge decides when to let go.
    const real per_short_step = real(Reduced::adhesive ? 4e6 : 1e5);
    const real of_steps = (Reduced::free_edge ? 2 : 1) * max<real>(1, cbrt(per_short_step * tolerance));
    const real by_chance = of_steps * fine.usual_error() * tolerance / (refinement * v) *
                           sqrt(max<real>(1, fine.largest_energy() / kinetic));
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
      else // the energy decides: e = sqrt(energy left); where nothing pulls, the motion itself
        error = min<real>(energy_error / max<real>(e, std::numeric_limits<real>::min()), sqrt(energy_error));
      if (!Reduced::adhesive && !Reduced::cohesive && !Reduced::attracted && rough.restitution)
        error = min<real>(error, max<real>({abs(e - value_of(*rough.restitution)) * 2, first_leg * 2, 4 * by_chance}) +
                                     round_off);
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
    real unmet = error; // what is to be brought below the tolerance
    if constexpr (Model::asked.ledger)
      unmet = max<real>(unmet, abs(value_of(out.ledger_residual)) - roundings * std::numeric_limits<real>::epsilon());
    if ((unmet <= wanted && out.ending_is_certain) || last_round) {
      if (unmet > wanted) // a ledger that does not close says so too
        out.error_estimate = static_cast<double>(max<real>(error, unmet));
      return out;
    }
    tolerance *= max<real>(real(1e-4), min<real>(real(0.3), wanted / (2 * unmet)));
  }
}

} // namespace detail
} // namespace ricochet
