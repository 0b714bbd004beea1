// Many collisions at once: side by side in the lanes of SIMD registers, on as many threads as wanted.
#pragma once
#include <ricochet/batch/lane_solver.hpp>
#include <ricochet/batch/share.hpp>
#include <ricochet/batch/tabulated_lanes.hpp>

#include <span>

namespace ricochet {

/// One collision of a batch in which the bodies or the laws' parameters differ.
template <class Model>
struct scene {
  Model model;
  ricochet::impact impact;
};
template <class Model>
scene(Model, impact) -> scene<Model>;

/// tolerance, max_evaluations: as in collide_options. threads: 0 takes as many as the machine has. progress: told now
/// and then, by one thread at a time, how many collisions are done, and of how many.
struct batch_options {
  double tolerance = 1e-8;
  long max_evaluations = 3'000'000;
  unsigned threads = 0;
  progress_callback progress = {};
};

namespace detail {

using batch_lanes = lanes<xsimd::batch<double>, 2>;

/// Step tolerance, in units of the speed, for a wanted error of the restitution: the steps' own estimate goes as the
/// sixth power of the step, the error of a whole collision as the seventh.
/// Its factor and that of the next function hold for all in tests/batch/batch.cpp, which prints the errors.
template <class Model>
double lane_tolerance(double wanted) {
  return std::min(1.4 * std::pow(wanted, 6. / 7), Model::has_crack_law ? 1e-4 : 1.5e-4);
}
/// Error of a collision's energy to be reckoned with, unless found larger, in units of the geometric mean of the
/// kinetic energy and the largest one met. Contacts pulled by a force without an edge err up to ten times more than
/// others, free edges up to three times more where steps are long.
template <class Model>
double usual_lane_error(double tolerance) {
  const double of_steps = Model::has_crack_law ? std::max(1., std::cbrt(2.7e5 * tolerance)) : 1;
  return (Model::attracted ? 0.5 : 0.1) * of_steps * std::pow(tolerance, 7. / 6);
}

/// Is the edge so fast that a collision alone, by an implicit method, takes less time than in lanes? Where lanes of two
/// and of eight numbers take as long.
template <class Model>
bool faster_alone(const Model& model, speed v) {
  if constexpr (Model::has_crack_law) {
    if (in_si(model.crack.relaxation_time) == 0)
      return true;
    const reduced_model<double, Model> numbers(model, scales_at(model, v));
    return fast_edge<reduced_model<double, Model>>::excess_below(0.005, numbers);
  } else {
    return false;
  }
}

/// Outcome from two solutions at step tolerances `tolerance` and a quarter of it, both in units of the speed; none
/// where they do not tell the outcome to the tolerance wanted.
template <class Model>
std::optional<outcome_of<Model>> outcome_of_lanes(const lane_solution& rough, const lane_solution& fine,
                                                  double tolerance, double usual_error, double wanted,
                                                  int evaluations_a_step) {
  if (rough.fate != fine.fate || fine.fate == lane_fate::set_aside)
    return std::nullopt;
  const double round_off = (16 + fine.steps / 5) * std::numeric_limits<double>::epsilon() * fine.largest_energy;
  const double energy_error =
      std::max(std::abs(fine.excess - rough.excess), usual_error * std::sqrt(fine.largest_energy));
  outcome_of<Model> out;
  out.evaluations = (rough.steps + fine.steps) * evaluations_a_step;
  if (fine.fate == lane_fate::captured) { // the solutions were looked at at different instants
    if (!(-fine.excess > 100 * (tolerance + round_off) && -rough.excess > 100 * (tolerance + round_off)))
      return std::nullopt;
    out.ending = ending::captured;
    return out;
  }
  out.ending = ending::separated;
  const double e = std::min(1., fine.restitution);
  out.restitution = e;
  if constexpr (Model::has_crack_law) // the edge decides when to let go: e passes through zero linearly
    out.error_estimate =
        std::max(1.5 * std::abs(fine.restitution - rough.restitution), energy_error / std::max(e, 1. / 16)) + round_off;
  else
    out.error_estimate = std::min((energy_error + round_off) / e, std::sqrt(energy_error + round_off));
  if (!(out.error_estimate <= wanted && e > 2 * out.error_estimate))
    return std::nullopt;
  return out;
}

/// A part of a batch, small enough to stay in the cache, whose collisions are solved twice each.
template <class Model>
class batch_part {
  using solver = lane_solver<Model, batch_lanes>;

public:
  static constexpr std::size_t size = Model::has_crack_law ? 1024 : 256; ///< where some take much longer, more wait

  batch_part(const Model& model, long max_evaluations) : lanes_(model, max_evaluations) {}

  /// `scene_of(i)` gives collision i < count, `alone(i)` its outcome by other means: of those that take less time so.
  /// Those that lanes do not resolve at a step tolerance are tried at a smaller one, and then are left alone.
  template <class SceneOf, class Alone>
  void solve(std::size_t count, double wanted, const SceneOf& scene_of, const Alone& alone,
             outcome_of<Model>* outcomes) {
    const std::size_t all = count;
    count = 0;
    for (std::size_t i = 0; i < all; ++i)
      if (const auto& [model, impact] = scene_of(i); faster_alone(model, impact.speed))
        outcomes[i] = alone(i);
      else
        open_[count++] = i;
    double tolerance = lane_tolerance<Model>(wanted);
    for (int round = 0; round < 2 && count > 0; ++round, tolerance /= 64) {
      lanes_.solve(
          count,
          [&](std::size_t i) {
            const auto& [model, impact] = scene_of(open_[i]);
            return lane_task<Model>{laws_in_si<double>(model), in_si(impact.speed), tolerance};
          },
          [&](std::size_t i, bool fine, const lane_solution& solution) { solutions_[i][fine] = solution; });
      const double usual = usual_lane_error<Model>(tolerance);
      std::size_t left = 0;
      for (std::size_t i = 0; i < count; ++i)
        if (auto out = outcome_of_lanes<Model>(solutions_[i][false], solutions_[i][true], tolerance, usual, wanted,
                                               solver::evaluations_a_step)) {
          const auto& [model, impact] = scene_of(open_[i]);
          outcomes[open_[i]] = warned<Model>(model, impact.speed, std::move(*out));
        } else
          open_[left++] = open_[i];
      count = left;
    }
    for (std::size_t i = 0; i < count; ++i)
      outcomes[open_[i]] = alone(open_[i]);
  }

private:
  solver lanes_;
  std::array<std::array<lane_solution, 2>, size> solutions_;
  std::array<std::size_t, size> open_;
};

template <class Model, class SceneOf>
std::vector<outcome_of<Model>> collide_all(std::size_t count, const batch_options& options, const SceneOf& scene_of) {
  const collide_options alone{.tolerance = options.tolerance, .max_evaluations = options.max_evaluations};
  admit(alone);
  for (std::size_t i = 0; i < count; ++i)
    try {
      admit<Model>(scene_of(i).impact);
    } catch (const bad_input& e) {
      throw bad_input("impact " + std::to_string(i) + ": " + e.what());
    }
  std::vector<outcome_of<Model>> outcomes(count);
  if constexpr (Model::yields) { // its loss is added to that of the motion
    std::vector<scene<elastic_part<Model>>> elastic;
    elastic.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      elastic.push_back({scene_of(i).model.without_plasticity(), scene_of(i).impact});
    const auto moved = collide_all<elastic_part<Model>>(
        count, options, [&](std::size_t i) -> const scene<elastic_part<Model>>& { return elastic[i]; });
    share(count, 256, options.threads, {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto& [model, impact] = scene_of(i);
        outcomes[i] = warned(model, impact.speed, with_plastic_loss(model, impact.speed, moved[i]));
        if (loses_accuracy(moved[i], outcomes[i], options.tolerance))
          outcomes[i] = ricochet::collide(model, impact, alone);
      }
    });
  } else if constexpr (runs_in_lanes<Model>() && !closed_form::solved<Model>) {
    const std::size_t fair = (count + thread_count(options.threads) - 1) / thread_count(options.threads);
    const std::size_t size = std::clamp<std::size_t>(fair, 2 * batch_lanes::size, batch_part<Model>::size);
    share(count, size, options.threads, options.progress, [&](std::size_t first, std::size_t last) {
      batch_part<Model> part(scene_of(first).model, options.max_evaluations);
      part.solve(
          last - first, options.tolerance, [&](std::size_t i) -> decltype(auto) { return scene_of(first + i); },
          [&](std::size_t i) { return integrate(scene_of(first + i).model, scene_of(first + i).impact, alone); },
          outcomes.data() + first);
    });
  } else if constexpr (closed_form::tabulated<Model> && !Model::asked.warnings)
    share(count, 1024, options.threads, options.progress, [&](std::size_t first, std::size_t last) {
      solve_tabulated<batch_lanes, Model>(
          last - first, [&](std::size_t i) -> decltype(auto) { return scene_of(first + i); },
          [&](std::size_t i) {
            return ricochet::collide(scene_of(first + i).model, scene_of(first + i).impact, alone);
          },
          outcomes.data() + first);
    });
  else // closed forms take no longer than handing out a part of the work
    share(count, closed_form::solved<Model> ? 256 : 16, options.threads, options.progress,
          [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
              outcomes[i] = ricochet::collide(scene_of(i).model, scene_of(i).impact, alone);
          });
  return outcomes;
}

} // namespace detail

/// What comes of these impacts, in their order. An outcome is the same to the last bit in whatever company, order and
/// number of threads it is computed, and agrees with collide() of the lone impact within the tolerance.
/// \throws bad_input as collide(), before anything is computed; and whatever options.progress throws.
template <class Model>
std::vector<outcome_of<Model>> collide(const Model& model, std::span<const impact> impacts,
                                       const batch_options& options = {}) {
  struct view {
    const Model& model;
    const ricochet::impact& impact;
  };
  return detail::collide_all<Model>(impacts.size(), options, [&](std::size_t i) { return view{model, impacts[i]}; });
}

/// The same where the bodies or the laws' parameters differ.
template <class Model>
std::vector<outcome_of<Model>> collide(std::span<const scene<Model>> scenes, const batch_options& options = {}) {
  return detail::collide_all<Model>(scenes.size(), options,
                                    [&](std::size_t i) -> const scene<Model>& { return scenes[i]; });
}
template <class Model>
std::vector<outcome_of<Model>> collide(const std::vector<scene<Model>>& scenes, const batch_options& options = {}) {
  return collide(std::span<const scene<Model>>(scenes), options);
}

} // namespace ricochet
