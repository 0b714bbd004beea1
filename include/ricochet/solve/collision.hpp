#pragma once
#include <ricochet/solve/capture.hpp>
#include <ricochet/solve/edge/edge.hpp>
#include <ricochet/solve/event.hpp>
#include <ricochet/solve/ledger.hpp>
#include <ricochet/solve/oblique/sliding.hpp>
#include <ricochet/solve/oblique/stick_slip.hpp>
#include <ricochet/solve/observers.hpp>

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
      : model_(model), flow_{model}, events_(flow_), edge_(model), ledger_(model), capture_(model),
        sliding_(model, tolerance), stick_slip_(model, tolerance), tolerance_(tolerance), budget_(budget),
        longest_step_(model.typical_time() * longest_relative_step(tolerance)) {}
  collision(const collision&) = delete;

  /// \param slip speed at which the contact point slides at first touch, >= 0; of no consequence without friction
  /// \param spin of the sphere then, of no consequence without a peeling moment
  outcome_type solve(const T& speed, const T& slip_at_touch = T(0), const T& spin = T(0)) {
    ledger_.impact(speed);
    events_.limits().allow(value_of(model_.kinetic_energy(speed)), tolerance_);
    state_type x = model_.touch(speed);
    sliding_.start(x, slip_at_touch, spin);
    stick_slip_.start(slip_at_touch);
    for (;; ++out_.contacts) {
      touched(x);
      if (capture_.certain() || !follow_contact(x))
        break;
      ledger_.let_go(now(x));
      observers_.let_go(model_, ledger_, x, flow_.piece);
      if (value_of(x[approach_rate]) < real(0)) {
        out_.ending = ending::separated;
        out_.restitution = T(-x[approach_rate] / speed);
        break;
      }
      near_miss_ = std::min<real>(near_miss_, value_of(x[approach_rate]) / value_of(speed));
      x = next_touch(x); // the edge let go while the bodies were approaching: they fly freely and touch again
    }
    if (capture_.certain()) {
      out_.ending = ending::captured;
      out_.reason.clear();
    }
    out_.evaluations = flow_.evaluations;
    if constexpr (asked.duration)
      out_.contact_duration = x[elapsed_time];
    sliding_.report(out_, flow_, x);
    if constexpr (Reduced::model_type::has_friction) {
      out_.elapsed_time = x[elapsed_time];
      out_.approach_rate = x[approach_rate];
    }
    stick_slip_.report(out_);
    ledger_.close(now(x), out_.ending == ending::separated);
    ledger_.report(out_, x);
    observers_.report(out_);
    return out_;
  }

  /// Energy beyond what the contact has where it lets go: kinetic energy of separated bodies, negative when captured.
  T excess_energy() const { return capture_.held_by() ? T(-*capture_.held_by()) : ledger_.excess(); }
  /// Potential energy at the first turning point.
  const T& energy_at_turning() const { return energy_at_turning_; }
  /// Approach rate over the impact's speed where the edge first let go of bodies that were approaching; infinite if
  /// never.
  const real& near_miss() const { return near_miss_; }
  /// Energies at turning points and later touches, beyond what the contact has where it lets go.
  const std::vector<real>& margins() const { return capture_.margins(); }
  /// Share of the step tolerance that is the error of a whole collision as a rule.
  const real& usual_error() const { return usual_error_; }
  /// Largest energy met, kinetic or potential.
  const real& largest_energy() const { return ledger_.largest(); }

private:
  typename Reduced::part now(const state_type& x) const { return model_.contact(x, flow_.piece); }

  static real usual_error_of(const method_type& method) {
    if constexpr (requires { method.usual_error(); })
      return real(method.usual_error());
    else
      return real(Stepper::usual_error);
  }
  static constexpr bool follows_fast_edges = requires(const method_type& method) { method.glides(); };
  static bool glides(const method_type& method) {
    if constexpr (follows_fast_edges)
      return method.glides();
    else
      return false;
  }

  void touched(state_type& x) {
    flow_.piece = model_.first_piece();
    sliding_.touched(flow_, x);
    approaching_ = true;
    ledger_.touch(now(x));
    if (has_turned_)
      capture_.look(now(x), ledger_);
    observers_.touched(model_, ledger_, x);
    stick_slip_.touched(x);
  }

  /// Integrates until the contact lets go; false where the collision has ended otherwise.
  bool follow_contact(state_type& x) {
    method_type method(tolerance_, sliding_.sized(model_.typical()));
    const bool let_go = follow_contact(x, method);
    usual_error_ = std::max(usual_error_, usual_error_of(method));
    return let_go;
  }

  bool follow_contact(state_type& x, method_type& method) {
    kink_grading<real> kink{.closest = sqrt(tolerance_) / 16};
    on_this_way_ = 0;
    events_.restart(x, approaching_);
    if (!Reduced::adhesive) // the overlap starts at zero
      events_.disarm(event::letting_go);
    real h = longest_step_ / 32;
    const auto reject = [&](const real& shorter) {
      ++out_.rejected_steps;
      h = shorter;
    };
    while (may_go_on(h)) {
      h = std::min<real>(h, std::max<real>(longest_step_, longest_relative_step(tolerance_) * on_this_way_ / 8));
      if (!glides(method))
        h = kink.graded(h, edge_.time_to_kink(x, flow_.piece));
      const auto tried = method.try_step(flow_, x, h);
      if (!tried.accepted) {
        reject(tried.next);
        continue;
      }
      const auto found = events_.first(method, x, tried);
      if (!found.valid) { // an event that cannot be bracketed within this step: look closer
        reject(tried.taken / 4);
        continue;
      }
      if (!found.which) {
        observers_.stepped(flow_, method, ledger_, x, tried.x, tried.taken);
        stick_slip_.stepped(flow_, method, x, tried.x, tried.taken);
        x = tried.x;
        if constexpr (Reduced::attracted) // its well is deepest between touch and turning
          ledger_.meet(now(x));
        kink.since += tried.taken;
        on_this_way_ += tried.taken;
        h = tried.next;
        method.moved();
        if constexpr (Reduced::free_edge)
          if (flow_.least_clock > 0) {
            flow_.piece = model_.side_of_rest(model_.root_ratio(x), flow_.piece);
            events_.restart(x, approaching_);
          }
        events_.arm(x);
        if (capture_.is_late(x[approach_rate], has_turned_, ledger_)) {
          capture_.look_closely(now(x), ledger_);
          observers_.turned(model_, x, flow_.piece);
          if (capture_.certain())
            return false;
        }
        continue;
      }
      const event which = *found.which;
      const bool at_kink = which == event::leaving_above   ? edge_.has_kink(flow_.piece, true)
                           : which == event::leaving_below ? edge_.has_kink(flow_.piece, false)
                                                           : false;
      if (at_kink && !glides(method) &&
          found.part > 2 * kink.closest) { // the motion is not smooth there: come closer first
        reject(found.part * 3 / 4);
        continue;
      }
      if (which == event::letting_go && !edge_.may_let_go(found.x, flow_.piece)) {
        reject(tried.taken / 4);
        continue;
      }
      observers_.stepped(flow_, method, ledger_, x, found.x, found.part);
      stick_slip_.stepped(flow_, method, x, found.x, found.part);
      x = found.x;
      kink.since += found.part;
      if (at_kink)
        kink.crossed();
      method.moved();
      if (damping_drives(x)) {
        fail("the damping law's coefficient is negative: it drives the motion instead of damping it");
        return false;
      }
      if (which == event::letting_go || which == event::zero_force)
        return true;
      happened(which, x);
      if (capture_.certain() && !(asked.extremes && edge_.grows(flow_.piece)))
        return false;
      events_.restart(x, approaching_);
      h = std::max<real>(tried.taken - found.part, tried.taken / 16);
    }
    return false;
  }

  /// The contact goes on after this event.
  void happened(event which, state_type& x) {
    if constexpr (Reduced::slides)
      if (which == event::rolling)
        return sliding_.halted(flow_, x);
    if constexpr (Reduced::flows)
      flow_.set_plastic(which == event::yielding, x);
    if (which != event::turning) {
      const int next = edge_.beyond(x, flow_.piece, which == event::leaving_above);
      if constexpr (edge_limits<Reduced>::exist) {
        const auto& limits = events_.limits();
        if (limits.holds(flow_.piece))
          limits.release(x, flow_.piece);
        if (limits.holds(next)) {
          if (!(value_of(limits.driven(x, next)) > real(0))) // led there by an error: its law takes the edge back
            return;
          usual_error_ = std::max<real>(usual_error_, limits.usual_error);
        }
      }
      flow_.piece = next;
      return;
    }
    approaching_ = !approaching_;
    on_this_way_ = 0;
    if (!std::exchange(has_turned_, true))
      energy_at_turning_ = model_.potential(now(x));
    observers_.turned(model_, x, flow_.piece);
    capture_.look(now(x), ledger_);
  }

  bool may_go_on(const real& h) {
    if (flow_.evaluations > budget_) {
      out_.ending = ending::unresolved;
      out_.reason = "the budget of evaluations was spent";
      if (Reduced::free_edge && !follows_fast_edges)
        out_.reason += ", maybe on an edge too fast for this stepper: the default turns to an implicit one";
      return false;
    }
    if (!(h > std::numeric_limits<real>::epsilon() * longest_step_ / 4)) {
      fail("the step size fell below round-off, as it does where a law gives no number");
      return false;
    }
    return true;
  }

  bool damping_drives(const state_type& x) const {
    if constexpr (Reduced::damped)
      return value_of(x[Reduced::coordinate]) > real(0) &&
             value_of(model_.damping.coefficient(model_.pair_of(now(x)), now(x))) < real(0);
    else
      return false;
  }

  void fail(const char* reason) {
    out_.ending = ending::failed;
    out_.reason = reason;
  }

  state_type next_touch(const state_type& x) {
    state_type next = model_.touch(x[approach_rate]);
    if constexpr (Reduced::keeps_time) {
      const T flight = -now(x).approach / x[approach_rate];
      next[elapsed_time] = x[elapsed_time] + (value_of(flight) > 0 ? flight : T(0)); // creeping ones still overlap
    }
    if constexpr (asked.ledger && Reduced::damped)
      next[bulk_loss] = x[bulk_loss];
    if constexpr (asked.ledger && (Reduced::free_edge || Reduced::opposes_rebound))
      next[crack_loss] = x[crack_loss];
    sliding_.flew(x, next);
    return next;
  }

  /// Beyond it no error estimate is to be believed. It shrinks with the tolerance, so that two solutions at different
  /// tolerances never share the errors of their longest steps.
  static real longest_relative_step(const real& tolerance) {
    return std::min<real>(real(0.4), sqrt(sqrt(sqrt(tolerance))));
  }

  const Reduced& model_;
  flow_type flow_;
  event_watch<flow_type> events_;
  edge_pieces<Reduced> edge_;
  ledger<Reduced> ledger_;
  capture<Reduced> capture_;
  [[no_unique_address]] observers<Reduced, method_type> observers_;
  [[no_unique_address]] sliding<Reduced> sliding_;
  [[no_unique_address]] stick_slip<Reduced> stick_slip_;
  real tolerance_, usual_error_ = 0;
  long budget_;
  real longest_step_;
  real on_this_way_ = 0; ///< slowed time since touch or turning; much longer than a collision's where bodies creep
  outcome_type out_;
  bool approaching_ = true, has_turned_ = false;
  T energy_at_turning_ = T(0);
  real near_miss_ = std::numeric_limits<real>::infinity();
};

} // namespace ricochet
