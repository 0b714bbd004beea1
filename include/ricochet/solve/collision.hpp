#pragma once
#include <ricochet/solve/event.hpp>
#include <ricochet/solve/observers.hpp>
#include <ricochet/solve/rosenbrock.hpp>

namespace ricochet {

/// One collision of a reduced model at one step tolerance, from first touch through every contact to its ending.
template <class Reduced, class Stepper>
class collision {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  using flow_type = flow<Reduced>;
  using method_type = typename Stepper::template method<flow_type>;
  static constexpr requests asked = Reduced::model_type::asked;

public:
  using outcome_type = reduced_outcome_of<T, typename Reduced::model_type>;

  collision(const Reduced& model, const real& tolerance, long budget)
      : model_(model), flow_{model}, events_(model), tolerance_(tolerance), budget_(budget), typical_(model.typical()),
        longest_step_(model.typical_time() * longest_relative_step(tolerance)) {}

  outcome_type solve(const T& speed) {
    initial_energy_ = model_.kinetic_energy(speed);
    largest_energy_ = value_of(initial_energy_);
    state_type x = model_.touch(speed);
    for (;; ++out_.contacts) {
      touched(x);
      if (captured_ || !follow_contact(x))
        break;
      if (value_of(x[approach_rate]) < real(0)) {
        out_.ending = ending::separated;
        out_.restitution = T(-x[approach_rate] / speed);
        break;
      }
      near_miss_ = std::min<real>(near_miss_, value_of(x[approach_rate]) / value_of(speed));
      x = next_touch(x); // the edge let go while the bodies were approaching: they fly freely and touch again
    }
    if (captured_)
      out_.ending = ending::captured;
    finish(x);
    return out_;
  }

  /// Kinetic + elastic + surface energy at the ending.
  const T& remaining_energy() const { return remaining_; }
  /// Potential energy at the first turning point.
  const T& energy_at_turning() const { return energy_at_turning_; }
  /// Approach rate over the impact's speed where the edge first let go of bodies that were approaching; infinite if
  /// never.
  const real& near_miss() const { return near_miss_; }
  /// Largest energy met, kinetic or potential.
  const real& largest_energy() const { return largest_energy_; }

private:
  void touched(const state_type& x) {
    flow_.piece = 0;
    approaching_ = true;
    const T potential = model_.potential(model_.at(x, 0).c);
    if constexpr (asked.ledger)
      jumps_at_edge_ -= potential;
    meet_energy(potential);
    if (has_turned_)
      certify(x);
    watch_.touched(model_, x);
  }

  /// Integrates until the contact lets go; false where the collision has ended otherwise.
  bool follow_contact(state_type& x) {
    method_type method(tolerance_, typical_);
    std::array<bool, event_count> armed{};
    arm(armed, x);
    armed[std::size_t(event::letting_go)] = Reduced::adhesive; // without adhesion the overlap starts at zero
    real h = longest_step_ / 32;
    kink_ = kink{.closest = sqrt(tolerance_) / 16};
    for (;;) {
      h = kink_->graded(std::min<real>(h, longest_step_), time_to_kink(x));
      if (flow_.evaluations > budget_) {
        out_.ending = ending::unresolved;
        out_.reason = "the budget of evaluations was spent";
        return false;
      }
      if (!(h > smallest_step())) {
        out_.ending = ending::failed;
        out_.reason = "the step size fell below round-off";
        return false;
      }
      auto tried = method.try_step(flow_, x, h);
      if (!tried.accepted) {
        ++out_.rejected_steps;
        h = tried.next;
        continue;
      }
      const auto [which, part, valid] = first_event(method, armed, x, tried);
      if (!valid) { // an event that cannot be bracketed within this step: look closer
        ++out_.rejected_steps;
        h = tried.taken / 4;
        continue;
      }
      const bool happened = part < tried.taken;
      if (happened && is_kink(*which) &&
          part > 2 * kink_->closest) { // the motion is not smooth there: come closer first
        ++out_.rejected_steps;
        h = part * 3 / 4;
        continue;
      }
      state_type reached = happened ? method.within(flow_, x, part) : tried.x;
      if (happened)
        polish(*which, reached, part);
      if (happened && *which == event::letting_go && !may_let_go(reached)) {
        ++out_.rejected_steps;
        h = tried.taken / 4;
        continue;
      }
      watch_.stepped(flow_, method, x, reached, part);
      x = reached;
      method.moved();
      if (!happened) {
        h = tried.next;
        kink_->since += part;
        arm(armed, x);
        continue;
      }
      h = std::max<real>(tried.taken - part, tried.taken / 16);
      kink_->since += part;
      if (is_kink(*which))
        kink_->crossed();
      switch (*which) {
      case event::letting_go:
      case event::zero_force:
        let_go(x);
        return true;
      case event::turning:
        approaching_ = !approaching_;
        if (!std::exchange(has_turned_, true))
          energy_at_turning_ = model_.potential(model_.at(x, flow_.piece).c);
        watch_.turned(model_, x, flow_.piece);
        certify(x);
        break;
      default:
        cross_joint(*which, x);
      }
      armed.fill(false);
      arm(armed, x);
      if (captured_ && !waits_for_largest_radius())
        return false;
    }
  }

  /// Steps shrink towards a kink of the edge's speed and grow away from it in proportion to their distance.
  struct kink {
    real closest; ///< distance, in slowed time, at which the kink is stepped onto
    real since = std::numeric_limits<real>::infinity();
    int crossings = 0;

    real graded(const real& h, const real& ahead) const {
      const real towards = ahead > closest ? ahead * real(0.25) : 2 * closest;
      return std::min<real>({h, towards, std::max<real>(real(0.7) * since, closest)});
    }

    /// An edge crossing again and again relaxes faster than these steps resolve: come closer.
    void crossed() {
      since = 0;
      if (++crossings > 4 && crossings < 16)
        closest /= 4;
    }
  };

  /// Slowed time in which the edge comes to rest, by linear extrapolation; infinite if it does not.
  real time_to_kink(const state_type& x) const {
    if constexpr (Reduced::free_edge)
      if (flow_.piece >= 0) {
        const real gap = value_of(model_.at(x, flow_.piece).root_ratio) - real(1);
        const real time = -gap / value_of(model_.root_ratio_rate(x, flow_.piece));
        if (time > real(0))
          return time;
      }
    return std::numeric_limits<real>::infinity();
  }

  struct found_event {
    std::optional<event> which;
    real part;
    bool valid;
  };

  /// The earliest armed event within the step. Each event is looked for only up to the earliest found so far, where its
  /// value is taken anew: past the end of a contact, the values of other events mean nothing.
  found_event first_event(method_type& method, const std::array<bool, event_count>& armed, const state_type& x,
                          const attempt<state_type, real>& tried) {
    found_event first{std::nullopt, tried.taken, true};
    state_type last = tried.x;
    for (const event which :
         {event::letting_go, event::zero_force, event::turning, event::leaving_below, event::leaving_above}) {
      const auto value = [&](const state_type& at) -> real {
        return value_of(events_.value(which, at, flow_.piece, approaching_));
      };
      const real at_end = value(last);
      if (!armed[std::size_t(which)] || at_end > real(0))
        continue;
      const real at_start = value(x);
      if (!(at_start > real(0)))
        return {which, first.part, false};
      const real part =
          locate_event([&](const real& h) { return value(method.within(flow_, x, h)); }, first.part, at_start, at_end);
      first = {which, std::min<real>(part, tried.taken * (1 - std::numeric_limits<real>::epsilon())), true};
      last = method.within(flow_, x, first.part);
    }
    return first;
  }

  /// One Newton step onto the event in the full scalar type, so that derivatives come out.
  void polish(event which, state_type& x, const real& h) {
    state_type dx{}, ahead = x;
    flow_(x, dx, real(0));
    const real step = h * real(1e-6);
    for (std::size_t i = 0; i < x.size(); ++i)
      ahead[i] += step * dx[i];
    const T value = events_.value(which, x, flow_.piece, approaching_);
    const real slope = (value_of(events_.value(which, ahead, flow_.piece, approaching_)) - value_of(value)) / step;
    if (slope == real(0))
      return;
    const T correction = -value / slope;
    if (abs_value(correction) < step)
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += correction * dx[i];
  }

  /// An event may happen once its value has been seen positive.
  void arm(std::array<bool, event_count>& armed, const state_type& x) {
    for (std::size_t i = 0; i < event_count; ++i)
      armed[i] = armed[i] || value_of(events_.value(event{int(i)}, x, flow_.piece, approaching_)) > real(0);
  }

  bool may_let_go(const state_type& x) const {
    if constexpr (Reduced::free_edge) {
      const bool opening = std::size_t(flow_.piece) == decltype(Reduced::crack)::joints.size();
      return opening && model_.past_fold(model_.at(x, flow_.piece).c);
    } else {
      return value_of(x[approach_rate]) < real(0);
    }
  }

  /// At beta = 1 the edge rests and its speed is not smooth: d(beta)^n with n little above one.
  bool is_kink(event which) const {
    if constexpr (Reduced::free_edge) {
      const auto& joints = decltype(Reduced::crack)::joints;
      const int joint = which == event::leaving_above ? flow_.piece : flow_.piece - 1;
      return (which == event::leaving_above || which == event::leaving_below) && flow_.piece >= 0 &&
             joints[std::size_t(joint)] == 1;
    } else {
      return false;
    }
  }

  /// The edge passes to the neighbouring piece of its law, or is held at the joint where both pieces push it back.
  void cross_joint(event which, const state_type& x) {
    if constexpr (Reduced::free_edge) {
      const int from = flow_.piece;
      if (from < 0) { // no longer held: leaving_below means that the lower piece takes over
        flow_.piece = which == event::leaving_below ? -1 - from : -from;
        return;
      }
      const bool up = which == event::leaving_above;
      const int joint = up ? from : from - 1, to = up ? from + 1 : from - 1;
      const bool pushed_back = !is_kink(which) && (value_of(model_.root_ratio_rate(x, to)) > real(0)) != up;
      flow_.piece = pushed_back ? Reduced::sliding(joint) : to;
    }
  }

  /// Losses never are negative: once the energy left is below what the contact has where it lets go, it never will.
  void certify(const state_type& x) {
    const auto c = model_.at(x, flow_.piece).c;
    const T left = model_.kinetic_energy(c.rate) + model_.potential(c) - model_.exit_energy();
    meet_energy(model_.potential(c));
    captured_ = Reduced::adhesive && value_of(left) < real(0);
  }

  /// A free edge goes on growing after the turning point; where its largest radius was asked for, it is waited for.
  bool waits_for_largest_radius() const {
    if constexpr (Reduced::free_edge && asked.extremes) {
      const auto& joints = decltype(Reduced::crack)::joints;
      const std::size_t next = std::size_t(flow_.piece < 0 ? -1 - flow_.piece : flow_.piece); // joint above
      return next < joints.size() && joints[next] <= 1;
    } else {
      return false;
    }
  }

  void let_go(const state_type& x) {
    const T left = model_.potential(model_.at(x, flow_.piece).c);
    meet_energy(left);
    if constexpr (asked.ledger)
      (Reduced::adhesive ? jumps_at_edge_ : relaxed_in_bulk_) += left;
  }

  state_type next_touch(const state_type& x) {
    state_type next = model_.touch(x[approach_rate]);
    if constexpr (Reduced::keeps_time)
      next[elapsed_time] = x[elapsed_time] - model_.at(x, flow_.piece).c.approach / x[approach_rate];
    if constexpr (asked.ledger && Reduced::damped)
      next[bulk_loss] = x[bulk_loss];
    if constexpr (asked.ledger && Reduced::free_edge)
      next[crack_loss] = x[crack_loss];
    return next;
  }

  void meet_energy(const T& potential) { largest_energy_ = std::max<real>(largest_energy_, abs(value_of(potential))); }

  /// Beyond it no error estimate is to be believed. It shrinks with the tolerance, so that two solutions at different
  /// tolerances never share the errors of their longest steps.
  static real longest_relative_step(const real& tolerance) {
    return std::min<real>(real(0.4), sqrt(sqrt(sqrt(tolerance))));
  }
  real smallest_step() const { return std::numeric_limits<real>::epsilon() * longest_step_ / 4; }
  static real abs_value(const T& x) { return value_of(x) < real(0) ? real(-value_of(x)) : real(value_of(x)); }

  /// Fills in what the model asks for; energies in units of the initial kinetic energy.
  void finish(const state_type& x) {
    const auto c = model_.at(x, flow_.piece).c;
    remaining_ = model_.kinetic_energy(c.rate);
    if (out_.ending != ending::separated) // of separated bodies, what was stored has been booked as lost
      remaining_ += model_.potential(c);
    out_.evaluations = flow_.evaluations;
    watch_.report(out_);
    if constexpr (Reduced::keeps_time && asked.duration)
      out_.contact_duration = x[elapsed_time];
    if constexpr (asked.ledger) {
      T crack = jumps_at_edge_, bulk = relaxed_in_bulk_;
      if constexpr (Reduced::free_edge)
        crack += x[crack_loss];
      if constexpr (Reduced::damped)
        bulk += x[bulk_loss];
      out_.crack_loss = crack / initial_energy_;
      out_.bulk_loss = bulk / initial_energy_;
      out_.remaining_energy = remaining_ / initial_energy_;
      out_.ledger_residual = (initial_energy_ - remaining_ - crack - bulk) / largest_energy_;
    }
  }

  const Reduced& model_;
  [[no_unique_address]] observers<Reduced, method_type> watch_;
  flow_type flow_;
  event_values<Reduced> events_;
  real tolerance_;
  long budget_;
  state_type typical_;
  real longest_step_;
  std::optional<kink> kink_;
  outcome_type out_;
  bool approaching_ = true, has_turned_ = false, captured_ = false;
  T initial_energy_ = T(0), energy_at_turning_ = T(0), remaining_ = T(0), jumps_at_edge_ = T(0),
    relaxed_in_bulk_ = T(0);
  real largest_energy_ = 0, near_miss_ = std::numeric_limits<real>::infinity();
};

} // namespace ricochet
