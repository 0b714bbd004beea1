#pragma once
#include <ricochet/solve/flow.hpp>

#include <boost/math/tools/toms748_solve.hpp>

namespace ricochet {

/// What may happen between two steps of a contact. Each has a value that is positive before and negative after.
enum class event {
  turning,       ///< the approach rate changes sign
  letting_go,    ///< fold of the static edge, infinite speed of a free one, or zero overlap without adhesion
  zero_force,    ///< end of a damped contact without adhesion
  leaving_below, ///< of the crack law's piece, towards smaller beta
  leaving_above, ///< of the crack law's piece, towards larger beta
};
inline constexpr std::size_t event_count = 5;

/// The events that a model has, evaluated at a state; +1 for those it has not.
template <class Reduced>
class event_values {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  static constexpr bool may_lose_force = !Reduced::adhesive && Reduced::damped &&
                                         std::same_as<typename Reduced::model_type::end_condition, end_at_zero_force>;

public:
  explicit event_values(const Reduced& model) : model_(model) {
    if constexpr (Reduced::adhesive && !Reduced::free_edge)
      fold_ = model.fold_coordinate();
  }

  T value(event which, const state_type& x, int piece, bool approaching) const {
    switch (which) {
    case event::turning:
      return approaching ? x[approach_rate] : T(-x[approach_rate]);
    case event::letting_go:
      if constexpr (Reduced::free_edge)
        return piece < 0 ? T(1) : model_.at(x, piece).slowness;
      else
        return x[Reduced::coordinate] - fold_;
    case event::zero_force:
      if constexpr (may_lose_force) { // divided by the damping coefficient, it is smooth down to zero overlap
        const auto now = model_.at(x, piece);
        if (!(value_of(x[Reduced::coordinate]) > real(0)))
          return now.c.rate;
        return model_.elastic.force(model_.pair, now.c) / model_.damping.coefficient(model_.pair, now.c) + now.c.rate;
      }
      break;
    case event::leaving_below:
      if constexpr (Reduced::free_edge) {
        if (piece < 0)
          return model_.root_ratio_rate(x, -1 - piece);
        if (piece > 0)
          return model_.at(x, piece).root_ratio - root_of_joint(piece - 1);
      }
      break;
    case event::leaving_above:
      if constexpr (Reduced::free_edge) {
        if (piece < 0)
          return -model_.root_ratio_rate(x, -piece);
        if (std::size_t(piece) < joint_count)
          return root_of_joint(piece) - model_.at(x, piece).root_ratio;
      }
      break;
    }
    return T(1);
  }

private:
  static constexpr std::size_t joint_count = [] {
    if constexpr (Reduced::free_edge)
      return decltype(Reduced::crack)::joints.size();
    else
      return std::size_t(0);
  }();
  static T root_of_joint(int joint) { return T(sqrt(real(decltype(Reduced::crack)::joints[std::size_t(joint)]))); }

  const Reduced& model_;
  T fold_ = T(0);
};

/// Part of a step of size h after which `value_at(part)` falls through zero; it is positive at 0 and negative at h.
/// Located to round-off of h, on the side where the event has not happened yet.
template <class Real, class ValueAt>
Real locate_event(const ValueAt& value_at, const Real& h, const Real& at_start, const Real& at_end) {
  namespace tools = boost::math::tools;
  std::uintmax_t iterations = 100;
  const auto bracket = tools::toms748_solve(
      value_at, Real(0), h, at_start, at_end,
      [h](const Real& low, const Real& high) { return high - low <= 4 * std::numeric_limits<Real>::epsilon() * h; },
      iterations);
  return bracket.first;
}

} // namespace ricochet
