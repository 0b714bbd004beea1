#pragma once
#include <ricochet/batch/lane_laws.hpp>
#include <ricochet/solve/collide.hpp>

#include <bit>
#include <optional>

namespace ricochet {

/// A model whose collisions can run side by side: the edge is slaved to the approach, so that all lanes go through the
/// same formulas, and nothing is asked that has to be watched step by step.
template <class Model>
inline constexpr bool runs_in_lanes =
    !Model::has_crack_law && !Model::cohesive && !Model::has_friction && !Model::yields && !Model::flows &&
    !Model::asked.ledger && !Model::asked.duration && !Model::asked.extremes && !Model::asked.trajectory;

/// How one solution of a collision ended; energies in units of the initial kinetic energy.
enum class lane_fate { let_go, captured, set_aside };
struct lane_solution {
  lane_fate fate;
  double restitution;
  double excess;         ///< energy beyond what the contact has where it lets go; of separated bodies all of it
  double largest_energy; ///< that was met
  int steps;
};

/// What is solved: a collision's laws in SI, its speed in m/s, and its step tolerance in units of the speed.
template <class Model>
struct lane_task {
  reduced_laws<double, Model> laws;
  double speed = 0, tolerance = 0;
};

/// Solves collisions side by side, each lane with its own step, error and events; a lane that has finished takes the
/// next task, and none ever sees another. Whoever is too slow, or leaves the domain of the formulas, is set aside.
template <class Model, class Lanes>
class lane_solver {
  using reduced_type = reduced_model<Lanes, Model>;
  using state_type = typename reduced_type::state_type;
  using stepper_type = stepper::explicit_pair<stepper::tsitouras_papakostas75_table, state_type, Lanes>;
  using mask = typename Lanes::mask;
  using part = configuration<reduced<Lanes>>;
  static constexpr bool pulled = Model::adhesive || Model::attracted;
  static constexpr bool ends_without_force =
      !pulled && Model::damped && std::same_as<typename Model::end_condition, end_at_zero_force>;
  static constexpr bool kinks_at_turning = Model::attracted; ///< where it may begin to oppose the rebound

public:
  static constexpr int evaluations_a_step = int(stepper::tsitouras_papakostas75_table::stages);

  /// Of `model` only the quantities' dimensions count, and what its type says. Set aside is what takes more evaluations
  /// than given, or many more than lanes are good for.
  lane_solver(const Model& model, long max_evaluations)
      : model_(model),
        most_steps_(double(std::min(max_evaluations / evaluations_a_step, 1000L))), now_{.model = reduced_type(
                                                                                             laws_in_si<Lanes>(model))},
        staged_(now_) {}

  /// `task_of(i)` gives the task i < count; `finished(i, lane_solution)` is told its solution, in no certain order.
  template <class TaskOf, class Finished>
  void solve(std::size_t count, const TaskOf& task_of, const Finished& finished) {
    std::size_t next = 0, staged_from = 0, staged = 0;
    std::array<std::size_t, Lanes::size> task;
    std::uint64_t busy = 0;
    const auto refill = [&](std::size_t lane) {
      if (next == count)
        return false;
      if (next == staged_from + staged) {
        staged_from = next;
        staged = std::min(Lanes::size, count - next);
        stage(staged, [&](std::size_t i) { return task_of(staged_from + i); });
      }
      copy_lane<Lanes>(now_, lane, staged_, next - staged_from);
      task[lane] = next++;
      return true;
    };
    for (std::size_t lane = 0; lane < Lanes::size && refill(lane); ++lane)
      busy |= std::uint64_t(1) << lane;
    for (std::size_t lane = std::size_t(std::popcount(busy)); lane < Lanes::size; ++lane)
      copy_lane<Lanes>(now_, lane, staged_, 0);
    while (busy) {
      const auto [let_go, captured, aside] = step();
      for (std::uint64_t done = (let_go | captured | aside) & busy; done; done &= done - 1) {
        const std::size_t lane = std::size_t(std::countr_zero(done));
        const std::uint64_t bit = std::uint64_t(1) << lane;
        const lane_fate fate = aside & bit      ? lane_fate::set_aside
                               : captured & bit ? lane_fate::captured
                                                : lane_fate::let_go;
        const double speed = now_.speed[lane], kinetic = now_.model.kinetic_energy(now_.speed)[lane];
        finished(task[lane], lane_solution{fate, -end_rate_[lane] / speed, excess_[lane] / kinetic,
                                           now_.largest_energy[lane] / kinetic, int(now_.steps[lane])});
        if (!refill(lane))
          busy &= ~bit;
      }
    }
  }

private:
  /// All that is known of the solutions under way. Lanes only, so that single lanes can be copied.
  struct course {
    reduced_type model;
    state_type x{}, per_error{};   ///< per_error: one over the error allowed in a step
    Lanes h{}, longest{}, close{}; ///< close: to an event, from where one Newton step leads there
    Lanes end{};                   ///< coordinate where a slaved edge lets go
    Lanes speed{}, has_turned{}, largest_energy{}, steps{};
  };

  template <class TaskOf>
  void stage(std::size_t count, const TaskOf& task_of) {
    Lanes speed, tolerance;
    reduced_laws<Lanes, Model> laws = laws_in_si<Lanes>(model_);
    for (std::size_t lane = 0; lane < Lanes::size; ++lane) {
      const auto task = task_of(std::min(lane, count - 1));
      put_lane(laws, lane, task.laws);
      speed.put(lane, task.speed);
      tolerance.put(lane, task.tolerance);
    }
    const auto unit = laws.scales_at(speed);
    staged_.model = reduced_type(in_scales(laws, model_, unit));
    const reduced_type& m = staged_.model;
    const Lanes v = speed * unit.duration / unit.length;
    tolerance = max(tolerance * min(v, Lanes(1)), Lanes(4 * std::numeric_limits<double>::epsilon()));
    staged_.speed = v;
    staged_.x = m.touch(v);
    const state_type typical = m.typical();
    for (std::size_t i = 0; i < typical.size(); ++i)
      staged_.per_error[i] = Lanes(1) / (typical[i] * tolerance);
    staged_.longest = typical[m.coordinate] * min(Lanes(1), Lanes(2) * sqrt(sqrt(sqrt(tolerance))));
    staged_.h = staged_.longest / Lanes(8);
    staged_.close = staged_.longest * sqrt(tolerance) / Lanes(64);
    staged_.has_turned = staged_.steps = Lanes(0);
    if constexpr (Model::adhesive)
      staged_.end = m.fold_coordinate();
    else
      staged_.end = Lanes(0);
    const Lanes potential = m.potential(m.at(staged_.x, 0).c);
    staged_.largest_energy = max(max(m.kinetic_energy(v), abs(potential)), m.exit_energy());
  }

  struct endings {
    std::uint64_t let_go, captured, aside;
  };

  /// One step of every lane; lanes whose contact has ended are named, with end_rate_ and excess_ filled in.
  [[gnu::flatten]] endings step() {
    const reduced_type& m = now_.model;
    state_type& x = now_.x;
    const auto system = [&m](const state_type& at, state_type& slope, const Lanes&) { m.derivative(at, slope, 0); };
    state_type slope;
    system(x, slope, Lanes(0));
    const mask never = Lanes(1) < Lanes(0), outward = x[approach_rate] < Lanes(0);
    now_.has_turned = where(outward, Lanes(1), now_.has_turned);

    Lanes ahead = where(outward, time_to_end(x, slope), Lanes(infinite));
    mask turns = never;
    if constexpr (kinks_at_turning) {
      turns = (now_.has_turned < Lanes(1)) & (slope[approach_rate] < Lanes(0));
      const Lanes tangent = -x[approach_rate] / slope[approach_rate]; // leads beyond the kink, less so from near
      const Lanes part = where(tangent < Lanes(0.1) * now_.longest, Lanes(0.95), Lanes(0.6));
      ahead = where(turns, tangent * where(tangent < Lanes(16) * now_.close, Lanes(1), part), ahead);
      turns = turns & (ahead < now_.close);
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = where(turns, x[i] + slope[i] * ahead, x[i]);
      x[approach_rate] = where(turns, Lanes(-0x1p-60), x[approach_rate]);
    }
    const mask let_go = (abs(ahead) < now_.close) & ~turns;
    end_rate_ = x[approach_rate] + slope[approach_rate] * ahead;
    excess_ = m.kinetic_energy(end_rate_);
    mask captured = never;
    if constexpr (pulled) {
      const part c = m.at(x, 0).c;
      const Lanes potential = m.potential(c), left = m.kinetic_energy(c.rate) + potential - m.exit_energy();
      now_.largest_energy = max(now_.largest_energy, abs(potential));
      captured = (left < Lanes(0)) & (now_.has_turned > Lanes(0)) & ~let_go;
      excess_ = where(captured, left, excess_);
    }

    const mask lands = (ahead <= now_.h) & ~turns;
    state_type next, error{};
    const Lanes h = where(lands, ahead, now_.h);
    stepper_.do_step(system, x, slope, Lanes(0), next, h, error);
    advance(next, error, h, lands, turns);
    const mask aside = (now_.steps > Lanes(most_steps_)) | (now_.h <= Lanes(1e-12) * now_.longest);
    return {let_go.bits(), captured.bits(), aside.bits()};
  }

  /// Lanes whose step of size h was good enough move on, and every lane gets the size of its next one; one that was
  /// shortened to land at an event does not change it.
  void advance(const state_type& next, const state_type& error, const Lanes& h, const mask& lands, const mask& turns) {
    Lanes largest = abs(error[0]) * now_.per_error[0];
    for (std::size_t i = 1; i < error.size(); ++i)
      largest = max(largest, abs(error[i]) * now_.per_error[i]);
    const mask accepted = largest <= Lanes(1);
    for (std::size_t i = 0; i < next.size(); ++i)
      now_.x[i] = where(accepted & ~turns, next[i], now_.x[i]);
    // The error goes as the sixth power of the step; the eighth root is cheap, and cautious.
    const Lanes root = Lanes(0.9) / sqrt(sqrt(sqrt(max(largest, Lanes(1e-8)))));
    const Lanes change = where(largest < Lanes(infinite), max(min(root, Lanes(5)), Lanes(0.1)), Lanes(0.25));
    now_.h = where(turns | (accepted & lands), now_.h, min(abs(h) * change, now_.longest));
    now_.steps += Lanes(1);
  }

  /// By a parabola to where the overlap or the static branch ends, by the tangent to where the force does.
  Lanes time_to_end(const state_type& x, const state_type& slope) const {
    const Lanes distance = x[reduced_type::coordinate] - now_.end, speed = -slope[reduced_type::coordinate];
    const Lanes root = speed * speed - Lanes(2) * slope[approach_rate] * distance;
    const Lanes parabola = Lanes(2) * distance / (speed + sqrt(max(root, Lanes(0))));
    const Lanes time = where(root >= Lanes(0), parabola, Lanes(infinite));
    if constexpr (ends_without_force)
      return min(time, time_to_zero_force(x, slope));
    else
      return time;
  }

  /// Tangent to F/D + rate along the motion.
  Lanes time_to_zero_force(const state_type& x, const state_type& slope) const requires ends_without_force {
    const reduced_type& m = now_.model;
    const auto value = [&m](const state_type& at) {
      const part c = m.at(at, 0).c;
      return m.elastic.force(m.pair, c) / m.damping.coefficient(m.pair, c) + c.rate;
    };
    const Lanes apart = Lanes(1e-7) * now_.longest;
    state_type beside = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      beside[i] += apart * slope[i];
    const Lanes here = value(x), fall = (here - value(beside)) / apart;
    return where(fall > Lanes(0), here / fall, Lanes(infinite));
  }

  static constexpr double infinite = 1e300;

  const Model& model_;
  double most_steps_;
  course now_, staged_;
  stepper_type stepper_;
  Lanes end_rate_, excess_;
};

} // namespace ricochet
