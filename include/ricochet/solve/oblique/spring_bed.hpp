#pragma once
#include <ricochet/law/tangential/tangential_law.hpp>

#include <vector>

namespace ricochet {

/// The contact of a law that sticks and slips as a bed of springs. A spring is set where the contact's edge is at an
/// instant of loading, unstretched, and lifted when the edge has come back to it; in between it stretches as the
/// contact point moves, at most as far as friction holds it. So the stretches hold the whole history of loading,
/// partial slip and reversals. Source: Popov & Hess 2015, chapter 5; for a parabola the exact solution of Cattaneo and
/// Mindlin.
template <class T, class Law>
class spring_bed {
  using real = real_of<T>;
  using part = configuration<reduced<T>>;

public:
  spring_bed(const Law& law, const basic_pair<reduced<T>>& pair) : law_(law), stiffness_(law.stiffness(pair)) {
    touch();
  }

  /// The bodies touch, for the first time or anew.
  void touch() { springs_.assign(1, spring{}); }

  /// The contact point has moved by `moved` since the last call, and the contact is as it is now.
  /// back: how far slipping springs have come back from friction's limit, forwards and backwards, where they began to
  /// stick within the move; \returns force along the surface, against the motion that stretched the springs
  T force(const part& c, const T& moved, const T& back_forwards = T(0), const T& back_backwards = T(0)) {
    follow_edge(c);
    if (springs_.empty())
      return T(0);
    T sum = T(0), last = T(0);
    std::size_t sticking = springs_.size(); // the outermost that sticks: slip always comes from the edge
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      spring& each = springs_[i];
      const T held = law_.largest_stretch(c.approach - each.approach), free = each.stretch + moved;
      const T highest = less(held, back_forwards), lowest = -less(held, back_backwards);
      each.stretch = value_of(free) > value_of(highest) ? highest : value_of(free) < value_of(lowest) ? lowest : free;
      if (abs(value_of(each.stretch)) < value_of(held))
        sticking = i;
      sum += each.inner * last + each.outer * each.stretch;
      last = each.stretch;
    }
    sticks_ = sticking < springs_.size();
    const spring edge = after(springs_.back().radius, c);
    sum += edge.inner * last;
    if (sticks_)
      sum += border(sticking, edge, c.approach);
    return T(2) * stiffness_ * sum; // both sides of the middle
  }

  bool sticks() const { return sticks_; } ///< somewhere in the contact, when last there was one

private:
  struct spring {
    T radius = T(0), approach = T(0); ///< where it stands, and the approach from which on it is pressed
    T stretch = T(0);
    T inner = T(0), outer = T(0); ///< weights of the one before it and of itself in the integral between both
  };

  void follow_edge(const part& c) {
    while (!springs_.empty() && value_of(springs_.back().approach) >= value_of(c.approach))
      springs_.pop_back();
    if (value_of(c.rate) >= real(0) && !springs_.empty())
      springs_.push_back(after(springs_.back().radius, c));
  }

  static T less(const T& held, const T& back) { return value_of(held) > value_of(back) ? T(held - back) : T(0); }

  static spring after(const T& last, const part& edge) {
    const T outer = outer_weight(last, edge.radius);
    return {edge.radius, edge.approach, T(0), edge.radius - last - outer, outer};
  }

  /// What the sum lacks between the outermost spring that sticks and the next one, which slips: the stretches have a
  /// corner there, where those that stick, continued, come to what friction holds.
  T border(std::size_t sticking, const spring& edge, const T& approach) const {
    const spring& in = springs_[sticking];
    const spring& out = sticking + 1 < springs_.size() ? springs_[sticking + 1] : edge;
    if (sticking == 0) // nothing to be continued
      return T(0);
    const spring& further_in = springs_[sticking - 1];
    const T slope = (in.stretch - further_in.stretch) / (in.approach - further_in.approach);
    const bool backwards = value_of(out.stretch == T(0) ? in.stretch : out.stretch) < real(0);
    const T held = law_.largest_stretch(approach - in.approach), depth = out.approach - in.approach;
    const T gap = held - (backwards ? T(-in.stretch) : in.stretch);
    const T closing = law_.largest_stretch(T(1)) + (backwards ? T(-slope) : slope);
    if (!(value_of(gap) < value_of(closing * depth)))
      return T(0);
    const T part = gap / (closing * depth);
    const T radius = sqrt(in.radius * in.radius + part * (out.radius - in.radius) * (out.radius + in.radius));
    const T corner = in.stretch + slope * part * depth;
    return integral(in.radius, in.stretch, radius, corner) + integral(radius, corner, out.radius, out.stretch) -
           integral(in.radius, in.stretch, out.radius, out.stretch);
  }

  static T integral(const T& from, const T& first, const T& to, const T& last) {
    const T outer = outer_weight(from, to);
    return (to - from - outer) * first + outer * last;
  }

  /// Of a function linear in x^2, as the stretches of slipping springs are: so |F_t| <= f F_N to round-off.
  static T outer_weight(const T& from, const T& to) { return (to - from) * (to + T(2) * from) / (T(3) * (to + from)); }

  Law law_;
  T stiffness_;
  std::vector<spring> springs_;
  bool sticks_ = true;
};

} // namespace ricochet
