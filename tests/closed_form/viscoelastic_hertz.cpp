#include <boost/test/unit_test.hpp>

#include "../support/random_scenes.hpp"

#include <ricochet/closed_form/viscoelastic_hertz.hpp>

using namespace support;
namespace closed = ricochet::closed_form;

namespace {

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

struct fixture { // the ice case of reference/published.csv: Krijt 2013 table 2, figure 2
  contact_pair pair =
      between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
  duration relaxation_time = 1e-11 * seconds;
  duration bulk_time = bulk_time_of_krijt(relaxation_time, 0.25);
  speed v = 8.0 * metres_per_second;

  /// A that makes the damping number y.
  duration bulk_time_for(double y) const { return y / closed::damping_number(pair, 1.0 * seconds, v) * seconds; }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(series_agrees_with_integration, fixture) {
  for (double y = 1e-4; y < 0.51; y *= 1.3) {
    const auto model = compose(pair, hertz{}, kuwabara_kono{bulk_time_for(y)}, end_at_zero_overlap{});
    const auto out = integrate(model, impact{v}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    const double excess = closed::restitution_series_to_zero_overlap(y) - *out.restitution;
    BOOST_TEST_CONTEXT("y = " << y) {
      // The fifth coefficient is -0.233 (reference table, series of five terms); the sixth, +0.16, weakens it by 0.7y.
      // C3 and C4 are printed to ten and eight digits: 1e-10 y^3. 1e-11: ten times the integration's tolerance.
      BOOST_TEST(excess < 0.24 * std::pow(y, 5) + 1e-10 * y * y * y + 1e-11);
      BOOST_TEST(excess > 0.15 * std::pow(y, 5) - 1e-10 * y * y * y - 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(weak_damping_agrees_with_integration) {
  scenes random(25);
  for (int i = 0; i < 30; ++i) {
    auto s = random.next();
    s.bulk_time = closed::contact_time(s.pair, s.speed) * random.log_uniform(1e-6, 3e-2);
    const double y = closed::damping_number(s.pair, s.bulk_time, s.speed);
    const auto out = integrate(viscous_hertz(s, end_at_zero_overlap{}), impact{s.speed}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    const double lacking = *out.restitution - closed::weak_damping_restitution(s.pair, s.bulk_time, s.speed);
    // Next term of the series, 0.7983y^2, weakened by 0.6551y; 1e-11: ten times the integration's tolerance.
    BOOST_TEST(lacking < 0.7983 * y * y + 1e-11);
    BOOST_TEST(lacking > 0.7982 * y * y * (1 - 0.66 * y) - 1e-11);
  }
}

BOOST_FIXTURE_TEST_CASE(printed_numbers, fixture) {
  const duration A = 1e-10 * seconds;
  const double slope = (1 - closed::weak_damping_restitution(pair, A, v)) * double(closed::contact_time(pair, v) / A);
  BOOST_TEST(std::abs(slope - 5.5678109) < 5.1e-8); // theory.md prints seven decimals
  // Ten decimals: the slope of the series at 0.
  BOOST_TEST(std::abs(closed::detail::weak_damping_slope() - 1.1534488581) < 5.1e-11);
  // Half of the last of ten decimals in three coefficients, of eight in the fourth, at y = 0.1: 1e-11.
  const double series = 1 - 0.11534488581 + 0.007982665609 - 0.0005228825681 + 0.000034874267;
  BOOST_TEST(std::abs(closed::restitution_series_to_zero_overlap(0.1) - series) < 1e-11);
  const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), m = in_si(pair.reduced_mass);
  const double y = 1.5 * 1e-10 * std::pow(4 * E * std::sqrt(R) / (3 * m), 0.4) * std::pow(in_si(v), 0.2);
  BOOST_TEST(deviation(closed::damping_number(pair, A, v), y) < 1e-14); // a few roundings in powers
  // reference/published.csv, of Krijt 2013 3.1: the paper prints 1.4e-8 s.
  BOOST_TEST(std::abs(in_si(closed::contact_time(pair, v)) - 1.373479289e-8) < 5.1e-18); // half of the last decimal
}

BOOST_AUTO_TEST_CASE(series_at_any_damping_are_the_solution_in_long_double) {
  const contact_pair unit{.reduced_modulus = 1 * pascals, .reduced_radius = 1 * metres, .reduced_mass = 1 * kilograms};
  const speed v = 1 * metres_per_second;
  const double number_of_one_second = closed::damping_number(unit, 1 * seconds, v);
  scenes random(11);
  const auto check = [&](double last, auto series, auto... end) {
    double worst = 0;
    for (int i = 0; i < 150; ++i) {
      const double y = i == 0 ? last : random.log_uniform(1e-6, last);
      const auto model = compose(unit, hertz{}, kuwabara_kono{y / number_of_one_second * seconds}, end...);
      worst = std::max(worst, std::abs(series(y) - reference_restitution(model, v)));
    }
    BOOST_TEST_MESSAGE("largest error " << worst);
    BOOST_TEST(worst < 1e-15); // coefficients to 1e-17, and round-off of a sum of order one
    BOOST_TEST(series(0) == 1, boost::test_tools::tolerance(1e-15));
  };
  check(closed::largest_damping_number_to_zero_force, closed::viscoelastic_restitution_to_zero_force);
  check(closed::largest_damping_number_to_zero_overlap, closed::viscoelastic_restitution_to_zero_overlap,
        end_at_zero_overlap{});
}

BOOST_AUTO_TEST_CASE(beyond_the_series_the_collision_is_integrated) {
  const contact_pair unit{.reduced_modulus = 1 * pascals, .reduced_radius = 1 * metres, .reduced_mass = 1 * kilograms};
  const speed v = 1 * metres_per_second;
  const double one = closed::damping_number(unit, 1 * seconds, v);
  const auto at = [&](double y) {
    return collide(compose(unit, hertz{}, kuwabara_kono{y / one * seconds}), impact{v}, {.tolerance = 1e-10});
  };
  const auto below = at(63.999999), above = at(64.000001);
  BOOST_TEST(below.evaluations == 0);
  BOOST_TEST(above.evaluations > 0);
  BOOST_TEST(std::abs(*below.restitution - *above.restitution) < 1e-10);
}

BOOST_FIXTURE_TEST_CASE(wrong_input_is_named, fixture) {
  const duration wrong = -2.0 * seconds;
  BOOST_CHECK_EXCEPTION(closed::damping_number(pair, wrong, v), bad_input, says("bulk_time", "-2 s", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::weak_damping_restitution(pair, wrong, v), bad_input,
                        says("bulk_time", "-2 s", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::damping_number(pair, bulk_time, -v), bad_input, says("speed", "-8 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::viscoelastic_restitution_to_zero_force(65), bad_input,
                        says("damping_number", "65", "[0, 64]"));
  BOOST_CHECK_EXCEPTION(closed::viscoelastic_restitution_to_zero_overlap(-1), bad_input,
                        says("damping_number", "-1", "[0, 16]"));
  BOOST_CHECK_EXCEPTION(closed::restitution_series_to_zero_overlap(0.75), bad_input,
                        says("damping_number", "0.75", "[0, 0.5]"));
}
