// Sticking speeds and yield speeds of many models at once.
#pragma once
#include <ricochet/batch/share.hpp>
#include <ricochet/model/regime.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <ranges>

namespace ricochet {

/// relative_width: of the brackets, as for sticking_speed() and yield_speed(). slowest, fastest: where the search ends;
/// unless given, fastest is a tenth of the speed of sound, for which the pair has to know its bodies, and slowest 1e-9
/// of it. max_evaluations: as in collide_options. threads: 0 takes as many as the machine has. progress: told now and
/// then, by one thread at a time, how many points are done, and of how many.
struct threshold_options {
  double relative_width = 1e-6;
  std::optional<speed> slowest = std::nullopt, fastest = std::nullopt;
  long max_evaluations = collide_options{}.max_evaluations;
  unsigned threads = 0;
  progress_callback progress = {};
};

/// Where the threshold of one point is: `between` both speeds, up to which the pair sticks or does not yield, and from
/// which on it does otherwise, both for certain. `above_fastest`: it is above `below`, the fastest speed; `above` is
/// infinite. `below_slowest`: below `above`, the slowest; `below` is zero. `failed`: there is no model, or too few
/// collisions could be resolved; reason says why, and also why a bracket is wider than asked for.
struct sought_threshold {
  enum class place { between, above_fastest, below_slowest, failed };
  place at = place::failed;
  speed below{}, above = std::numeric_limits<double>::infinity() * units::metres_per_second;
  std::string reason{};
  long collisions = 0;

  /// Middle of the bracket, if there is one.
  std::optional<speed> value() const {
    return at == place::between ? std::optional<speed>(0.5 * (below + above)) : std::nullopt;
  }
};

namespace detail {

template <template <class> class Look, class Family, class Points, class Guess>
std::vector<sought_threshold> seek_thresholds(const Family& family, const Points& points,
                                              const threshold_options& options, const Guess& guess) {
  if (options.slowest)
    require("slowest", *options.slowest, positive);
  if (options.fastest)
    require("fastest", *options.fastest,
            range{.low = options.slowest ? in_si(*options.slowest) : 0, .low_included = false});
  require("max_evaluations", double(options.max_evaluations), range{.low = 1});
  const auto seek = [&](const auto& point) {
    sought_threshold found;
    threshold_log log{options.max_evaluations};
    try {
      const auto model = family(point);
      using model_type = std::remove_cvref_t<decltype(model)>;
      const speed one = 1.0 * units::metres_per_second;
      const double fastest = options.fastest ? in_si(*options.fastest) : 0.1 / regime_of(model, one).speed_over_sound;
      const double slowest = options.slowest ? in_si(*options.slowest) : 1e-9 * fastest;
      require("slowest", slowest * one, range{.high = fastest, .low_included = false});
      const Look<model_type> look{model, options.relative_width, log};
      threshold_search search(look);
      search.find(guess(model, slowest, fastest), slowest, fastest);
      if (search.bracketed()) {
        search.narrow(look.search_width());
        found.at = sought_threshold::place::between;
      } else if (search.below == fastest)
        found.at = sought_threshold::place::above_fastest;
      else if (search.above == slowest)
        found.at = sought_threshold::place::below_slowest;
      const double error = look.error_of_speed();
      found.below = (1 - error) * search.below * one;
      found.above = (1 + error) * search.above * one;
      found.reason = !log.unresolved.empty() ? log.unresolved : log.uncertain;
    } catch (const std::exception& error) {
      found.reason = error.what();
    }
    found.collisions = log.collisions;
    return found;
  };
  const std::size_t count = std::ranges::size(points);
  std::vector<sought_threshold> all(count);
  share(count, 1, options.threads, options.progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      all[i] = seek(points[i]);
  });
  return all;
}

} // namespace detail

/// The sticking speed of each of a family of models, as sticking_speed() finds it, but without its being told where to
/// look: from JKR's up, or from what adhesion there is up or down, until one speed sticks and the next does not. Each
/// point is sought by itself, the same in whatever company and number of threads.
/// A pair that sticks is taken to do so at all lower speeds: of several changes the search finds one, upwards from the
/// static edge's the first that is wider than a factor of two.
/// family: makes a model from a point, of whatever type, on many threads at once. points: as std::vector has them.
/// \throws bad_input if an option is out of range, and whatever options.progress throws. What a point throws is its
/// `reason`.
template <class Family, std::ranges::random_access_range Points>
std::vector<sought_threshold> sticking_speeds(const Family& family, const Points& points,
                                              const threshold_options& options = {}) {
  require("relative_width", options.relative_width, detail::sticking_width_range);
  const auto guess = [](const auto& model, double slowest, double) {
    using model_type = std::remove_cvref_t<decltype(model)>;
    if constexpr (model_type::adhesive)
      return 1.02 * in_si(closed_form::sticking_speed(model.pair, model.adhesion.work_of_adhesion));
    const scales unit = scales_at(model, slowest * units::metres_per_second);
    return unit.length / unit.duration; // without adhesion the slowest speed itself
  };
  return detail::seek_thresholds<detail::sticking_look>(family, points, options, guess);
}

/// The yield speed of each of a family of models, as yield_speed() finds it, likewise: from that without adhesion.
/// \throws as sticking_speeds()
template <class Family, std::ranges::random_access_range Points>
std::vector<sought_threshold> yield_speeds(const Family& family, const Points& points,
                                           const threshold_options& options = {}) {
  require("relative_width", options.relative_width, detail::yield_width_range);
  const auto guess = [](const auto& model, double slowest, double fastest) {
    if constexpr (requires { model.plasticity.yield_strength; })
      return 1.02 * in_si(closed_form::yield_speed(model.pair, model.plasticity.yield_strength));
    else
      return std::sqrt(slowest * fastest);
  };
  return detail::seek_thresholds<detail::yield_look>(family, points, options, guess);
}

} // namespace ricochet
