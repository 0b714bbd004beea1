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

/// One collision solved at two step tolerances. The finer solution is the outcome; its difference to the other is the
/// bound of its error.
template <class Reduced, class Stepper>
class two_solutions {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using Model = typename Reduced::model_type;
  static constexpr int refinement = 4;

public:
  using outcome_type = typename collision<Reduced, Stepper>::outcome_type;

  two_solutions(const Reduced& model, const real& tolerance, long budget, const T& speed, const T& slip, const T& spin)
      : model_(model), tolerance_(tolerance / refinement), speed_(value_of(speed)), coarse_(model, tolerance, budget),
        fine_(model, tolerance_, budget), rough_(coarse_.solve(speed, slip, spin)),
        out_(fine_.solve(speed, slip, spin)) {
    roundings_ = 16 + static_cast<real>(out_.evaluations / 50);
    if (out_.restitution &&
        value_of(*out_.restitution) > real(1)) // losses never are negative: what exceeds one is error
      *out_.restitution -= T(value_of(*out_.restitution) - real(1));
    if (ended()) {
      judge();
      if constexpr (Model::has_friction)
        judge_slip(value_of(slip), value_of(spin));
    } else {
      out_.error_estimate = 1;
      out_.ending_is_certain = false;
    }
    out_.evaluations += rough_.evaluations;
    out_.rejected_steps += rough_.rejected_steps;
  }

  const outcome_type& outcome() const { return out_; }
  bool ended() const { return ended(out_.ending) && ended(rough_.ending); }
  bool certain() const { return out_.ending_is_certain; }
  /// Is the energy's error round-off for the most part, and all that is not met? Closer solutions then tell no more.
  bool limited() const { return limited_ && !(unmet() > real(out_.error_estimate)); }

  /// The error of the restitution, or, if that is more, what the ledger lacks beyond round-off, or by how much a loss
  /// in it is negative.
  real unmet() const {
    real unmet = real(out_.error_estimate);
    if constexpr (Model::asked.ledger)
      unmet = max<real>({unmet, abs(value_of(out_.ledger_residual)) - roundings_ * std::numeric_limits<real>::epsilon(),
                         -value_of(out_.crack_loss), -value_of(out_.bulk_loss)});
    if constexpr (Model::peels)
      unmet = max<real>(unmet, abs(value_of(out_.friction_loss + out_.peeling_loss) -
                                   value_of(rough_.friction_loss + rough_.peeling_loss)));
    return unmet;
  }

private:
  static bool ended(ending e) { return e == ending::separated || e == ending::captured; }

  /// What the energies left of both solutions differ by, captured ones looked at together: one may be certain sooner.
  real difference_of_excess() const {
    if (!out_.restitution && !rough_.restitution && !fine_.margins().empty() && !coarse_.margins().empty()) {
      const std::size_t both = std::min(fine_.margins().size(), coarse_.margins().size()) - 1;
      return abs(fine_.margins()[both] - coarse_.margins()[both]);
    }
    return abs(value_of(fine_.excess_energy() - coarse_.excess_energy()));
  }

  /// Share of the initial energy that errors of both solutions may have in common: they vary in sign and size with the
  /// tolerance, and now and then are the same. Long steps err more at the fold, and all do where damping sets in with
  /// a root of the overlap; a free edge comes to rest and leaves it, by a power law with a kink, too. The factors are
  /// those with which tests/solve/accuracy, run for 20000 scenes of each instance (RICOCHET_SCENES; 4000 with a crack
  /// law), finds no error above its estimate, nor tests/campaign/run --compare-every 1 more than one in 100000.
  real by_chance() const {
    real of_steps = Reduced::damped && (!Reduced::adhesive || Reduced::cohesive) ? 2 : 1;
    if (Reduced::attracted || Reduced::cohesive)
      of_steps *= real(1.5f);
    else if (Reduced::adhesive)
      of_steps *= real(1.25f);
    if constexpr (Reduced::free_edge)
      of_steps = limited_crack_law<decltype(Model::crack)> ? real(1.75f) : real(3);
    if (Reduced::adhesive || Reduced::damped || Reduced::attracted)
      of_steps *= max<real>(1, cbrt(real(4e6f) * refinement * tolerance_));
    return of_steps * fine_.usual_error() * tolerance_ / speed_ *
           sqrt(max<real>(1, fine_.largest_energy() / kinetic()));
  }
  real round_off() const {
    return roundings_ * std::numeric_limits<real>::epsilon() * fine_.largest_energy() / kinetic();
  }
  real kinetic() const { return speed_ * speed_ * value_of(T(model_.pair.reduced_mass)) / 2; }

  /// Sets the error estimate and whether the ending is certain.
  void judge() {
    // The energy at the turning point is compared too, lest errors of the two legs that happen to cancel pass for
    // accuracy.
    const real first_leg = abs(value_of(fine_.energy_at_turning() - coarse_.energy_at_turning())) / kinetic();
    const real of_motion = max<real>({difference_of_excess() / kinetic(), first_leg, by_chance()});
    const real energy_error = of_motion + round_off();
    limited_ = of_motion < round_off() / 4;
    if (out_.restitution) {
      const real error = error_of_restitution(first_leg, energy_error);
      out_.error_estimate = static_cast<double>(error);
      out_.ending_is_certain = rough_.ending == out_.ending && value_of(*out_.restitution) > 2 * error;
    } else { // captured by its energy, and not by a hair's breadth when the edge let go of bodies already approaching
      const real excess = abs(value_of(fine_.excess_energy())) / kinetic();
      const real miss = abs(fine_.near_miss() - coarse_.near_miss()) + round_off();
      out_.error_estimate = excess < 2 * energy_error ? static_cast<double>(min<real>(1, sqrt(energy_error))) : 0;
      out_.ending_is_certain = rough_.ending == out_.ending && excess > 2 * energy_error && !(fine_.near_miss() < miss);
    }
  }

  real error_of_restitution(const real& first_leg, const real& energy_error) const {
    const real e = value_of(*out_.restitution);
    if (Reduced::free_edge && rough_.restitution) // the edge decides when to let go: e passes through zero linearly
      return max<real>({abs(e - value_of(*rough_.restitution)) * 3 / 2, first_leg * 3 / 2,
                        by_chance() / max<real>(e, real(1) / 16)}) +
             round_off();
    const real by_energy = min<real>(energy_error / max<real>(e, std::numeric_limits<real>::min()), sqrt(energy_error));
    if (Reduced::adhesive || Reduced::cohesive || Reduced::attracted || !rough_.restitution)
      return by_energy; // which decides: e = sqrt(energy left)
    const real by_motion =
        max<real>({abs(e - value_of(*rough_.restitution)) * 2, first_leg * 2, 4 * by_chance()}) + round_off();
    return min<real>(by_energy, by_motion); // where nothing pulls, the motion itself tells
  }

  void judge_slip(real size, [[maybe_unused]] const real& spin) {
    real difference = abs(value_of(out_.slip - rough_.slip));
    if constexpr (Model::peels) {
      const real radius = value_of(T(model_.pair.reduced_radius));
      size = max<real>(size, abs(spin) * radius);
      difference = max<real>(difference, abs(value_of(out_.spin - rough_.spin)) * radius);
    }
    if (size > real(0))
      out_.slip_error_estimate += static_cast<double>((difference * 3 / 2 + by_chance() * speed_) / size + round_off());
  }

  const Reduced& model_;
  real tolerance_, speed_;
  collision<Reduced, Stepper> coarse_, fine_;
  outcome_type rough_, out_;
  real roundings_; ///< that add up over the steps, as far as they do
  bool limited_ = false;
};

/// Solves at two step tolerances until their difference says that the restitution is known to the tolerance and the
/// ledger, if there is one, closes to it, or until round-off forbids better; a ledger that does not close says so in
/// the error estimate.
template <class Stepper, class Reduced>
auto solve_to_tolerance(const Reduced& model, const typename Reduced::number& speed,
                        const typename Reduced::number& slip_at_touch, const typename Reduced::number& spin,
                        const collide_options& options) {
  using real = real_of<typename Reduced::number>;
  const real wanted = real(options.tolerance), finest = 4 * std::numeric_limits<real>::epsilon();
  const real usual_error = real(Stepper::usual_error), loosest = real(Reduced::free_edge ? 5e-5 : 2e-4);
  real tolerance =
      min<real>(wanted * max<real>(1, 1 / (25 * usual_error)), loosest) * min<real>(value_of(speed), real(1));
  long evaluations = 0, rejected = 0;
  for (int round = 0;; ++round) {
    tolerance = max(tolerance, finest);
    const two_solutions<Reduced, Stepper> both(model, tolerance, options.max_evaluations, speed, slip_at_touch, spin);
    evaluations += both.outcome().evaluations;
    rejected += both.outcome().rejected_steps;
    const bool met = both.certain() && both.unmet() <= wanted, spent = both.outcome().ending == ending::unresolved;
    const bool closest = tolerance <= finest || both.limited();
    if (met || spent || closest || round == 6) {
      auto out = both.outcome();
      out.evaluations = evaluations;
      out.rejected_steps = rejected;
      if (both.ended() && both.unmet() > wanted)
        out.error_estimate = static_cast<double>(both.unmet());
      return out;
    }
    tolerance *= both.ended() ? max<real>(real(1e-4), min<real>(real(0.3), wanted / (2 * both.unmet()))) : real(1e-2);
  }
}

} // namespace detail
} // namespace ricochet
