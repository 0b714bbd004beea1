#include <boost/test/unit_test.hpp>

#include "../support/random_scenes.hpp"

#include <ricochet/closed_form/contact_duration.hpp>

using namespace support;
namespace closed = ricochet::closed_form;

namespace {

const speed one = 1.0 * metres_per_second;
const contact_pair pair{3.0 * gigapascals, 2.0 * micrometres, 5e-15 * kilograms};
const double critical = std::sqrt(5.);

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(zero_force_agrees_with_integration) {
  scenes random(23);
  double worst_e = 0, worst_time = 0;
  for (int i = 0; i < 50; ++i) {
    auto s = random.next();
    s.tsuji_coefficient = i == 0 ? critical : random.log_uniform(1e-4, 10);
    const auto out = integrate(tsuji_hertz(s, contact_duration{}), impact{s.speed}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - closed::restitution_to_zero_force(s.tsuji_coefficient)));
    worst_time = std::max(
        worst_time, deviation(in_si(out.contact_duration),
                              in_si(closed::contact_duration_to_zero_force(s.pair, s.tsuji_coefficient, s.speed))));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time);
  BOOST_TEST(worst_e < 1e-11);   // ten times the tolerance of the integration
  BOOST_TEST(worst_time < 1e-9); // the tolerance is one of e; time is carried along with it
}

BOOST_AUTO_TEST_CASE(zero_overlap_agrees_with_integration) {
  scenes random(24);
  double worst_e = 0, worst_time = 0;
  for (int i = 0; i < 40; ++i) {
    auto s = random.next();
    s.tsuji_coefficient = random.log_uniform(1e-4, 1.8);
    const auto out =
        integrate(tsuji_hertz(s, end_at_zero_overlap{}, contact_duration{}), impact{s.speed}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - *closed::restitution_to_zero_overlap(s.tsuji_coefficient)));
    worst_time = std::max(
        worst_time, deviation(in_si(out.contact_duration),
                              in_si(*closed::contact_duration_to_zero_overlap(s.pair, s.tsuji_coefficient, s.speed))));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time);
  BOOST_TEST(worst_e < 1e-11);   // ten times the tolerance of the integration
  BOOST_TEST(worst_time < 1e-9); // the tolerance is one of e; time is carried along with it
}

BOOST_AUTO_TEST_CASE(printed_numbers) {
  // theory.md prints four decimals for alpha = 1: half of the last is 5e-5.
  BOOST_TEST(std::abs(*closed::restitution_to_zero_overlap(1) - 0.2079) < 5e-5);
  BOOST_TEST(std::abs(closed::restitution_to_zero_force(1) - 0.3305) < 5e-5);
}

BOOST_AUTO_TEST_CASE(weak_damping) {
  BOOST_TEST(closed::restitution_to_zero_force(0) == 1);
  BOOST_TEST(*closed::restitution_to_zero_overlap(0) == 1);
  const double elastic = in_si(closed::contact_time(pair, one));
  for (const double alpha : {0., 1e-300, 1e-17, 1e-9}) {
    // e = 1 - pi alpha/sqrt 5 + O(alpha^2) at both ends; 5e-16: roundings of numbers next to one
    const double expected = 1 - std::numbers::pi * alpha / critical;
    BOOST_TEST(std::abs(closed::restitution_to_zero_force(alpha) - expected) < 1e-17 + 10 * alpha * alpha + 5e-16);
    BOOST_TEST(std::abs(*closed::restitution_to_zero_overlap(alpha) - expected) < 10 * alpha * alpha + 5e-16);
    // The end at zero force cuts off a time of order alpha^{4/5}, that at zero overlap adds one of order alpha.
    // 1e-13: roundings of the quadrature
    BOOST_TEST(deviation(in_si(closed::contact_duration_to_zero_force(pair, alpha, one)), elastic) <
               std::pow(alpha, 0.8) * 2 + 1e-13);
    BOOST_TEST(deviation(in_si(*closed::contact_duration_to_zero_overlap(pair, alpha, one)), elastic) < alpha + 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(passes_smoothly_through_critical_damping) {
  // At zeta = 1: e = exp(-2), d ln e/d zeta = -4/3, d^2 ln e/d zeta^2 = 4/5.
  const double time = in_si(closed::contact_duration_to_zero_force(pair, critical, one));
  BOOST_TEST(deviation(closed::restitution_to_zero_force(critical), std::exp(-2.)) < 1e-15); // one rounding of exp
  for (const double off : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15})
    for (const double step : {-off, off}) {
      const double alpha = critical * (1 + step), e = closed::restitution_to_zero_force(alpha);
      // third order of the series, coefficient below one, and roundings of alpha
      BOOST_TEST(std::abs(std::log(e) + 2 + 4 * step / 3 - 2 * step * step / 5) < off * off * off + 2e-15);
      // d ln t/d zeta is below one in size; 1e-12: roundings of the quadrature
      BOOST_TEST(deviation(in_si(closed::contact_duration_to_zero_force(pair, alpha, one)), time) < off + 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(strong_damping) {
  // e -> (2 zeta)^{-2}, next order ln(zeta)/zeta^2
  for (const double zeta : {1e4, 1e6, 1e12})
    BOOST_TEST(deviation(closed::restitution_to_zero_force(critical * zeta), 0.25 / zeta / zeta) < 1e-6);
}

BOOST_AUTO_TEST_CASE(zero_overlap_is_never_reached_beyond_critical_damping) {
  for (const double alpha : {critical, critical * (1 + 1e-12), 3., 1e6}) {
    BOOST_TEST(!closed::restitution_to_zero_overlap(alpha).has_value());
    BOOST_TEST(!closed::contact_duration_to_zero_overlap(pair, alpha, one).has_value());
  }
  for (const double alpha : {critical * (1 - 1e-3), critical * (1 - 1e-12)}) {
    BOOST_TEST_REQUIRE(closed::restitution_to_zero_overlap(alpha).has_value());
    BOOST_TEST(*closed::restitution_to_zero_overlap(alpha) < 1e-20); // exp(-pi/0.045)
    BOOST_TEST(in_si(*closed::contact_duration_to_zero_overlap(pair, alpha, one)) >
               100 * in_si(closed::contact_time(pair, one)));
  }
}

BOOST_AUTO_TEST_CASE(damping_coefficient_inverts_zero_overlap) {
  BOOST_TEST(closed::damping_coefficient_for(1) == 0);
  for (const double e : {0.999999, 0.9, 0.5, 0.1, 1e-3, 1e-6}) {
    const double alpha = closed::damping_coefficient_for(e);
    // An ulp of zeta moves ln e by pi/(1 - zeta^2)^{3/2} ulps, at most 300 for 1e-6: 1e-13.
    BOOST_TEST(deviation(*closed::restitution_to_zero_overlap(alpha), e) < 1e-13);
    BOOST_TEST(closed::restitution_to_zero_force(alpha) > e);
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  BOOST_CHECK_EXCEPTION(closed::restitution_to_zero_force(-0.5), bad_input,
                        says("damping_coefficient", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::restitution_to_zero_overlap(-0.5), bad_input,
                        says("damping_coefficient", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration_to_zero_force(pair, -0.5, one), bad_input,
                        says("damping_coefficient", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration_to_zero_overlap(pair, -0.5, one), bad_input,
                        says("damping_coefficient", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration_to_zero_force(pair, 1, -one), bad_input,
                        says("speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration_to_zero_overlap(pair, 3, -one), bad_input,
                        says("speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::damping_coefficient_for(0), bad_input, says("restitution", "= 0 ", "(0, 1]"));
  BOOST_CHECK_EXCEPTION(closed::damping_coefficient_for(1.5), bad_input, says("restitution", "1.5", "(0, 1]"));
}
