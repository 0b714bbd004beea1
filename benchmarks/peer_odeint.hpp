// Collisions as a competent user of Boost.Odeint computes them: dopri5 or Bulirsch-Stoer, in coordinates as the papers
// have them. Two ways to find the end: dense output and bisection, or steps and Newton's method.
#pragma once
#include "peer_equations.hpp"

#include <functional>

#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/generation/make_dense_output.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace peer {
namespace odeint = boost::numeric::odeint;

template <class System>
bool has_ended(const System& system, const typename System::state& x) {
  return system.may_end(x) && system.event(x) <= 0;
}

/// Restitution with a stepper of dense output, by bisection; 0 where it has not ended after `longest`.
template <class Stepper, class System>
double by_dense_output(Stepper stepper, const System& system, double speed, double longest) {
  stepper.initialize(system.start(speed), 0., 1e-2);
  while (stepper.current_time() < longest) {
    auto [low, high] = stepper.do_step(std::cref(system));
    if (!has_ended(system, stepper.current_state()))
      continue;
    typename System::state x;
    while (high - low > 1e-14 * high) {
      const double middle = (low + high) / 2;
      if (middle == low || middle == high)
        break;
      stepper.calc_state(middle, x);
      (has_ended(system, x) ? high : low) = middle;
    }
    stepper.calc_state(low, x);
    return -x[1] / speed;
  }
  return 0;
}

template <class System>
double dopri5_bisection(const System& system, double speed, double tolerance, double longest) {
  return by_dense_output(
      odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<typename System::state>()), system,
      speed, longest);
}

template <class System>
double bulirsch_stoer_bisection(const System& system, double speed, double tolerance, double longest) {
  using state = typename System::state;
  return by_dense_output(odeint::bulirsch_stoer_dense_out<state>(tolerance, tolerance, 1, 1), system, speed, longest);
}

/// The last step, from `before`, repeated with Newton's method for its length; `step(h, x)` makes one of length h.
template <class System, class Step>
double newton_at_end(const System& system, double speed, double h, const Step& step) {
  typename System::state x, slope, beside;
  for (int i = 0; i < 20; ++i) {
    step(h, x);
    system(x, slope, 0.);
    for (std::size_t j = 0; j < x.size(); ++j)
      beside[j] = x[j] + 1e-7 * slope[j];
    const double change = -system.event(x) / ((system.event(beside) - system.event(x)) / 1e-7);
    h += change;
    if (std::abs(change) < 1e-13)
      break;
  }
  return -x[1] / speed;
}

/// Restitution by controlled steps of dopri5 and Newton's method.
template <class System>
double dopri5_newton(const System& system, double speed, double tolerance, double longest) {
  using state = typename System::state;
  auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<state>());
  state x = system.start(speed);
  double t = 0, h = 1e-2;
  while (t < longest) {
    const state before = x;
    const double t_before = t;
    if (stepper.try_step(std::cref(system), x, t, h) != odeint::success || !has_ended(system, x))
      continue;
    odeint::runge_kutta_dopri5<state> plain;
    state slope, last_slope;
    system(before, slope, 0.);
    return newton_at_end(system, speed, t - t_before, [&](double part, state& out) {
      plain.do_step(std::cref(system), before, slope, 0., out, last_slope, part);
    });
  }
  return 0;
}

} // namespace peer
