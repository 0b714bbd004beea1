// odeint's steppers for collide(), and Gill's; stepper.hpp says what a method is.
#pragma once
#include <ricochet/model/odeint.hpp>
#include <ricochet/solve/stepper/runge_kutta_gill.hpp>
#include <ricochet/solve/stepper/stepper.hpp>

#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace ricochet::stepper {

/// odeint's class templates of explicit steppers on packed states.
template <template <class...> class Stepper>
struct of_odeint {
  template <class State, class Real>
  using on =
      Stepper<State, Real, State, Real, odeint::array_algebra, odeint::default_operations, odeint::never_resizer>;
};

/// Any of odeint's explicit steppers with an error estimate: embedded_of_odeint<odeint::runge_kutta_dopri5>.
template <template <class...> class Stepper>
using embedded_of_odeint = embedded<of_odeint<Stepper>::template on>;

using cash_karp54 = embedded_of_odeint<odeint::runge_kutta_cash_karp54>;
using dopri5 = embedded_of_odeint<odeint::runge_kutta_dopri5>;
using fehlberg78 = embedded_of_odeint<odeint::runge_kutta_fehlberg78>;

/// Any of odeint's explicit steppers without one: doubled_of_odeint<odeint::runge_kutta4>.
template <template <class...> class Stepper>
using doubled_of_odeint = doubled<of_odeint<Stepper>::template on>;

using runge_kutta4 = doubled_of_odeint<odeint::runge_kutta4>;

namespace detail {

/// The state a time h from x, in as many steps of a copy of odeint's bulirsch_stoer as it takes.
template <class Extrapolation, class Flow>
typename Flow::state_type extrapolated(Extrapolation stepper, Flow& f, typename Flow::state_type x,
                                       const typename Flow::real& h) {
  using real = typename Flow::real;
  typename Flow::state_type out{};
  real t = 0, next = h;
  for (int tries = 0; tries < 32; ++tries) {
    next = std::min<real>(next, h - t);
    if (stepper.try_step(std::ref(f), x, t, out, next) == odeint::success)
      x = out;
    if (!(t < h))
      return x;
  }
  x.fill(std::numeric_limits<real>::quiet_NaN()); // it gets no further: the event is to be sought in less
  return x;
}

} // namespace detail

/// odeint's Bulirsch-Stoer extrapolation, which controls its own step.
struct bulirsch_stoer {
  static constexpr double usual_error = 1.3;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using stepper_type = odeint::bulirsch_stoer<state_type, real, state_type, real, odeint::array_algebra>;

  public:
    method(const real& tolerance, const state_type&) : stepper_(tolerance, real(0), real(0), real(0)) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      f.outside = false;
      real t = 0, next = h;
      state_type out{};
      const bool done = stepper_.try_step(std::ref(f), x, t, out, next) == odeint::success;
      if (f.outside)
        return {false, x, h, h / 4};
      return {done, out, h, done ? std::min<real>(next, 8 * h) : std::min<real>(next, h / 2)};
    }

    state_type within(Flow& f, const state_type& x, const real& h) { return detail::extrapolated(stepper_, f, x, h); }

    void moved() {}

  private:
    stepper_type stepper_;
  };
};

/// The same in its form with dense output, whose steps are longer. The output itself errs more than they do, and is
/// not used: events are stepped to.
struct bulirsch_stoer_dense_out {
  static constexpr double usual_error = 1.3;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using stepper_type = odeint::bulirsch_stoer_dense_out<state_type, real, state_type, real, odeint::array_algebra>;
    using within_type = odeint::bulirsch_stoer<state_type, real, state_type, real, odeint::array_algebra>;

  public:
    method(const real& tolerance, const state_type&)
        : stepper_(tolerance, real(0), real(0), real(0), true), within_(tolerance, real(0), real(0), real(0)) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      f.outside = false;
      stepper_.initialize(x, real(0), h);
      real taken = h;
      try {
        const auto [begin, end] = stepper_.do_step(std::ref(f));
        taken = end - begin;
      } catch (const odeint::odeint_error&) { // it found no step short enough
        return {false, x, h, h / 64};
      }
      if (f.outside)
        return {false, x, taken, taken / 4};
      return {true, stepper_.current_state(), taken, stepper_.current_time_step()};
    }

    state_type within(Flow& f, const state_type& x, const real& h) { return detail::extrapolated(within_, f, x, h); }

    void moved() {}

  private:
    stepper_type stepper_;
    within_type within_;
  };
};

} // namespace ricochet::stepper
