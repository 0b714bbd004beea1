// The speeds of a model up to which the pair sticks, and from which on it yields.
#pragma once
#include <ricochet/study/threshold/threshold_search.hpp>

namespace ricochet {

/// The sticking speed lies between `largest_captured` and `smallest_separated`, whose endings are certain.
struct sticking_threshold {
  speed largest_captured, smallest_separated;
  long collisions = 0;

  speed value() const { return 0.5 * (largest_captured + smallest_separated); }
};

/// The yield speed lies between both.
struct yield_threshold {
  speed largest_elastic, smallest_yielding;
  long collisions = 0;

  speed value() const { return 0.5 * (largest_elastic + smallest_yielding); }
};

namespace detail {

inline constexpr range sticking_width_range{.low = 1e-12, .high = 1e-1, .high_included = true};
inline constexpr range yield_width_range{.low = 1e-10, .high = 1e-1, .high_included = true};

/// What a search has seen; of looks that told nothing the last reason.
struct threshold_log {
  long max_evaluations = collide_options{}.max_evaluations;
  long collisions = 0;
  std::string uncertain{}, unresolved{};
};

template <class Model>
auto noted_collision(const Model& model, double v, double tolerance, threshold_log& log) {
  ++log.collisions;
  auto out = collide(model, impact{v * units::metres_per_second},
                     {.tolerance = tolerance, .max_evaluations = log.max_evaluations});
  const bool ended = out.ending == ending::separated || out.ending == ending::captured;
  if (!ended)
    log.unresolved = "the collision at " + shown(v) + " m/s ended " + name_of(out.ending) + ": " + out.reason;
  return std::pair{std::move(out), ended};
}
inline constexpr threshold_look unresolved_look{threshold_look::undecided, 0.05};

/// Looks whether the pair stays together.
template <class Model>
struct sticking_look {
  const Model& model;
  double relative_width;
  threshold_log& log;

  double search_width() const { return relative_width; }
  static double error_of_speed() { return 0; } ///< endings are certain or undecided

  threshold_look operator()(double v, double apart) const {
    const double finest = Model::has_crack_law ? std::max(relative_width / 4, tolerance_range.low) : 1e-7;
    double tolerance = std::clamp(1e-2 * apart * apart, std::min(finest, 1e-4), 1e-4);
    auto [out, ended] = noted_collision(model, v, tolerance, log);
    // Too near to decide, or a fast edge solved too coarsely: only the closest look tells.
    while (ended && !out.ending_is_certain && tolerance > tolerance_range.low)
      std::tie(out, ended) = noted_collision(model, v, tolerance = std::max(tolerance / 1e2, tolerance_range.low), log);
    if (!ended)
      return unresolved_look;
    if (!out.ending_is_certain) {
      log.uncertain = "round-off leaves the ending at " + shown(v) + " m/s uncertain";
      return {threshold_look::undecided};
    }
    if (!out.restitution)
      return {threshold_look::below};
    bool edge_decides = Model::has_crack_law; // when to let go: e passes through zero linearly; where energy does, e^2
    if constexpr (Model::yields)
      edge_decides = edge_decides && out.plastic_loss == 0;
    return {threshold_look::above, edge_decides ? *out.restitution : square(*out.restitution)};
  }
};

/// Looks whether plastic flow sets in, by the motion, or by the law alone where it adds its loss to that of the motion.
template <class Model>
struct yield_look {
  static_assert(Model::flows || Model::yields,
                "a yield speed needs a plasticity law in the model: add thornton_ning or thornton_ning_contact");
  const Model& model;
  double relative_width;
  threshold_log& log;

  double search_width() const { return relative_width / 2; }
  /// No more than half of the error of the energy at the turning point.
  double error_of_speed() const { return relative_width / 8; }

  threshold_look operator()(double v, double) const {
    double flow; // grows as the square of the speed above the threshold
    if constexpr (Model::flows) {
      const auto [out, ended] = noted_collision(model, v, std::max(relative_width / 100, tolerance_range.low), log);
      flow = in_si(out.residual_approach);
      if (!(flow > 0) && !ended)
        return unresolved_look;
    } else {
      flow = model.plasticity.loss(model.pair, v * units::metres_per_second);
    }
    return flow > 0 ? threshold_look{threshold_look::above, std::sqrt(flow)} : threshold_look{threshold_look::below};
  }
};

/// The search between two speeds, whose ends have to be what they are taken for.
template <class Look>
threshold_search<Look> search_between(speed low, speed high, const Look& look, const char* what, const char* below,
                                      const char* above) {
  require("low speed", low, positive);
  require("high speed", high, range{.low = in_si(low), .low_included = false});
  threshold_search search(look);
  const auto refuse_unresolved = [&] {
    if (!look.log.unresolved.empty())
      throw bad_input(std::string(what) + ": " + look.log.unresolved);
  };
  const auto is_end = [&](speed v, const char* which, int side, const char* otherwise) {
    const int seen = search.ask(in_si(v), 1).side;
    refuse_unresolved();
    if (seen != side)
      throw bad_input(std::string(what) + ": " +
                      (seen == threshold_look::undecided ? look.log.uncertain
                                                         : std::string("the pair ") + otherwise + " at the " + which +
                                                               " speed, " + shown(in_si(v)) + " m/s"));
  };
  is_end(low, "low", threshold_look::below, above);
  is_end(high, "high", threshold_look::above, below);
  search.narrow(look.search_width());
  refuse_unresolved();
  return search;
}

} // namespace detail

/// Largest speed between `low` and `high` at which the pair stays together, by a root search on the certified ending:
/// next to the threshold the speed as a polynomial of e^2 where the energy decides, of e where a free edge does,
/// through the last separated collisions; halving elsewhere. relative_width: of the bracket returned, 1e-12 to 1e-1;
/// wider only where round-off leaves the ending uncertain. \throws bad_input if the pair does not stick at `low` or
/// does at `high`, or if a collision cannot be resolved.
template <class Model>
sticking_threshold sticking_speed(const Model& model, speed low, speed high, double relative_width = 1e-9) {
  require("relative_width", relative_width, detail::sticking_width_range);
  detail::threshold_log log;
  const detail::sticking_look<Model> look{model, relative_width, log};
  const auto found = detail::search_between(low, high, look, "sticking speed", "sticks", "does not stick");
  return {found.below * units::metres_per_second, found.above * units::metres_per_second, log.collisions};
}

/// Smallest speed between `low` and `high` at which the contact yields, adhesion and damping included where plastic
/// flow is part of the motion (thornton_ning_contact); else that of the law, which does not know of them
/// (thornton_ning). relative_width: of the bracket returned, which holds the errors of the motion, 1e-10 to 1e-1.
/// \throws bad_input if the contact yields at `low` or does not at `high`, or if a collision cannot be resolved.
template <class Model>
yield_threshold yield_speed(const Model& model, speed low, speed high, double relative_width = 1e-9) {
  require("relative_width", relative_width, detail::yield_width_range);
  detail::threshold_log log;
  const detail::yield_look<Model> look{model, relative_width, log};
  const auto found = detail::search_between(low, high, look, "yield speed", "does not yield", "yields");
  const double error = look.error_of_speed();
  return {(1 - error) * found.below * units::metres_per_second, (1 + error) * found.above * units::metres_per_second,
          log.collisions};
}

} // namespace ricochet
