// What a method of integration offers to the solver: one step with an estimate of its error, a part of the step tried
// last, and the size of the next. Made of odeint steppers: ricochet's own (tsitouras_papakostas.hpp,
// runge_kutta_gill.hpp), odeint's (steppers.hpp); radau.hpp for stiff motions; stepper::automatic (automatic.hpp)
// is what collide() takes by itself.
#pragma once
#include <ricochet/solve/flow.hpp>

#include <algorithm>
#include <functional>

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>

namespace ricochet {

/// Outcome of one attempt to step: the new state, or the step to try instead.
template <class State, class Real>
struct attempt {
  bool accepted;
  State x;
  Real taken; ///< size of the step tried
  Real next;  ///< size of the next step, or of the next try
};

namespace stepper {
namespace odeint = boost::numeric::odeint;

/// Largest error of a component over its typical size and the tolerance; infinite outside the domain.
template <class State, class Real>
Real error_norm(const State& error, const State& typical, const Real& tolerance, bool outside) {
  Real largest = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const Real relative = abs(value_of(error[i])) / (value_of(typical[i]) * tolerance);
    if (!isfinite(relative))
      return std::numeric_limits<Real>::infinity();
    largest = std::max(largest, relative);
  }
  return outside ? std::numeric_limits<Real>::infinity() : largest;
}

/// Step size from the error of the last one, for a method whose local error goes as h^order.
template <class Real>
Real resized(const Real& h, const Real& error, int order) {
  if (!isfinite(error))
    return h / 4;
  if (error <= Real(0))
    return h * 5;
  return h * std::clamp<Real>(Real(0.9) * pow(error, Real(-1) / Real(order)), Real(0.1), Real(5));
}

/// Any explicit stepper with an error estimate, given as Pair<state, number>: odeint's concept Error Stepper.
template <template <class State, class Real> class Pair>
struct embedded {
  /// Error of a whole collision's energy to be reckoned with, in units of the step tolerance, unless found larger.
  static constexpr double usual_error = 0.35;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using stepper_type = Pair<state_type, real>;
    static constexpr bool first_same_as_last =
        std::is_base_of_v<odeint::explicit_error_stepper_fsal_tag, typename stepper_type::stepper_category>;

  public:
    method(const real& tolerance, const state_type& typical) : tolerance_(tolerance), typical_(typical) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      if (!known_)
        f(x, slope_, real(0));
      known_ = true;
      f.outside = false;
      state_type out{}, error{};
      if constexpr (first_same_as_last)
        stepper_.do_step(std::ref(f), x, slope_, real(0), out, last_slope_, h, error);
      else
        stepper_.do_step(std::ref(f), x, slope_, real(0), out, h, error);
      const real norm = error_norm(error, typical_, tolerance_, f.outside);
      return {norm <= 1, out, h, resized(h, norm, stepper_type::error_order_value + 1)};
    }

    /// The state after a part h of the step tried last.
    state_type within(Flow& f, const state_type& x, const real& h) {
      state_type out{};
      if constexpr (first_same_as_last)
        stepper_.do_step(std::ref(f), x, slope_, real(0), out, last_slope_, h);
      else
        stepper_.do_step(std::ref(f), x, slope_, real(0), out, h);
      return out;
    }

    /// To be called whenever the state has moved.
    void moved() { known_ = false; }

  private:
    stepper_type stepper_;
    real tolerance_;
    state_type typical_, slope_{}, last_slope_{};
    bool known_ = false;
  };
};

/// Any explicit stepper without an error estimate, given as Method<state, number>: odeint's concept Stepper. The error
/// is that of one step against two halves.
template <template <class State, class Real> class Method>
struct doubled {
  static constexpr double usual_error = 1.3;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using stepper_type = Method<state_type, real>;

  public:
    method(const real& tolerance, const state_type& typical) : tolerance_(tolerance), typical_(typical) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      f.outside = false;
      state_type whole{};
      stepper_.do_step(std::ref(f), x, real(0), whole, h);
      const state_type out = within(f, x, h);
      state_type error{};
      for (std::size_t i = 0; i < out.size(); ++i)
        error[i] = (out[i] - whole[i]) / real((1 << stepper_.order()) - 1);
      const real norm = error_norm(error, typical_, tolerance_, f.outside);
      return {norm <= 1, out, h, resized(h, norm, int(stepper_.order()) + 1)};
    }

    state_type within(Flow& f, const state_type& x, const real& h) {
      state_type half{}, out{};
      stepper_.do_step(std::ref(f), x, real(0), half, real(h / 2));
      stepper_.do_step(std::ref(f), half, real(0), out, real(h / 2));
      return out;
    }

    void moved() {}

  private:
    stepper_type stepper_;
    real tolerance_;
    state_type typical_;
  };
};

} // namespace stepper
} // namespace ricochet
