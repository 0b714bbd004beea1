#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/tangential/mindlin.hpp>
#include <ricochet/number/autodiff.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <boost/math/special_functions/beta.hpp>

using namespace support;

namespace {

/// Slip at the ending over that at first touch of an elastic Hertzian contact that never slips: a linear problem, in
/// which each line of the contact is stretched by the way since it was touched, and loses that when it is left. So F =
/// 2 kappa E* (a s - A), with A the integral of the way over the radius, in the way when that radius was loaded. Units
/// in which E*, R, m* and the speed are 1; the normal motion is a = a_m sin(theta)^{2/5}, theta slowed at both ends.
double slip_without_slipping(double kappa) {
  constexpr int steps = 4000; // of Runge and Kutta while loading; twice as long ones, over the same nodes, unloading
  const double largest = std::pow(15. / 16, 0.2);
  struct state {
    double way, slip, area;
  };
  std::vector<double> loaded(steps + 1);
  const auto motion = [&](double zeta, const state& x, double way_when_loaded) -> state {
    if (zeta <= 0 || zeta >= 1)
      return {0, 0, 0};
    const double theta = pi<double>() * boost::math::ibeta(10., 10., zeta);
    const double theta_rate = pi<double>() * boost::math::ibeta_derivative(10., 10., zeta);
    const double a = largest * std::pow(std::sin(theta), 0.4);
    const double a_rate = 0.4 * a / std::tan(theta) * theta_rate;
    const double clock = 0.8 * square(largest) * std::pow(std::sin(theta), -0.2) * theta_rate;
    const double force = 2 * kappa * (a * x.way - x.area);
    return {x.slip * clock, -3.5 * force * clock, way_when_loaded * a_rate};
  };
  const auto moved = [](const state& x, const state& rate, double h) -> state {
    return {x.way + h * rate.way, x.slip + h * rate.slip, x.area + h * rate.area};
  };
  state x{0, 1, 0};
  const auto step = [&](double zeta, double h, const auto& way_at) {
    const state k1 = motion(zeta, x, way_at(0, x)), x2 = moved(x, k1, h / 2);
    const state k2 = motion(zeta + h / 2, x2, way_at(1, x2)), x3 = moved(x, k2, h / 2);
    const state k3 = motion(zeta + h / 2, x3, way_at(1, x3)), x4 = moved(x, k3, h);
    const state k4 = motion(zeta + h, x4, way_at(2, x4));
    x = moved(moved(moved(moved(x, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  };
  for (int i = 0; i < steps; ++i) {
    loaded[std::size_t(i)] = x.way;
    step(0.5 * i / steps, 0.5 / steps, [](int, const state& now) { return now.way; });
  }
  loaded[steps] = x.way;
  for (int i = 0; i < steps; i += 2)
    step(0.5 + 0.5 * i / steps, 1. / steps,
         [&](int node, const state&) { return loaded[std::size_t(steps - i - node)]; });
  return x.slip;
}

} // namespace

BOOST_AUTO_TEST_CASE(where_friction_holds_everything_the_problem_is_linear) {
  const auto pair = between(sphere{materials::steel, 1 * millimetres}, flat_wall{materials::steel});
  for (const double kappa : {0.67, 0.82, 1., 1.3}) {
    const double expected = slip_without_slipping(kappa);
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const auto out =
          collide(compose(pair, hertz{}, mindlin{1e9, kappa}),
                  impact{.speed = 2.0 * metres_per_second, .slip = 0.5 * metres_per_second}, {.tolerance = tolerance});
      BOOST_TEST(std::abs(in_si(out.slip) / 0.5 - expected) < out.slip_error_estimate);
      BOOST_TEST(out.slip_error_estimate < 30 * std::pow(tolerance, 2. / 3));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_error_of_the_slip_is_bounded_and_falls_with_the_tolerance) {
  scenes source(211);
  double worst = 0;
  std::vector<double> rough, fine;
  for (int i = 0; i < 60; ++i) {
    const scene s = source.next();
    const double kappa = source.log_uniform(0.3, 2), f = source.log_uniform(1e-3, 10);
    const auto model = compose(s.pair, hertz{}, kuwabara_kono{(i % 3) * s.bulk_time}, mindlin{f, kappa});
    const impact at{s.speed, source.log_uniform(1e-3, 30) * f / kappa * s.speed};
    const auto reference = collide(model, at, {.tolerance = 1e-11});
    const auto error = [&](double tolerance) {
      const auto out = collide(model, at, {.tolerance = tolerance});
      const double found = std::abs(in_si(out.slip - reference.slip)) / in_si(at.slip);
      worst = std::max(worst, found / (out.slip_error_estimate + reference.slip_error_estimate));
      return found;
    };
    rough.push_back(error(1e-6));
    fine.push_back(error(1e-8));
  }
  BOOST_TEST(worst < 1);
  std::sort(rough.begin(), rough.end());
  std::sort(fine.begin(), fine.end());
  BOOST_TEST_MESSAGE("errors of the slip at 1e-8: median " << fine[30] << ", largest " << fine.back());
  BOOST_TEST(fine[30] < 1e-6);
  BOOST_TEST(fine.back() < rough.back() / 5);
}

BOOST_AUTO_TEST_CASE(any_stepper_comes_to_the_same) {
  const auto pair = between(sphere{materials::steel, 1 * millimetres}, flat_wall{materials::steel});
  const auto model = compose(pair, hertz{}, tsuji{0.1}, mindlin{0.2, 0.8});
  const impact at{.speed = 2.0 * metres_per_second, .slip = 1.0 * metres_per_second}; // psi_1 = 2: comes to stick
  const auto usual = collide(model, at);
  const auto compare = [&](const auto& other) {
    BOOST_TEST(other.evaluations != usual.evaluations);
    BOOST_TEST(std::abs(in_si(other.slip - usual.slip)) < other.slip_error_estimate + usual.slip_error_estimate);
    BOOST_TEST(std::abs(in_si((other.slip_distance - usual.slip_distance) / (at.slip * usual.elapsed_time))) < 1e-5);
  };
  compare(collide(model, at, {}, stepper::dopri5{}));
  compare(collide(model, at, {}, stepper::bulirsch_stoer{}));
}

BOOST_AUTO_TEST_CASE(derivatives_come_out_on_dual_numbers) {
  const auto pair = between(sphere{materials::steel, 1 * millimetres}, flat_wall{materials::steel});
  const speed v = 2.0 * metres_per_second;
  const double kappa = 0.8;
  const auto slip_of = [&](double f, double tangent, const auto& seed) {
    const auto model = compose(pair, hertz{}, mindlin{f, kappa});
    const scales unit = scales_at(model, v);
    reduced_model<dual<>, std::remove_const_t<decltype(model)>> numbers(model, unit);
    dual<> slip = tangent * reduce<double>(v, unit);
    seed(numbers, slip);
    collision<decltype(numbers), stepper::fehlberg78> solver(numbers, 1e-9, 10'000'000);
    return solver.solve(dual<>(reduce<double>(v, unit)), slip).slip;
  };
  // it slides throughout: slip = slip_0 - 7 f speed, whose unit is that of the scene
  const auto sliding = slip_of(0.1, 2, [](auto& numbers, auto&) {
    numbers.tangential.friction_coefficient = seeded(value_of(numbers.tangential.friction_coefficient));
  });
  BOOST_TEST(std::abs(sliding.derivative(1) + 7) < 1e-6);
  // it never slips: slip is in proportion to slip_0
  const auto sticking = slip_of(1e9, 0.5, [](auto&, auto& slip) { slip = seeded(value_of(slip)); });
  BOOST_TEST(std::abs(sticking.derivative(1) - slip_without_slipping(kappa)) < 1e-6);
}
