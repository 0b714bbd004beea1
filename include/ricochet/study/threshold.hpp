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
/// halving, and the straight line through the separated collisions next to the threshold: of e^2 where the
/// energy decides, of e where a free edge does.
/// relative_width: of the bracket returned, 1e-12 to 1e-1; wider only where round-off leaves the ending uncertain.
/// \throws bad_input if the pair does not stick at `low` or does at `high`, or if a collision cannot be resolved.
template <class Model>
sticking_threshold sticking_speed(const Model& model, speed low, speed high, double relative_width = 1e-9) {
  require("low speed", low, positive);
  require("high speed", high, range{.low = in_si(low), .low_included = false});
  require("relative_width", relative_width, range{.low = 1e-12, .high = 1e-1, .high_included = true});
  sticking_threshold found{low, high};
  struct point {
    double v, value; // a function of e that is linear next to the threshold
  };
  std::optional<point> near, nearer; // separated collisions, approaching the threshold
  bool decided = true;
  const double tolerance = Model::has_crack_law ? std::max(relative_width / 4, tolerance_range.low) : 1e-7;
  const auto sticks = [&](speed v) {
    auto out = collide(model, impact{v}, {.tolerance = tolerance});
    ++found.collisions;
    // Too near to decide, or a fast edge solved too coarsely: only the closest look tells.
    for (double closer = tolerance; !out.ending_is_certain && closer > tolerance_range.low;) {
      closer = std::max(closer / 1e2, tolerance_range.low);
      out = collide(model, impact{v}, {.tolerance = closer});
      ++found.collisions;
    }
    if (out.ending != ending::captured && out.ending != ending::separated)
      throw bad_input("sticking speed: the collision at " + shown(in_si(v)) + " m/s ended " + name_of(out.ending) +
                      ": " + out.reason);
    decided = out.ending_is_certain;
    if (out.restitution) {
      near = nearer;
      nearer = point{in_si(v), Model::has_crack_law && !Model::yields ? *out.restitution : square(*out.restitution)};
    }
    return out.ending == ending::captured;
  };
  if (!sticks(low))
    throw bad_input("sticking speed: the pair does not stick at the low speed, " + shown(in_si(low)) + " m/s");
  if (sticks(high))
    throw bad_input("sticking speed: the pair sticks at the high speed too, " + shown(in_si(high)) + " m/s");
  int since_halved = 0;
  for (;;) {
    const double a = in_si(found.largest_captured), b = in_si(found.smallest_separated);
    if (b - a <= relative_width * b)
      break;
    double v = std::sqrt(a * b);
    if (b < 1.05 * a && near && nearer && since_halved < 3) { // close to the threshold a straight line
      const double slope = (near->value - nearer->value) / (near->v - nearer->v);
      const double zero = nearer->v - nearer->value / slope;
      const double aside = (found.collisions % 2 ? 0.3 : -0.3) * std::min(b - a, relative_width * b);
      if (zero + aside > a && zero + aside < b)
        v = zero + aside;
      ++since_halved;
    } else {
      since_halved = 0;
    }
    if (v <= a || v >= b)
      break;
    const auto narrow = [&](speed at) {
      const bool stuck = sticks(at);
      if (decided)
        (stuck ? found.largest_captured : found.smallest_separated) = at;
    };
    narrow(v * units::metres_per_second);
    if (decided)
      continue;
    for (const double side : {-1., 1.}) // the threshold is too near to tell: the nearest speeds on both sides that tell
      for (double apart = relative_width / 4;; apart *= 4) {
        const double beside = v * (1 + side * apart);
        if (!(beside > a && beside < b))
          break;
        narrow(beside * units::metres_per_second);
        if (decided)
          break;
      }
    break;
  }
  return found;
}

} // namespace ricochet
