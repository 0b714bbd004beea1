#include <boost/test/unit_test.hpp>

#include "../support/random_scenes.hpp"

#include <ricochet/closed_form/contact_duration.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

using namespace support;
namespace closed = ricochet::closed_form;

namespace {

const speed one = 1.0 * metres_per_second;
const contact_pair pair{3.0 * gigapascals, 2.0 * micrometres, 5e-15 * kilograms};

double deviation(double found, double expected) { return std::abs(found / expected - 1); }
double restitution_at(double cv) { return closed::restitution(cv / one, one); }
double lengthening(double cv) {
  return closed::contact_duration(pair, cv / one, one) / closed::contact_time(pair, one);
}

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_integration) {
  scenes random(22);
  double worst_e = 0, worst_time = 0;
  for (int i = 0; i < 40; ++i) {
    auto s = random.next();
    s.hunt_crossley_coefficient = random.log_uniform(1e-3, 30) / s.speed;
    const auto out = integrate(hunt_crossley_hertz(s, contact_duration{}), impact{s.speed}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - closed::restitution(s.hunt_crossley_coefficient, s.speed)));
    worst_time =
        std::max(worst_time, deviation(in_si(out.contact_duration),
                                       in_si(closed::contact_duration(s.pair, s.hunt_crossley_coefficient, s.speed))));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time);
  BOOST_TEST(worst_e < 1e-11);   // ten times the tolerance of the integration
  BOOST_TEST(worst_time < 1e-9); // the tolerance is one of e; time is carried along with it
}

BOOST_AUTO_TEST_CASE(solves_its_equation_in_fifty_digits) {
  using wide = boost::multiprecision::cpp_bin_float_50;
  for (double cv = 1e-12; cv < 2e6; cv *= 10) {
    const double e = restitution_at(cv);
    const auto residual = [&](const wide& trial) {
      return wide(log(1 + wide(cv)) - log(1 - wide(cv) * trial) - wide(cv) * (1 + trial));
    };
    // The residual falls through zero (e = 0 is no root of it), then rises; 1e-14 is the error that the header
    // promises.
    const wide below = wide(e) - 1e-14, above = wide(e) + 1e-14;
    BOOST_TEST_CONTEXT("cv = " << cv << ", e = " << e) {
      BOOST_TEST(bool(residual(below) < 0));
      BOOST_TEST(bool(above * cv >= 1 || residual(above) > 0));
    }
  }
}

BOOST_AUTO_TEST_CASE(printed_numbers) {
  // theory.md prints ten decimals: half of the last is 5e-11.
  BOOST_TEST(std::abs(restitution_at(0.1) - 0.9374755799) < 5.1e-11);
  BOOST_TEST(std::abs(restitution_at(1) - 0.5936242600) < 5.1e-11);
  BOOST_TEST(std::abs(restitution_at(5) - 0.1969802453) < 5.1e-11);
}

BOOST_AUTO_TEST_CASE(limits) {
  BOOST_TEST(restitution_at(0) == 1);
  BOOST_TEST(lengthening(0) == 1);
  for (const double cv : {1e-300, 1e-17, 1e-15, 1e-12, 1e-9}) {
    // 1 - 2cv/3 + 4cv^2/9; 5e-16: roundings of numbers next to one
    BOOST_TEST(std::abs(restitution_at(cv) - (1 - 2 * cv / 3 + 4 * cv * cv / 9)) < 5e-16);
    // The time grows by cv/15 at first order; 1e-13: roundings of the quadrature
    BOOST_TEST(std::abs(lengthening(cv) - (1 + cv / 15)) < 1e-13);
  }
  for (const double cv : {50., 1e4, 1e6}) // 1 - c e v = exp(-cv - ...) is below round-off
    BOOST_TEST(deviation(restitution_at(cv), 1 / cv) < 1e-15);
  // Rebound at the terminal speed 1/c: of its length cv delta_max/v, a 2/5 power law makes t/t_H grow as cv^{3/5}.
  BOOST_TEST(deviation(lengthening(1e6) / lengthening(1e5), std::pow(10, 0.6)) < 1e-4); // next order: ln(cv)/cv
}

BOOST_AUTO_TEST_CASE(monotone) {
  double e = 1, t = 1;
  for (double cv = 1e-3; cv < 1e3; cv *= 1.1) {
    const double next_e = restitution_at(cv), next_t = lengthening(cv);
    BOOST_TEST(next_e < e);
    BOOST_TEST(next_t > t);
    e = next_e, t = next_t;
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const inverse_speed c = 0.1 / one, wrong = -0.25 / one;
  BOOST_CHECK_EXCEPTION(closed::restitution(wrong, one), bad_input,
                        says("damping_coefficient", "-0.25 s/m", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::restitution(c, -one), bad_input, says("speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration(pair, wrong, one), bad_input,
                        says("damping_coefficient", "-0.25 s/m", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration(pair, c, 0.0 * one), bad_input, says("speed", "0 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::contact_duration(contact_pair{}, c, one), bad_input,
                        says("reduced_modulus", "0 Pa", "(0, inf)"));
}
