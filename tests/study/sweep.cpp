#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/study/sweep.hpp>

using namespace support;

BOOST_AUTO_TEST_CASE(speeds_are_spaced_in_equal_ratios_between_the_ends) {
  const auto speeds = logarithmic_speeds(0.1 * metres_per_second, 100.0 * metres_per_second, 4);
  BOOST_TEST(speeds.size() == 4u);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(in_si(speeds[i]) == std::pow(10., double(i) - 1), boost::test_tools::tolerance(1e-14));
  BOOST_CHECK_THROW(logarithmic_speeds(0.0 * metres_per_second, 1.0 * metres_per_second, 4), bad_input);
  BOOST_CHECK_THROW(logarithmic_speeds(2.0 * metres_per_second, 1.0 * metres_per_second, 4), bad_input);
  BOOST_CHECK_THROW(logarithmic_speeds(1.0 * metres_per_second, 2.0 * metres_per_second, 1), bad_input);
}

BOOST_AUTO_TEST_CASE(a_sweep_is_one_collision_a_speed_in_order_with_progress) {
  const ice_case ice;
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  const auto speeds = logarithmic_speeds(0.5 * metres_per_second, 50.0 * metres_per_second, 9);
  std::vector<std::size_t> seen;
  const auto outcomes = sweep(model, speeds, {.tolerance = 1e-9}, [&](std::size_t done, std::size_t all) {
    seen.push_back(done);
    BOOST_TEST(all == 9u);
  });
  BOOST_TEST(outcomes.size() == 9u);
  BOOST_TEST(seen.size() == 9u);
  BOOST_TEST(seen.back() == 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    const auto alone = collide(model, impact{speeds[i]}, {.tolerance = 1e-9});
    BOOST_TEST(outcomes[i].restitution.value_or(0) == alone.restitution.value_or(0));
  }
}
