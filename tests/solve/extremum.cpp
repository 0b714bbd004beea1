#include <boost/test/unit_test.hpp>

#include <ricochet/solve/extremum.hpp>

#include <cmath>

BOOST_AUTO_TEST_CASE(a_maximum_between_steps_is_found_whichever_step_it_lies_in) {
  for (const double peak : {0.42, 0.5, 0.58}) {
    const auto f = [peak](double t) { return 3 - (t - peak) * (t - peak); };
    ricochet::maximum<double> found(f(0));
    for (int i = 0; i < 10; ++i) {
      const double t = 0.1 * i;
      found.step(
          0.1, f(t + 0.1), [&](double part) { return f(t - 0.1 + part); }, [&](double part) { return f(t + part); });
    }
    BOOST_TEST(std::abs(found.value() - 3) < 1e-15); // quadratic: half the digits of the place are all of the value's
  }
}

BOOST_AUTO_TEST_CASE(ends_of_the_motion_count_and_a_new_motion_keeps_the_largest) {
  ricochet::maximum<double> found(5.0);
  const auto flat = [](double) { return 1.0; };
  found.step(0.1, 1.0, flat, flat);
  BOOST_TEST(found.value() == 5);
  found.restart(2.0);
  found.step(0.1, 7.0, flat, flat);
  BOOST_TEST(found.value() == 7);
}
