// The search for the speed at which what comes of an impact changes, by looks at single speeds.
#pragma once
#include <ricochet/solve/collide.hpp>

#include <optional>

namespace ricochet::detail {

/// What one look at a speed tells. value: above the threshold, of a function that grows from zero there, smoothly; of
/// an undecided look the relative distance from where another one may tell, 0 if any may.
struct threshold_look {
  enum { below, above, undecided } side;
  double value = 0;
};

/// A bracket of a threshold, both ends of which were told by looks; all speeds in m/s. `look(v, apart)` is asked for a
/// threshold_look; `apart` is the relative distance from the threshold at which the search supposes v, 1 if it does not
/// know, 0 at the end. What is undecided leaves the bracket wider.
template <class Look>
class threshold_search {
public:
  double below = 0, above = std::numeric_limits<double>::infinity();

  explicit threshold_search(const Look& look) : look_(look) {}

  bool bracketed() const { return below > 0 && above < std::numeric_limits<double>::infinity(); }

  /// Looks at v, which becomes an end of the bracket if that tells.
  threshold_look ask(double v, double apart) {
    const threshold_look seen = look_(v, apart);
    if (seen.side == threshold_look::above) {
      above = std::min(above, v);
      std::rotate(seen_.begin(), seen_.end() - 1, seen_.end());
      seen_[0] = {v, seen.value};
      known_ = std::min(known_ + 1, seen_.size());
    } else if (seen.side == threshold_look::below)
      below = std::max(below, v);
    return seen;
  }

  /// From a guess up or down, in steps that grow, upwards to a factor of two, until there is a bracket or the end of
  /// the range is reached.
  void find(double guess, double slowest, double fastest) {
    double v = std::clamp(guess, slowest, fastest);
    for (double step = 1.2;; step *= step) {
      ask(v, 1);
      const bool up = above == std::numeric_limits<double>::infinity();
      if (bracketed() || v == (up ? fastest : slowest))
        return;
      v = up ? std::min(v * std::min(step, 2.), fastest) : std::max(v / step, slowest);
    }
  }

  /// Until the bracket is as wide as wanted, or nothing closer tells.
  void narrow(double relative_width) {
    constexpr double none = std::numeric_limits<double>::infinity();
    double last_offset = none;
    for (int slow = 0; above - below > relative_width * above;) {
      const double wanted = 0.3 * relative_width * above, width = above - below;
      double v = std::sqrt(below * above), apart = width / above, offset = none;
      if (const auto zero = estimate(); zero && slow < 3) {
        offset = std::max(wanted, zero->overshot ? 4 * last_offset : 2 * zero->error);
        const bool from_above = offset > wanted || above - zero->v > 1.5 * wanted;
        if (const double aimed = zero->v + (from_above ? offset : -offset); aimed > below && aimed < above) {
          v = aimed;
          apart = offset > wanted ? offset / above : 0;
        }
      }
      if (!(v > below && v < above)) // no number is left between
        return;
      const threshold_look seen = ask(v, apart);
      if (seen.side == threshold_look::undecided)
        return ask_beside(v, std::max(seen.value, relative_width / 4));
      slow = offset == none || offset < last_offset / 2 || above - below < width / 2 ? 0 : slow + 1;
      last_offset = offset;
    }
  }

private:
  struct point {
    double v, value;
  };
  struct zero_estimate {
    double v, error;
    bool overshot; ///< by the bracket's lower end, from which it is reckoned then
  };

  /// The speed as a polynomial of the value, at zero, by the last looks from above.
  std::optional<zero_estimate> estimate() const {
    if (known_ < 2)
      return std::nullopt;
    const auto zero_of_line = [](const point& p, const point& q) {
      return p.v - p.value * (p.v - q.v) / (p.value - q.value);
    };
    const double near = zero_of_line(seen_[0], seen_[1]);
    double v = near, error = std::abs(seen_[0].v - near) / 4;
    if (known_ == 3) {
      const double far = zero_of_line(seen_[1], seen_[2]);
      v = near - seen_[0].value * (near - far) / (seen_[0].value - seen_[2].value);
      error = std::min(error, std::abs(v - near));
    }
    if (!(v > 0 && v < above))
      return std::nullopt;
    return zero_estimate{std::max(v, below), error, v <= below};
  }

  /// v tells nothing: the nearest speeds on both sides that do, first a little apart, then ever more.
  void ask_beside(double v, double first) {
    for (const double side : {-1., 1.})
      for (double apart = first;; apart *= 4) {
        const double beside = v * std::exp(side * apart);
        if (!(beside > below && beside < above) || ask(beside, 0).side != threshold_look::undecided)
          break;
      }
  }

  const Look& look_;
  std::array<point, 3> seen_{}; ///< the latest first, which is the nearest
  std::size_t known_ = 0;
};

} // namespace ricochet::detail
