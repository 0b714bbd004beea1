#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/solve/edge/fast_edge.hpp>

using namespace support;

namespace {
const ice_case ice;
const impact fast{8.0 * metres_per_second};

auto with_relaxation_time(double relaxation_time) {
  return compose(ice.pair, hertz{}, ice.adhesive, ice.exact(relaxation_time * seconds), energy_ledger{});
}
double restitution_of_jkr() { return *collide(with_relaxation_time(0), fast, {.tolerance = 1e-12}).restitution; }
} // namespace

BOOST_AUTO_TEST_CASE(twelve_decades_of_relaxation_time_cost_about_the_same) {
  // 1e5 evaluations at 1e-14 s, 1e6 or none at all at 1e-18 s with a stepper of order two there. Where the static edge
  // is within the tolerance it takes less, however fast the edge is.
  for (const double tolerance : {1e-6, 1e-9}) {
    const long of_the_slowest = collide(with_relaxation_time(1e-11), fast, {.tolerance = tolerance}).evaluations;
    long most = 0;
    for (const int decade : {-12, -13, -14, -15, -16, -17, -18, -19, -20, -21, -22, -23, -30, -100, -300}) {
      const auto out = collide(with_relaxation_time(std::pow(10, decade)), fast, {.tolerance = tolerance});
      BOOST_TEST_CONTEXT("T_vis = 1e" << decade << ", tolerance " << tolerance) {
        BOOST_TEST(out.error_estimate <= tolerance);
        BOOST_TEST(std::abs(out.ledger_residual) <= 2 * tolerance);
      }
      most = std::max(most, out.evaluations);
    }
    BOOST_TEST_MESSAGE("tolerance " << tolerance << ": " << of_the_slowest << ", then " << most << " at most");
    BOOST_TEST(most <= 3 * of_the_slowest);
  }
}

BOOST_AUTO_TEST_CASE(where_a_fast_edge_is_taken_as_static_the_error_stays_within_its_estimate) {
  for (const double v : {1.5, 8.})
    for (int decade = -16; decade >= -24; --decade) {
      const auto model = with_relaxation_time(std::pow(10, decade));
      const impact at{v * metres_per_second};
      const auto fine = collide(model, at, {.tolerance = 1e-10});
      for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const auto out = collide(model, at, {.tolerance = tolerance});
        BOOST_TEST_CONTEXT(v << " m/s, T_vis = 1e" << decade << ", tolerance " << tolerance) {
          BOOST_TEST(out.error_estimate <= tolerance);
          BOOST_TEST(std::abs(*out.restitution - *fine.restitution) <= out.error_estimate + fine.error_estimate);
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(e_rises_monotonically_to_that_of_jkr) {
  const double limit = restitution_of_jkr();
  double last = 1, last_lag = 0;
  for (int decade = -12; decade >= -22; --decade) {
    const auto model = with_relaxation_time(std::pow(10, decade));
    const double deficit = limit - *collide(model, fast, {.tolerance = 1e-10}).restitution;
    const reduced_model<double, decltype(with_relaxation_time(0))> numbers(model, scales_at(model, fast.speed));
    const double lag = fast_edge(numbers).lag();
    BOOST_TEST_CONTEXT("T_vis = 1e" << decade) {
      BOOST_TEST(deficit > 0);
      BOOST_TEST(deficit < last);
      if (decade < -18) { // the lag at the fold is the rest of what distinguishes it from JKR
        const double exponent = std::log10(last / deficit), expected = std::log10(last_lag / lag);
        BOOST_TEST_MESSAGE("T_vis = 1e" << decade << ": exponent " << exponent << ", of the lag " << expected);
        BOOST_TEST(std::abs(exponent - expected) < 0.015);
        BOOST_TEST(exponent < 2. / 3);
      }
    }
    last = deficit;
    last_lag = lag;
  }
  BOOST_TEST(*collide(with_relaxation_time(0), fast, {.tolerance = 1e-10}).restitution == limit,
             boost::test_tools::tolerance(2e-10));
}
