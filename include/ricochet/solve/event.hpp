#pragma once
#include <ricochet/solve/edge/edge_limits.hpp>
#include <ricochet/solve/stepper/stepper.hpp>

#include <optional>

#include <boost/math/tools/toms748_solve.hpp>

namespace ricochet {

/// What may happen between two steps of a contact. Each has a value that is positive before and negative after.
enum class event {
  turning,       ///< the approach rate changes sign
  letting_go,    ///< fold of the static edge, infinite speed or zero radius of a free one, or zero overlap
  zero_force,    ///< end of a damped contact without adhesion
  leaving_below, ///< of the law's piece, towards smaller beta, or before the surfaces touch
  leaving_above, ///< of the law's piece, towards larger beta, or where the surfaces touch
  rolling,       ///< begins, or ends: the contact point slides no longer, or again
  yielding,      ///< the contact radius exceeds the largest so far
};
inline constexpr std::size_t event_count = 7;

/// The events that a model has, evaluated at a state; +1 for those it has not.
template <class Reduced>
class event_values {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  static constexpr bool may_lose_force = !Reduced::adhesive && !Reduced::attracted && Reduced::damped &&
                                         std::same_as<typename Reduced::model_type::end_condition, end_at_zero_force>;

public:
  explicit event_values(const Reduced& model) : limits(model), model_(model) {
    if constexpr ((Reduced::adhesive && !Reduced::free_edge) || Reduced::cohesive)
      fold_ = model.fold_coordinate();
  }

  edge_limits<Reduced> limits;

  /// `direction` in which the contact point slides.
  T value(event which, const state_type& x, int piece, bool approaching, [[maybe_unused]] int direction = 1) const {
    switch (which) {
    case event::turning:
      return approaching ? x[approach_rate] : T(-x[approach_rate]);
    case event::letting_go:
      if constexpr (Reduced::free_edge) {
        if (piece == limits.opening)
          return model_.approach_gradient(x);
        if (std::size_t(piece) != joint_count) // only the last piece opens
          return T(1);
        return opens_without_bound<decltype(Reduced::crack)> ? x[Reduced::coordinate] : model_.at(x, piece).slowness;
      } else if constexpr (Reduced::flows && Reduced::adhesive)
        return model_.at(x, piece).clock; // the fold is that of the shape
      else
        return x[Reduced::coordinate] - fold_;
    case event::zero_force:
      if constexpr (may_lose_force) { // divided by the damping coefficient, it is smooth down to zero overlap
        const auto now = model_.at(x, piece);
        if (!(value_of(x[Reduced::coordinate]) > real(0)))
          return now.c.rate;
        return model_.elastic.force(model_.pair_of(now.c), now.c) /
                   model_.damping.coefficient(model_.pair_of(now.c), now.c) +
               now.c.rate;
      }
      break;
    case event::leaving_below:
      if constexpr (edge_limits<Reduced>::exist) {
        if (piece == limits.opening)
          return limits.driven(x, piece);
        if (piece == limits.closing)
          break;
        if (piece == 0)
          return limits.above_lower(x);
      }
      if constexpr (Reduced::free_edge) {
        if (piece < 0)
          return model_.root_ratio_rate(x, -1 - piece);
        if (piece > 0)
          return model_.root_ratio(x) - root_of_joint(piece - 1);
      } else if constexpr (Reduced::cohesive) // the surfaces touch no more
        return piece == 1 ? x[Reduced::coordinate] : T(1);
      break;
    case event::leaving_above:
      if constexpr (edge_limits<Reduced>::exist) {
        if (piece == limits.closing)
          return limits.driven(x, piece);
        if (piece == limits.opening)
          break;
        if (std::size_t(piece) == joint_count)
          return limits.below_upper(x, piece);
      }
      if constexpr (Reduced::free_edge) {
        if (piece < 0)
          return -model_.root_ratio_rate(x, -piece);
        if (std::size_t(piece) < joint_count)
          return root_of_joint(piece) - model_.root_ratio(x);
      } else if constexpr (Reduced::cohesive)
        return piece == 0 ? T(-x[Reduced::coordinate]) : T(1);
      break;
    case event::rolling:
      if constexpr (Reduced::peels) // where it begins to slide from rest, round-off shall not stop it
        return direction == 0 ? model_.excess_of_friction(model_.contact(x, piece), x[surface_speed])
                              : T(T(direction) * x[slip] + T(std::numeric_limits<real>::epsilon()));
      else if constexpr (Reduced::slides)
        return x[slip];
      break;
    case event::yielding:
      if constexpr (Reduced::flows)
        if (piece == 0)
          return x[largest_coordinate] - x[Reduced::coordinate];
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

/// An event's value and its slope at a part of a step.
template <class Real>
struct event_point {
  Real part, value, slope;
};

/// Where the cubic through both points, with their slopes, falls through zero; where the tangent at the lower one does
/// if the upper one is outside the domain, its value zero. \pre low.value > 0 >= high.value
template <class Real>
Real estimated_zero(const event_point<Real>& low, const event_point<Real>& high) {
  const Real h = high.part - low.part, rise = high.value - low.value;
  const Real bend = 3 * rise - h * (2 * low.slope + high.slope), twist = h * (low.slope + high.slope) - 2 * rise;
  Real q = -low.value / (h * low.slope);
  if (high.value < Real(0) && isfinite(bend) && isfinite(twist)) {
    const auto cubic = [&](const Real& r) -> Real { return low.value + r * (h * low.slope + r * (bend + r * twist)); };
    const auto close = [](const Real& from, const Real& to) { return to - from < Real(1e-6f) * to; };
    std::uintmax_t iterations = 60;
    q = boost::math::tools::toms748_solve(cubic, Real(0), Real(1), low.value, high.value, close, iterations).second;
  }
  return low.part + h * (q > Real(0) && q < Real(1) ? q : Real(0.5f));
}

/// An event found within a step: the part of the step after which it happens, and the state there. `valid` is false for
/// one that this step is too long to bracket.
template <class State, class Real>
struct found_event {
  std::optional<event> which;
  Real part;
  State x;
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
  edge_limits<model_type>& limits() { return values_.limits; }
  void disarm(event which) { armed_[std::size_t(which)] = false; }

  /// The earliest armed event within the step tried. Each event is looked for only up to the earliest found so far,
  /// where its value is taken anew: past the end of a contact, the values of other events mean nothing.
  template <class Method>
  found_event<state_type, real> first(Method& method, const state_type& x, const attempt<state_type, real>& tried) {
    found_event<state_type, real> found{std::nullopt, tried.taken, tried.x, true};
    for (const event which : {event::letting_go, event::zero_force, event::turning, event::leaving_below,
                              event::leaving_above, event::rolling, event::yielding}) {
      const bool leaving = which == event::leaving_below || which == event::leaving_above;
      if (leaving && flow_.least_clock > 0) // the step has taken each piece of the law on its own side
        continue;
      if (!armed_[std::size_t(which)] || value_of(value(which, found.x)) > real(0))
        continue;
      if (!(value_of(value(which, x)) > real(0)))
        return {which, found.part, x, false};
      const auto before = found;
      locate(which, method, x, found);
      if (before.which == event::letting_go && !(value_of(value(event::letting_go, found.x)) > real(0)))
        found = before; // at the very end of the contact: it lets go all the same
    }
    return found;
  }

private:
  using point = event_point<real>;

  /// Locates the event between x and found.x: by cubics until close, then by a Newton step in the full scalar type, so
  /// that derivatives come out.
  template <class Method>
  void locate(event which, Method& method, const state_type& x, found_event<state_type, real>& found) {
    // How close, in parts of the step, the last Newton step may start: it leaves the motion by the square of that,
    // which more digits than double's would show, and derivatives by itself.
    const real close_enough = std::same_as<T, real>
                                  ? std::min<real>(real(1e-7f), 7 * sqrt(std::numeric_limits<real>::epsilon()))
                                  : real(1e-13f);
    const real h = found.part, round_off = std::numeric_limits<real>::epsilon() * h;
    state_type here = x, slope{};
    const auto look = [&](const real& part, const real& side) -> point { // slope by a difference to one side
      flow_(here, slope, real(0));
      const real step = side * h * sqrt(std::numeric_limits<real>::epsilon());
      state_type beside = here;
      for (std::size_t i = 0; i < x.size(); ++i)
        beside[i] += step * slope[i];
      const real value_here = value_of(value(which, here));
      return {part, value_here, (value_of(value(which, beside)) - value_here) / step};
    };
    point low = look(0, 1);
    here = found.x;
    point high = look(h, -1);
    for (int tries = 1; tries <= 100; ++tries) {
      const real part = tries % 4 == 0 ? real((low.part + high.part) / 2) : estimated_zero(low, high);
      here = method.within(flow_, x, part);
      const point now = look(part, -1);
      const bool close = abs(now.value) < close_enough * h * abs(now.slope);
      (now.value > real(0) ? low : high) = now;
      if (!close && high.part - low.part > 4 * round_off)
        continue;
      const T correction = close ? T(-value(which, here) / now.slope) : T(0);
      for (std::size_t i = 0; i < x.size(); ++i)
        here[i] += correction * slope[i];
      found = {which, std::clamp<real>(part + value_of(correction), round_off, h - round_off), here, true};
      return;
    }
    found.valid = false;
  }

  T value(event which, const state_type& x) const {
    return values_.value(which, x, flow_.piece, approaching_, flow_.direction);
  }

  Flow& flow_;
  event_values<model_type> values_;
  std::array<bool, event_count> armed_{};
  bool approaching_ = true;
};

} // namespace ricochet
