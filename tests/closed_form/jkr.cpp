#include <boost/test/unit_test.hpp>

#include "../support/random_scenes.hpp"

#include <ricochet/closed_form/contact_duration.hpp>

using namespace support;
namespace closed = ricochet::closed_form;

namespace {

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct fixture {
  contact_pair pair =
      between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
  energy_per_area w = work_of_adhesion(materials::water_ice, materials::water_ice);
};

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_integration) {
  scenes random(20);
  double worst_e = 0, worst_time = 0, worst_approach = 0;
  for (int i = 0; i < 40; ++i) {
    const auto s = random.next();
    const speed v = closed::sticking_speed(s.pair, s.work_of_adhesion) * random.log_uniform(1.01, 1000);
    const auto out = integrate(static_jkr(s, contact_duration{}, extremes{}), impact{v}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - *closed::restitution(s.pair, s.work_of_adhesion, v)));
    worst_time = std::max(worst_time, deviation(in_si(out.contact_duration),
                                                in_si(*closed::contact_duration(s.pair, s.work_of_adhesion, v))));
    worst_approach = std::max(
        worst_approach, deviation(in_si(out.max_approach), in_si(closed::max_approach(s.pair, s.work_of_adhesion, v))));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time << ", approach "
                                              << worst_approach);
  BOOST_TEST(worst_e < 1e-11);       // ten times the tolerance of the integration
  BOOST_TEST(worst_time < 1e-9);     // the tolerance is one of e; time is carried along with it
  BOOST_TEST(worst_approach < 1e-9); // likewise
}

BOOST_FIXTURE_TEST_CASE(agrees_with_integration_next_to_the_sticking_speed, fixture) {
  const speed sticking = closed::sticking_speed(pair, w);
  const auto model = compose(pair, hertz{}, jkr{w}, contact_duration{}, extremes{});
  for (const double above : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const speed v = (1 + above) * sticking;
    const auto out = integrate(model, impact{v}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    // e^2 is an energy: the round-off of the integration's few hundred steps in it, 2e-13 at most, is one of 1e-13/e in
    // e.
    const double off = std::abs(*out.restitution - *closed::restitution(pair, w, v));
    BOOST_TEST_MESSAGE("at 1 + " << above << ": e off by " << off << ", estimated error " << out.error_estimate);
    BOOST_TEST(off < 1e-12 + 1e-13 / *out.restitution);
    BOOST_TEST(deviation(in_si(out.contact_duration), in_si(*closed::contact_duration(pair, w, v))) < 1e-9);
  }
  for (const double part : {1 - 1e-8, 0.99, 0.5, 1e-2}) {
    const speed v = part * sticking;
    const auto out = integrate(model, impact{v}, {.tolerance = 1e-12});
    BOOST_TEST((out.ending == ending::captured));
    BOOST_TEST(!closed::restitution(pair, w, v).has_value());
    BOOST_TEST(!closed::contact_duration(pair, w, v).has_value());
    // 1e-9: found as an extremum of the integrated motion, at its tolerance
    BOOST_TEST(deviation(in_si(out.max_approach), in_si(closed::max_approach(pair, w, v))) < 1e-9);
  }
  BOOST_TEST(!closed::restitution(pair, w, sticking).has_value());
  BOOST_TEST(!closed::contact_duration(pair, w, sticking).has_value());
}

BOOST_FIXTURE_TEST_CASE(duration_has_a_limit_at_the_sticking_speed, fixture) {
  const speed sticking = closed::sticking_speed(pair, w);
  const auto at = [&](double above) { return in_si(*closed::contact_duration(pair, w, (1 + above) * sticking)); };
  const double limit = in_si(*closed::contact_duration(
      pair, w, std::nextafter(in_si(sticking), std::numeric_limits<double>::infinity()) * metres_per_second));
  // The rate left at the fold goes as the square root of `above`, and so does what is missing of the time.
  for (const double above : {1e-6, 1e-8, 1e-10}) {
    const double fall = (limit - at(above)) / (limit - at(above / 100));
    // 10, within 2 %: the limit's own speed lies 2e-16 above, sqrt(2e-16/1e-12) = 1.5 %; the next order is 0.1 %.
    BOOST_TEST(fall > 9.8);
    BOOST_TEST(fall < 10.2);
  }
}

BOOST_FIXTURE_TEST_CASE(tends_to_hertz, fixture) {
  const speed v = 1.0 * metres_per_second;
  BOOST_TEST(in_si(closed::sticking_speed(pair, energy_per_area{})) == 0);
  BOOST_TEST(*closed::restitution(pair, energy_per_area{}, v) == 1);
  BOOST_TEST((*closed::contact_duration(pair, energy_per_area{}, v) == closed::contact_time(pair, v)));
  BOOST_TEST((closed::max_approach(pair, energy_per_area{}, v) == closed::max_approach(pair, v)));
  double before = 1;
  for (const double weaker : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double now =
        deviation(in_si(*closed::contact_duration(pair, weaker * w, v)), in_si(closed::contact_time(pair, v)));
    BOOST_TEST(now < before / 10); // the correction goes with some positive power of w, above 1/3
    BOOST_TEST(now > 0);
    before = now;
  }
}

BOOST_FIXTURE_TEST_CASE(printed_numbers, fixture) {
  const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), m = in_si(pair.reduced_mass);
  const double constant = 14.184391943728; // theory.md, 14 digits: 1e-13
  const double expected = std::sqrt(constant / m) * std::pow(std::pow(in_si(w), 5) * std::pow(R, 4) / (E * E), 1. / 6);
  BOOST_TEST(deviation(in_si(closed::sticking_speed(pair, w)), expected) < 1e-13);
}

BOOST_FIXTURE_TEST_CASE(wrong_input_is_named, fixture) {
  const auto says = [](const std::string& a, const std::string& b, const std::string& c) {
    return [=](const bad_input& e) { return contains(e.what(), a) && contains(e.what(), b) && contains(e.what(), c); };
  };
  const auto wrong = -0.5 * joules_per_square_metre;
  const speed v = 1.0 * metres_per_second, still = -2.0 * metres_per_second;
  BOOST_CHECK_EXCEPTION(closed::sticking_speed(pair, wrong), bad_input, says("work_of_adhesion", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::restitution(pair, wrong, v), bad_input, says("work_of_adhesion", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::restitution(pair, w, still), bad_input, says("speed", "-2 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::max_approach(pair, w, still), bad_input, says("speed", "-2 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration(pair, w, still), bad_input, says("speed", "-2 m/s", "(0, inf)"));
  pair.reduced_mass = mass{};
  BOOST_CHECK_EXCEPTION(closed::sticking_speed(pair, w), bad_input, says("reduced_mass", "0 kg", "(0, inf)"));
}
