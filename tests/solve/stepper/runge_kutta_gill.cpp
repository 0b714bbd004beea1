#include <boost/test/unit_test.hpp>

#include <ricochet/solve/stepper/runge_kutta_gill.hpp>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>

#include <cmath>

namespace {

using state = std::array<double, 2>;
using gill = ricochet::stepper::runge_kutta_gill_method<state, double>;

/// Neither linear nor autonomous: every coefficient and node of the method counts.
void pendulum(const state& x, state& dx, double t) { dx = {x[1] + 0.1 * t * t, -std::sin(x[0]) + std::cos(3 * t)}; }

/// A step as Gill writes it: the slopes are used up as they come, what is to be remembered of them is gathered in q.
state step_of_gill(state y, double t, double h) {
  const double r = std::sqrt(0.5), node[] = {0, 0.5, 0.5, 1};
  const double forward[] = {0.5, 1 - r, 1 + r, 1. / 6}, of_q[] = {0, 1 - r, 1 + r, 1. / 3};
  const double kept[] = {1, 2 - 2 * r, 2 + 2 * r}, faded[] = {0, -2 + 3 * r, -2 - 3 * r};
  state q{};
  for (int stage = 0; stage < 4; ++stage) {
    state k;
    pendulum(y, k, t + node[stage] * h);
    for (std::size_t i = 0; i < 2; ++i) {
      y[i] += forward[stage] * h * k[i] - of_q[stage] * q[i];
      if (stage < 3)
        q[i] = kept[stage] * h * k[i] + faded[stage] * q[i];
    }
  }
  return y;
}

state solution(std::size_t steps) {
  state x{1, 0.5};
  boost::numeric::odeint::integrate_n_steps(gill{}, pendulum, x, 0., 2. / double(steps), steps);
  return x;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_step_is_that_of_gill) {
  const state x{1, 0.5};
  const double t = 0.3, h = 0.2;
  const state expected = step_of_gill(x, t, h);
  state slope, with_slope, without;
  pendulum(x, slope, t);
  gill{}.do_step(pendulum, x, slope, t, with_slope, h);
  gill{}.do_step(pendulum, x, t, without, h);
  state in_place = x;
  gill{}.do_step(pendulum, in_place, t, h);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(std::abs(with_slope[i] - expected[i]) < 1e-15); // a few roundings of numbers near one
    BOOST_TEST(without[i] == with_slope[i]);
    BOOST_TEST(in_place[i] == with_slope[i]);
  }
}

BOOST_AUTO_TEST_CASE(a_step_differs_from_that_of_the_classical_method) {
  // Both are of order 4; what tells them apart is of order h^5.
  const state x{1, 0.5};
  const double t = 0.3, h = 0.2;
  state k[4], at = x;
  pendulum(at, k[0], t);
  for (std::size_t i = 0; i < 2; ++i)
    at[i] = x[i] + h / 2 * k[0][i];
  pendulum(at, k[1], t + h / 2);
  for (std::size_t i = 0; i < 2; ++i)
    at[i] = x[i] + h / 2 * k[1][i];
  pendulum(at, k[2], t + h / 2);
  for (std::size_t i = 0; i < 2; ++i)
    at[i] = x[i] + h * k[2][i];
  pendulum(at, k[3], t + h);
  state out;
  gill{}.do_step(pendulum, x, t, out, h);
  double apart = 0;
  for (std::size_t i = 0; i < 2; ++i)
    apart = std::max(apart, std::abs(out[i] - (x[i] + h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]))));
  BOOST_TEST(apart > 1e-9);
  BOOST_TEST(apart < 1e-4);
}

BOOST_AUTO_TEST_CASE(it_is_of_order_four_in_the_loops_of_odeint) {
  BOOST_TEST(gill{}.order() == 4);
  const state fine = solution(4096);
  const auto error = [&](std::size_t steps) {
    const state x = solution(steps);
    return std::hypot(x[0] - fine[0], x[1] - fine[1]);
  };
  for (const std::size_t steps : {32u, 64u, 128u}) {
    const double order = std::log2(error(steps) / error(2 * steps));
    BOOST_TEST_MESSAGE("order between " << steps << " and " << 2 * steps << " steps: " << order);
    BOOST_TEST(std::abs(order - 4) < 0.2); // the next order is a part h of it, a tenth at most
  }
}

BOOST_AUTO_TEST_CASE(one_step_is_of_local_order_five) {
  const auto error = [](double h) {
    state x{1, 0.5}, fine = x;
    gill{}.do_step(pendulum, x, 0., h);
    boost::numeric::odeint::integrate_n_steps(gill{}, pendulum, fine, 0., h / 64, 64);
    return std::hypot(x[0] - fine[0], x[1] - fine[1]);
  };
  for (const double h : {0.1, 0.05, 0.025}) {
    const double order = std::log2(error(h) / error(h / 2));
    BOOST_TEST_MESSAGE("local order at " << h << ": " << order);
    BOOST_TEST(std::abs(order - 5) < 0.2); // likewise
  }
}
