#include <boost/test/unit_test.hpp>

#include "../support/random_scenes.hpp"

#include <ricochet/closed_form/hertz.hpp>

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

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_integration) {
  scenes random(21);
  double worst_time = 0, worst_approach = 0, worst_radius = 0;
  for (int i = 0; i < 40; ++i) {
    const auto s = random.next();
    const auto out = integrate(hertzian(s, contact_duration{}, extremes{}), impact{s.speed}, {.tolerance = 1e-12});
    worst_time =
        std::max(worst_time, deviation(in_si(out.contact_duration), in_si(closed::contact_time(s.pair, s.speed))));
    worst_approach =
        std::max(worst_approach, deviation(in_si(out.max_approach), in_si(closed::max_approach(s.pair, s.speed))));
    worst_radius = std::max(
        worst_radius, deviation(in_si(out.max_contact_radius), in_si(closed::max_contact_radius(s.pair, s.speed))));
  }
  BOOST_TEST_MESSAGE("largest deviations: duration " << worst_time << ", approach " << worst_approach << ", radius "
                                                     << worst_radius);
  BOOST_TEST(worst_time < 1e-9);     // the integration's tolerance is one of e; time is carried along with it
  BOOST_TEST(worst_approach < 1e-9); // likewise
  BOOST_TEST(worst_radius < 1e-9);   // likewise
}

BOOST_AUTO_TEST_CASE(printed_numbers) {
  // theory.md prints ten decimals: half of the last is 5e-11.
  BOOST_TEST(std::abs(closed::contact_time_factor() - 2.8682656992) < 5e-11);
  const contact_pair pair{3.0 * gigapascals, 2.0 * micrometres, 5e-15 * kilograms};
  const double E = 3e9, R = 2e-6, m = 5e-15, v = 7;
  // 1e-14: a few roundings in roots and powers
  BOOST_TEST(deviation(in_si(closed::max_approach(pair, v * metres_per_second)),
                       std::pow(15 * m * v * v / (16 * E * std::sqrt(R)), 0.4)) < 1e-14);
  BOOST_TEST(deviation(in_si(closed::contact_time(pair, v * metres_per_second)),
                       closed::contact_time_factor() * std::pow(m * m / (R * E * E * v), 0.2)) < 1e-14);
  BOOST_TEST(deviation(in_si(closed::max_contact_radius(pair, v * metres_per_second)),
                       std::pow(15 * m * v * v * R * R / (16 * E), 0.2)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const contact_pair pair{3.0 * gigapascals, 2.0 * micrometres, 5e-15 * kilograms};
  contact_pair soft = pair, flat = pair, light = pair;
  soft.reduced_modulus = -4.0 * pascals;
  flat.reduced_radius = length{};
  light.reduced_mass = std::numeric_limits<double>::infinity() * kilograms;
  const speed v = 1.0 * metres_per_second, still = 0.0 * metres_per_second;
  const speed unknown = std::numeric_limits<double>::quiet_NaN() * metres_per_second;
  BOOST_CHECK_EXCEPTION(closed::contact_time(pair, still), bad_input, says("speed", "0 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::max_approach(pair, unknown), bad_input, says("speed", "nan m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::max_contact_radius(pair, -v), bad_input, says("speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_time(soft, v), bad_input, says("reduced_modulus", "-4 Pa", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::max_approach(flat, v), bad_input, says("reduced_radius", "0 m", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::max_approach(light, v), bad_input, says("reduced_mass", "inf kg", "(0, inf)"));
}
