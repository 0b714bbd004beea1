#include <boost/test/unit_test.hpp>

#include <ricochet/solve/stepper/explicit_pair.hpp>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>

#include <cmath>
#include <functional>

namespace {

using state = std::array<double, 2>;

/// Heun's method with Euler's inside.
struct heun_euler {
  static constexpr unsigned short order = 2, error_order = 1;
  static constexpr std::size_t stages = 2;
  using row = std::array<long double, stages>;
  static constexpr std::array<row, stages> a{{{}, {1}}};
  static constexpr row b{0.5L, 0.5L}, e{-0.5L, 0.5L};
};
using pair = ricochet::stepper::explicit_pair<heun_euler, state, double>;

} // namespace

BOOST_AUTO_TEST_CASE(a_step_is_that_of_its_table) {
  const auto system = [](const state& x, state& dx, double t) { dx = {x[1], t - x[0]}; };
  const state x{1, 2};
  state slope, out, error;
  const double t = 0.5, h = 0.1;
  system(x, slope, t); // 2, -0.5
  pair{}.do_step(system, x, slope, t, out, h, error);
  const state ahead{x[0] + h * 2, x[1] - h * 0.5}, slope_ahead{ahead[1], t + h - ahead[0]};
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(std::abs(out[i] - (x[i] + h * (slope[i] + slope_ahead[i]) / 2)) < 1e-15);
    BOOST_TEST(std::abs(error[i] - h * (slope_ahead[i] - slope[i]) / 2) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(it_runs_in_the_loops_of_odeint) {
  state x{1, 0};
  const int steps = 1000;
  const double end = boost::numeric::odeint::integrate_n_steps(
      pair{},
      [](const state& at, state& dx, double) {
        dx = {at[1], -at[0]};
      },
      x, 0., 1e-3, steps);
  BOOST_TEST(std::abs(end - 1) < 1e-12);
  BOOST_TEST(std::abs(x[0] - std::cos(1.)) < 1e-6);
  BOOST_TEST(std::abs(x[0] - std::cos(1.)) > 1e-9); // it is of order 2
  BOOST_TEST(pair{}.order() == 2);
  BOOST_TEST(pair{}.stepper_order() == 2);
  BOOST_TEST(pair{}.error_order() == 1);
}
