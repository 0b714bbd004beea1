#pragma once
#include <ricochet/solve/collide.hpp>

#include <optional>

namespace ricochet {

/// The sticking speed lies between `largest_captured` and `smallest_separated`, whose endings are certain.
struct sticking_threshold {
  speed largest_captured, smallest_separated;
  long collisions = 0;

  speed value() const { return 0.5 * (largest_captured + smallest_separated); }
};

/// Largest speed between `low` and `high` at which the pair stays together, by a root search on the certified ending:
/// halving, and the straight line of e^2 through the separated collisions next to the threshold.
/// relative_width: of the bracket returned, 1e-12 to 1e-1; wider only where round-off leaves the ending uncertain.
/// \throws bad_input if the pair does not stick at `low` or does at `high`, or if a collision cannot be resolved.
template <class Model>
sticking_threshold sticking_speed(const Model& model, speed low, speed high, double relative_width = 1e-9) {
  require("low speed", low, positive);
  require("high speed", high, range{.low = in_si(low), .low_included = false});
  require("relative_width", relative_width, range{.low = 1e-12, .high = 1e-1, .high_included = true});
  sticking_threshold found{low, high};
  struct point {
    double v, e_squared;
  };
  std::optional<point> near, nearer; // separated collisions, approaching the threshold
  bool decided = true;
  const auto sticks = [&](speed v) {
    ++found.collisions;
    const auto out = collide(model, impact{v}, {.tolerance = 1e-7});
    if (out.ending != ending::captured && out.ending != ending::separated)
      throw bad_input("sticking speed: the collision at " + std::to_string(in_si(v)) + " m/s ended " +
                      name_of(out.ending) + ": " + out.reason);
    decided = out.ending_is_certain;
    if (out.restitution) {
      near = nearer;
      nearer = point{in_si(v), *out.restitution * *out.restitution};
    }
    return out.ending == ending::captured;
  };
  if (!sticks(low))
    throw bad_input("sticking speed: the pair does not stick at the low speed, " + std::to_string(in_si(low)) + " m/s");
  if (sticks(high))
    throw bad_input("sticking speed: the pair sticks at the high speed too, " + std::to_string(in_si(high)) + " m/s");
  for (int i = 0; i < 200; ++i) {
    const double a = in_si(found.largest_captured), b = in_si(found.smallest_separated);
    if (b - a <= relative_width * b)
      break;
    double v = 0.5 * (a + b);
    if (near && nearer && i % 3 != 2) { // every third time halve, whatever the line says
      const double slope = (near->e_squared - nearer->e_squared) / (near->v - nearer->v);
      const double zero = nearer->v - nearer->e_squared / slope;
      const double aside = (i % 3 == 0 ? 0.4 : -0.4) * relative_width * b;
      if (zero + aside > a && zero + aside < b)
        v = zero + aside;
    }
    const bool stuck = sticks(v * units::metres_per_second);
    if (!decided)
      break;
    (stuck ? found.largest_captured : found.smallest_separated) = v * units::metres_per_second;
  }
  return found;
}

} // namespace ricochet
