// What is particular about following a contact whose laws have pieces: the joints between them, at some of which the
// motion has a kink. Of a free contact edge, which rests at one of them, and of a cohesive zone, where surfaces touch.
#pragma once
#include <ricochet/solve/edge/edge_limits.hpp>
#include <ricochet/solve/flow.hpp>

namespace ricochet {

/// Steps shrink towards a kink of the motion and grow away from it in proportion to their distance.
template <class Real>
struct kink_grading {
  Real closest;                                       ///< distance, in slowed time, at which the kink is stepped onto
  Real since = std::numeric_limits<Real>::infinity(); ///< distance behind the last one
  int crossings = 0;

  Real graded(const Real& h, const Real& ahead) const {
    const Real towards = ahead > closest ? ahead * 2 / 5 : 2 * closest;
    return std::min<Real>({h, towards, std::max<Real>(since * 6 / 5, closest)});
  }

  /// An edge crossing again and again relaxes faster than these steps resolve: come closer.
  void crossed() {
    since = 0;
    if (++crossings > 4 && crossings < 16)
      closest /= 4;
  }
};

/// Questions about the edge of a reduced model while its law is on a given piece; trivial where there is one piece.
template <class Reduced>
class edge_pieces {
  using real = real_of<typename Reduced::number>;
  using state_type = typename Reduced::state_type;
  static constexpr auto joints = [] {
    if constexpr (Reduced::free_edge)
      return decltype(Reduced::crack)::joints;
    else
      return std::array<double, 0>{};
  }();

  static constexpr bool touch_is_kink = Reduced::cohesive && needs_root_radius<decltype(Reduced::model_type::damping)>;

public:
  explicit edge_pieces(const Reduced& model) : model_(model) {}

  /// Has the motion a kink at this side of the piece? Where a free edge rests, at beta = 1, its speed goes as
  /// |beta - 1|^n, n little above one; where surfaces with a cohesive zone touch, a root of the contact radius sets in.
  static bool has_kink(int piece, bool above) {
    if constexpr (touch_is_kink)
      return piece == (above ? 0 : 1);
    const int joint = above ? piece : piece - 1;
    return piece >= 0 && joint >= 0 && std::size_t(joint) < joints.size() && joints[std::size_t(joint)] == 1;
  }

  /// Slowed time to the kink, by linear extrapolation; infinite if it is not ahead.
  real time_to_kink(const state_type& x, int piece) const {
    if constexpr (touch_is_kink) {
      const real time = -value_of(x[Reduced::coordinate]) / value_of(model_.at(x, piece).coordinate_rate);
      if (time > real(0))
        return time;
    }
    if constexpr (Reduced::free_edge)
      if (piece >= 0) {
        const real gap = value_of(model_.root_ratio(x)) - real(1);
        const real time = -gap / value_of(model_.root_ratio_rate(x, piece));
        if (time > real(0))
          return time;
      }
    return std::numeric_limits<real>::infinity();
  }

  /// The piece behind the joint that is crossed; or that of an edge held at the joint, where both pieces push it back.
  int beyond(const state_type& x, int piece, bool up) const {
    if constexpr (Reduced::free_edge) {
      if constexpr (edge_limits<Reduced>::exist)
        if (const auto next = edge_limits<Reduced>::beyond(piece, up))
          return *next;
      if (piece < 0) // held no longer: the piece on that side takes over
        return up ? -piece : -1 - piece;
      const int joint = up ? piece : piece - 1, next = up ? piece + 1 : piece - 1;
      const bool pushed_back = !has_kink(piece, up) && (value_of(model_.root_ratio_rate(x, next)) > real(0)) != up;
      return pushed_back ? Reduced::sliding(joint) : next;
    } else if constexpr (Reduced::cohesive) {
      return up ? 1 : 0;
    } else {
      return piece;
    }
  }

  /// Does the contact's radius still grow?
  static bool grows(int piece) {
    if (edge_limits<Reduced>::holds(piece))
      return piece == edge_limits<Reduced>::closing;
    const std::size_t above = std::size_t(piece < 0 ? -1 - piece : piece); // the joint above
    return above < joints.size() && joints[above] <= 1;
  }

  /// A free edge lets go where it opens at infinite speed, or has no radius left, past the fold; a slaved one at its
  /// fold, on the way out.
  bool may_let_go(const state_type& x, int piece) const {
    if constexpr (Reduced::free_edge)
      return piece == edge_limits<Reduced>::opening ||
             (std::size_t(piece) == joints.size() && model_.past_fold(model_.contact(x, piece)));
    else
      return value_of(x[approach_rate]) < real(0);
  }

private:
  const Reduced& model_;
};

} // namespace ricochet
