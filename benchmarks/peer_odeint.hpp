// Collisions as a competent user of Boost.Odeint writes them: mutual approach and its rate over time, as the papers
// have them, with dopri5. Two ways to find the end: dense output and bisection, or steps and Newton's method.
#pragma once
#include <array>
#include <cmath>

#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/generation/make_dense_output.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace peer {
namespace odeint = boost::numeric::odeint;

using state = std::array<double, 2>; ///< approach, rate

/// Numbers of a pair in units of the Hertzian approach and contact time, so that both methods' tolerances mean the
/// same.
struct pair {
  double modulus, radius, mass;
};

/// Hertz with the damping of Kuwabara and Kono; it ends where the force vanishes.
struct kuwabara_kono {
  pair p;
  double bulk_time;
  static constexpr state start(double speed) { return {0, speed}; }
  double force(const state& x) const {
    const double a = std::sqrt(std::max(0., x[0]) * p.radius);
    return 2 * p.modulus * a * (2. / 3 * x[0] + bulk_time * x[1]);
  }
  void operator()(const state& x, state& dx, double) const { dx = {x[1], -force(x) / p.mass}; }
  double event(const state& x) const { return 2. / 3 * x[0] + bulk_time * x[1]; } ///< without the vanishing factor
  bool may_end(const state& x) const { return x[1] < 0; }
};

/// Hertz with the damping of Hunt and Crossley; it ends where the overlap vanishes.
struct hunt_crossley {
  pair p;
  double damping_coefficient;
  static constexpr state start(double speed) { return {0, speed}; }
  double force(const state& x) const {
    const double d = std::max(0., x[0]);
    return 4. / 3 * p.modulus * std::sqrt(p.radius * d) * d * (1 + damping_coefficient * x[1]);
  }
  void operator()(const state& x, state& dx, double) const { dx = {x[1], -force(x) / p.mass}; }
  double event(const state& x) const { return x[0]; }
  bool may_end(const state& x) const { return x[1] < 0; }
};

/// JKR with the damping of Kuwabara and Kono; the radius is found from the approach by Newton's method, from where it
/// was last. It ends at the fold.
struct jkr_kuwabara_kono {
  pair p;
  double work_of_adhesion, bulk_time;
  mutable double last = 0;
  double flattening() const { return std::sqrt(2 * 3.141592653589793 * work_of_adhesion / p.modulus); }
  double fold_radius() const {
    return std::cbrt(3.141592653589793 * work_of_adhesion * p.radius * p.radius / (8 * p.modulus));
  }
  double fold() const {
    const double a = fold_radius();
    return a * a / p.radius - flattening() * std::sqrt(a);
  }
  double radius(double approach) const {
    const double c = flattening(), least = std::sqrt(fold_radius());
    double r = last > least ? last : 2 * least;
    for (int i = 0; i < 50; ++i) { // in r = sqrt(a)
      const double f = r * r * r * r / p.radius - c * r - approach, slope = 4 * r * r * r / p.radius - c;
      const double step = f / std::max(slope, 1e-12);
      r = std::max(least, r - step);
      if (std::abs(step) < 1e-15 * r)
        break;
    }
    last = r;
    return r;
  }
  state start(double speed) const {
    last = 0;
    return {0, speed};
  }
  double force(const state& x) const {
    const double r = radius(std::max(x[0], fold())), a = r * r;
    return 4. / 3 * p.modulus * a * a * a / p.radius -
           std::sqrt(8 * 3.141592653589793 * work_of_adhesion * p.modulus) * a * r +
           2 * bulk_time * p.modulus * a * x[1];
  }
  void operator()(const state& x, state& dx, double) const { dx = {x[1], -force(x) / p.mass}; }
  double event(const state& x) const { return x[0] - fold(); }
  bool may_end(const state& x) const { return x[1] < 0; }
};

/// Restitution by dense output and bisection; 0 where it has not ended after `longest` (captured).
template <class System>
double by_bisection(const System& system, double speed, double tolerance, double longest) {
  auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<state>());
  stepper.initialize(system.start(speed), 0., 1e-2);
  while (stepper.current_time() < longest) {
    auto [low, high] = stepper.do_step(std::cref(system));
    if (system.may_end(stepper.current_state()) && system.event(stepper.current_state()) <= 0) {
      state x;
      while (high - low > 1e-14 * high) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high)
          break;
        stepper.calc_state(middle, x);
        (system.may_end(x) && system.event(x) <= 0 ? high : low) = middle;
      }
      stepper.calc_state(low, x);
      return -x[1] / speed;
    }
  }
  return 0;
}

/// Restitution by controlled steps; the last is repeated with Newton's method for its length.
template <class System>
double by_newton(const System& system, double speed, double tolerance, double longest) {
  auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<state>());
  state x = system.start(speed), before;
  double t = 0, h = 1e-2;
  while (t < longest) {
    before = x;
    const double t_before = t;
    if (stepper.try_step(std::cref(system), x, t, h) != odeint::success)
      continue;
    if (!system.may_end(x) || system.event(x) > 0)
      continue;
    odeint::runge_kutta_dopri5<state> plain;
    double step = t - t_before;
    for (int i = 0; i < 20; ++i) {
      state slope, beside;
      plain.do_step(std::cref(system), before, 0., x, step);
      system(x, slope, 0.);
      beside = {x[0] + 1e-7 * slope[0], x[1] + 1e-7 * slope[1]};
      const double change = -system.event(x) / ((system.event(beside) - system.event(x)) / 1e-7);
      step += change;
      if (std::abs(change) < 1e-13)
        break;
    }
    return -x[1] / speed;
  }
  return 0;
}

} // namespace peer
