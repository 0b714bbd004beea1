#pragma once
#include <ricochet/batch/lane_laws.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/solve/collide.hpp>

#include <bit>
#include <optional>

namespace ricochet {

/// A model whose collisions can run side by side: all lanes go through the same formulas, an edge of finite speed only
/// by the exact law, and nothing is asked that has to be watched step by step.
template <class Model>
consteval bool runs_in_lanes() {
  constexpr bool edge = !Model::has_crack_law || std::same_as<decltype(Model::crack), greenwood>;
  constexpr bool else_smooth = !Model::cohesive && !Model::has_friction && !Model::yields && !Model::flows;
  return edge && else_smooth && Model::asked.outcome_only();
}

/// How one solution of a collision ended; energies in units of the initial kinetic energy.
enum class lane_fate { let_go, captured, set_aside };
struct lane_solution {
  lane_fate fate;
  double restitution;
  double excess;         ///< energy beyond what the contact has where it lets go; of separated bodies all of it
  double largest_energy; ///< that was met
  int steps;
};

/// What is solved, twice: a collision's laws in SI, its speed in m/s, and the larger of its two step tolerances, in
/// units of the speed; the other is a quarter of it.
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
  static constexpr bool kinks_at_turning = Model::opposes_rebound;
  static constexpr bool free_edge = Model::has_crack_law; ///< whose motion has a kink where it rests

public:
  static constexpr int evaluations_a_step = int(stepper::tsitouras_papakostas75_table::stages);

  /// Of `model` only the quantities' dimensions count, and what its type says. Set aside is what takes more evaluations
  /// than given, or many more than lanes are good for.
  lane_solver(const Model& model, long max_evaluations)
      : model_(model), most_steps_(double(std::min(max_evaluations / evaluations_a_step, free_edge ? 4000L : 1000L))),
        now_{.model = reduced_type(laws_in_si<Lanes>(model))}, staged_{now_, now_} {}

  /// `task_of(i)` gives the task i < count; `finished(i, fine, lane_solution)` is told its solution at the larger step
  /// tolerance and, fine, at the smaller one, in no certain order.
  template <class TaskOf, class Finished>
  void solve(std::size_t count, const TaskOf& task_of, const Finished& finished) {
    std::size_t next = 0, staged_from = 0, staged = 0;
    std::array<std::size_t, Lanes::size> solution; // of each lane, two to a task
    std::uint64_t busy = 0;
    const auto refill = [&](std::size_t lane) {
      if (next == 2 * count)
        return false;
      if (next == 2 * (staged_from + staged)) {
        staged_from += staged;
        staged = std::min(Lanes::size, count - staged_from);
        stage(staged, [&](std::size_t i) { return task_of(staged_from + i); });
      }
      copy_lane<Lanes>(now_, lane, staged_[next % 2], next / 2 - staged_from);
      solution[lane] = next++;
      return true;
    };
    for (std::size_t lane = 0; lane < Lanes::size && refill(lane); ++lane)
      busy |= std::uint64_t(1) << lane;
    for (std::size_t lane = std::size_t(std::popcount(busy)); lane < Lanes::size; ++lane)
      copy_lane<Lanes>(now_, lane, staged_[0], 0);
    while (busy) {
      const auto [let_go, captured, aside] = step();
      for (std::uint64_t done = (let_go | captured | aside) & busy; done; done &= done - 1) {
        const std::size_t lane = std::size_t(std::countr_zero(done));
        const std::uint64_t bit = std::uint64_t(1) << lane;
        const lane_fate fate = aside & bit      ? lane_fate::set_aside
                               : captured & bit ? lane_fate::captured
                                                : lane_fate::let_go;
        const double speed = now_.speed[lane], kinetic = now_.model.kinetic_energy(now_.speed)[lane];
        finished(solution[lane] / 2, solution[lane] % 2 == 1,
                 lane_solution{fate, -end_rate_[lane] / speed, excess_[lane] / kinetic,
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
    Lanes piece{}, since{};        ///< of a free edge: that of its law, and the slowed time since it last rested
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
    course& rough = staged_[0];
    rough.model = reduced_type(in_scales(laws, model_, unit));
    const reduced_type& m = rough.model;
    const Lanes v = speed * unit.duration / unit.length;
    rough.speed = v;
    rough.x = m.touch(v);
    rough.has_turned = rough.steps = Lanes(0);
    if constexpr (Model::adhesive)
      rough.end = m.fold_coordinate();
    else
      rough.end = Lanes(0);
    rough.piece = Lanes(0);
    rough.since = Lanes(infinite);
    const Lanes potential = m.potential(m.contact(rough.x, rough.piece));
    rough.largest_energy = max(max(m.kinetic_energy(v), abs(potential)), m.exit_energy());
    staged_[1] = rough;
    tolerance = tolerance * min(v, Lanes(1));
    set_tolerance(staged_[0], tolerance);
    set_tolerance(staged_[1], tolerance / Lanes(4));
  }

  static void set_tolerance(course& c, Lanes tolerance) {
    tolerance = max(tolerance, Lanes(4 * std::numeric_limits<double>::epsilon()));
    const state_type typical = c.model.typical();
    for (std::size_t i = 0; i < typical.size(); ++i)
      c.per_error[i] = Lanes(1) / (typical[i] * tolerance);
    const Lanes eighth_root = sqrt(sqrt(sqrt(tolerance)));
    if constexpr (free_edge)
      c.longest = min(Lanes(0.4), eighth_root);
    else
      c.longest = typical[reduced_type::coordinate] * min(Lanes(1), Lanes(2) * eighth_root);
    c.h = c.longest / Lanes(8);
    c.close = c.longest * sqrt(tolerance) / Lanes(64);
  }

  struct endings {
    std::uint64_t let_go, captured, aside;
  };

  /// One step of every lane; lanes whose contact has ended are named, with end_rate_ and excess_ filled in.
  [[gnu::flatten]] endings step() {
    const reduced_type& m = now_.model;
    state_type& x = now_.x;
    mask inside = true;
    const auto system = [&](const state_type& at, state_type& slope, const Lanes&) {
      if constexpr (free_edge)
        inside = inside & m.derivative(at, slope, now_.piece);
      else
        m.derivative(at, slope, 0);
    };
    state_type slope;
    system(x, slope, Lanes(0));
    const mask outward = x[approach_rate] < Lanes(0);
    now_.has_turned = where(outward, Lanes(1), now_.has_turned);

    const auto [to_end, lets_go] = end_ahead(x, slope, outward);
    const auto [to_kink, kinks] = kink_ahead(x, slope);
    Lanes ahead = where(kinks, to_kink, to_end);
    const mask crosses = kinks & (ahead < now_.close);
    if constexpr (kinks_at_turning || free_edge)
      cross(crosses, x, slope, ahead);
    const mask near_end = (abs(ahead) < now_.close) & ~crosses & ~kinks, let_go = near_end & lets_go;
    end_rate_ = x[approach_rate] + slope[approach_rate] * ahead;
    excess_ = m.kinetic_energy(end_rate_);
    mask captured = false;
    if constexpr (pulled) {
      const part c = m.contact(x, now_.piece);
      const Lanes potential = m.potential(c), left = m.kinetic_energy(c.rate) + potential - m.exit_energy();
      now_.largest_energy = max(now_.largest_energy, abs(potential));
      captured = (left < Lanes(0)) & (now_.has_turned > Lanes(0)) & ~let_go;
      excess_ = where(captured, left, excess_);
    }

    Lanes longest = now_.h;
    if constexpr (free_edge) // the motion is not smooth behind a kink: steps grow with the distance
      longest = min(longest, max(Lanes(1.5) * now_.since, Lanes(4) * now_.close));
    const mask lands = (ahead <= longest) & ~crosses;
    state_type next, error{};
    const Lanes h = where(lands, ahead, longest);
    stepper_.do_step(system, x, slope, Lanes(0), next, h, error);
    advance(next, error, h, lands, crosses, inside);
    const mask aside =
        (now_.steps > Lanes(most_steps_)) | (now_.h <= Lanes(1e-12) * now_.longest) | (near_end & ~(let_go | captured));
    return {let_go.bits(), captured.bits(), aside.bits()};
  }

  /// Lanes whose step of size h was good enough move on, and every lane gets the size of its next one; one that was
  /// shortened to land at an event does not change it.
  void advance(const state_type& next, const state_type& error, const Lanes& h, const mask& lands, const mask& crosses,
               const mask& inside) {
    Lanes largest = abs(error[0]) * now_.per_error[0];
    for (std::size_t i = 1; i < error.size(); ++i)
      largest = max(largest, abs(error[i]) * now_.per_error[i]);
    mask valid = inside;
    if constexpr (free_edge)
      valid = valid & ~steps_over_kink(next);
    const mask accepted = (largest <= Lanes(1)) & valid & ~crosses;
    for (std::size_t i = 0; i < next.size(); ++i)
      now_.x[i] = where(accepted, next[i], now_.x[i]);
    // The error goes as the sixth power of the step; the eighth root is cheap, and cautious.
    const Lanes root = Lanes(0.9) / sqrt(sqrt(sqrt(max(largest, Lanes(1e-8)))));
    const Lanes change = where((largest < Lanes(infinite)) & valid, max(min(root, Lanes(5)), Lanes(0.1)), Lanes(0.25));
    now_.h = where(crosses | (accepted & lands), now_.h, min(abs(h) * change, now_.longest));
    if constexpr (free_edge)
      now_.since = where(crosses, Lanes(0), where(accepted, now_.since + h, now_.since));
    now_.steps += Lanes(1);
  }

  /// Has the edge come to rest and gone on by the wrong piece of its law? One just turned around may still be there.
  mask steps_over_kink(const state_type& next) const {
    const Lanes side = Lanes(1) - Lanes(2) * now_.piece;
    const Lanes before = (now_.model.root_ratio(now_.x) - Lanes(1)) * side;
    return (now_.model.root_ratio(next) - Lanes(1)) * side > max(before, Lanes(0));
  }

  struct event_ahead {
    Lanes time; ///< infinite where there is none
    mask is;
  };

  /// The end of the contact; of a free edge only past the fold.
  event_ahead end_ahead(const state_type& x, const state_type& slope, const mask& outward) const {
    if constexpr (free_edge) { // 1 - k beta is smooth where the slowness vanishes
      const reduced_type& m = now_.model;
      const Lanes r = m.root_ratio(x), k = m.crack.modulus_ratio;
      const Lanes fall = Lanes(2) * k * r * m.root_ratio_slope(x, slope), left = Lanes(1) - k * r * r;
      return {where((now_.piece > Lanes(0)) & (fall > Lanes(0)), part_of(left / fall), Lanes(infinite)),
              m.past_fold(m.contact(x, now_.piece)) & outward};
    } else {
      return {where(outward, time_to_end(x, slope), Lanes(infinite)), true};
    }
  }

  /// From afar the tangent to an event that the motion must not be led beyond is followed a part of the way only.
  Lanes part_of(const Lanes& tangent) const {
    const mask near = tangent < Lanes(0.1) * now_.longest;
    if constexpr (free_edge)
      return tangent * where(tangent < now_.close, Lanes(1), where(near, Lanes(0.7), Lanes(0.4)));
    else
      return tangent * where(tangent < Lanes(16) * now_.close, Lanes(1), where(near, Lanes(0.95), Lanes(0.6)));
  }

  /// A kink that the motion goes on behind: where the rate changes its sign, or the edge rests.
  event_ahead kink_ahead(const state_type& x, const state_type& slope) const {
    if constexpr (kinks_at_turning) { // the tangent leads beyond the kink, less so from near
      return {part_of(-x[approach_rate] / slope[approach_rate]),
              (now_.has_turned < Lanes(1)) & (slope[approach_rate] < Lanes(0))};
    } else if constexpr (free_edge) {
      const Lanes gap = now_.model.root_ratio(x) - Lanes(1), growth = now_.model.root_ratio_slope(x, slope);
      const mask opens = now_.piece > Lanes(0);
      return {part_of(-gap / growth),
              (opens & (gap >= Lanes(0)) & (growth < Lanes(0))) | (~opens & (gap <= Lanes(0)) & (growth > Lanes(0)))};
    } else {
      return {Lanes(infinite), false};
    }
  }

  /// These lanes go over to the other side of a kink near by.
  void cross(const mask& these, state_type& x, const state_type& slope, const Lanes& ahead) {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = where(these, x[i] + slope[i] * ahead, x[i]);
    if constexpr (kinks_at_turning)
      x[approach_rate] = where(these, Lanes(-0x1p-60), x[approach_rate]);
    else
      now_.piece = where(these, Lanes(1) - now_.piece, now_.piece);
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
    const auto value = [&m, this](const state_type& at) {
      const part c = m.contact(at, now_.piece);
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
  course now_;
  std::array<course, 2> staged_; ///< who comes next, at both step tolerances
  stepper_type stepper_;
  Lanes end_rate_, excess_;
};

} // namespace ricochet
