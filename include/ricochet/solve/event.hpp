#pragma once
#include <ricochet/solve/stepper.hpp>

#include <optional>

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

/// An event found within a step, and the part of the step after which it happens; `valid` is false for one that this
/// step is too long to bracket.
template <class Real>
struct found_event {
  std::optional<event> which;
  Real part;
  bool valid;
};

/// Watches a flow for the events of its model. An event can only happen once its value has been seen positive: one that
/// has just been located does not happen again by its own round-off.
template <class Flow>
class event_watch {
  using T = typename Flow::number;
  using real = typename Flow::real;
  using state_type = typename Flow::state_type;
  using model_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;

public:
  explicit event_watch(Flow& flow) : flow_(flow), values_(flow.model) {}

  /// A contact begins, or an event has just happened.
  void restart(const state_type& x, bool approaching) {
    approaching_ = approaching;
    armed_.fill(false);
    arm(x);
  }
  void arm(const state_type& x) {
    for (std::size_t i = 0; i < event_count; ++i)
      armed_[i] = armed_[i] || value_of(value(event{int(i)}, x)) > real(0);
  }
  void disarm(event which) { armed_[std::size_t(which)] = false; }

  /// The earliest armed event within the step tried. Each event is looked for only up to the earliest found so far,
  /// where its value is taken anew: past the end of a contact, the values of other events mean nothing.
  template <class Method>
  found_event<real> first(Method& method, const state_type& x, const attempt<state_type, real>& tried) {
    found_event<real> found{std::nullopt, tried.taken, true};
    state_type last = tried.x;
    for (const event which :
         {event::letting_go, event::zero_force, event::turning, event::leaving_below, event::leaving_above}) {
      const real at_end = value_of(value(which, last));
      if (!armed_[std::size_t(which)] || at_end > real(0))
        continue;
      const real at_start = value_of(value(which, x));
      if (!(at_start > real(0)))
        return {which, found.part, false};
      const real part =
          locate_event([&](const real& h) -> real { return value_of(value(which, method.within(flow_, x, h))); },
                       found.part, at_start, at_end);
      found = {which, std::min<real>(part, tried.taken * (1 - std::numeric_limits<real>::epsilon())), true};
      last = method.within(flow_, x, found.part);
    }
    return found;
  }

  /// One Newton step onto the event in the full scalar type, so that derivatives come out; h is the step's size.
  void polish(event which, state_type& x, const real& h) {
    state_type dx{}, ahead = x;
    flow_(x, dx, real(0));
    const real step = h * real(1e-6f);
    for (std::size_t i = 0; i < x.size(); ++i)
      ahead[i] += step * dx[i];
    const T here = value(which, x);
    const real slope = (value_of(value(which, ahead)) - value_of(here)) / step;
    if (slope == real(0))
      return;
    const T correction = -here / slope;
    if (value_of(correction) < step && -value_of(correction) < step)
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += correction * dx[i];
  }

private:
  T value(event which, const state_type& x) const { return values_.value(which, x, flow_.piece, approaching_); }

  Flow& flow_;
  event_values<model_type> values_;
  std::array<bool, event_count> armed_{};
  bool approaching_ = true;
};

} // namespace ricochet
