#include <boost/test/unit_test.hpp>

#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/number/multiprecision.hpp>

using namespace ricochet;
using namespace ricochet::units;
namespace closed = ricochet::closed_form;
using fine = multiprecise<50>;

namespace {

const speed one = 1.0 * metres_per_second;
const contact_pair pair{110.0 * gigapascals, 2.0 * micrometres, 2.5e-13 * kilograms};

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

/// Krijt 2013 (29) as it is printed.
fine as_printed(const fine& x) {
  return sqrt(6 * sqrt(fine(3)) / 5) * sqrt(1 - x * x / 6) * sqrt(sqrt(x / (x + 2 * sqrt(fine(6) / 5 - x * x / 5))));
}

/// e_P at v_y/v = x.
double at(double x) { return closed::plastic_restitution(x * metres_per_second, one); }

} // namespace

BOOST_AUTO_TEST_CASE(printed_numbers) {
  // Twelve decimals: half of the last is 5e-13.
  BOOST_TEST(std::abs(at(0.5) - 0.930625877274) < 5.1e-13);
  BOOST_TEST(std::abs(at(0.1) - 0.658558336665) < 5.1e-13);
  BOOST_TEST(std::abs(closed::yield_speed_factor() - 10.2006561595) < 5.1e-11); // ten decimals
  const double E = 110e9, R = 2e-6, m = 2.5e-13, pressure = 1.6 * 2e9;
  BOOST_TEST(deviation(in_si(closed::contact_yield_pressure(2.0 * gigapascals)), pressure) < 1e-15); // one rounding
  const double v = std::sqrt(10.2006561595 * std::pow(R, 3) * std::pow(pressure, 5) / (m * std::pow(E, 4)));
  // half of the last decimal of the factor, of which this is the root
  BOOST_TEST(deviation(in_si(closed::yield_speed(pair, 2.0 * gigapascals)), v) < 3e-12);
}

BOOST_AUTO_TEST_CASE(yields_where_the_elastic_contact_reaches_the_pressure) {
  const modulus Y = 2.0 * gigapascals;
  const length a = closed::max_contact_radius(pair, closed::yield_speed(pair, Y));
  const modulus pressure = 2.0 * pair.reduced_modulus * a / (std::numbers::pi * pair.reduced_radius); // Krijt 2013 (1)
  BOOST_TEST(deviation(double(pressure / Y), 1.6) < 1e-14);                                           // roundings
}

BOOST_AUTO_TEST_CASE(equals_the_printed_formula_in_50_digits) {
  double worst = 0, worst_loss = 0;
  for (double x = 1e-12; x < 1; x *= 1.37) {
    const fine exact = as_printed(x);
    worst = std::max(worst, double(abs(at(x) / exact - 1)));
    const double lost = closed::plastic_loss(x * metres_per_second, one);
    worst_loss = std::max(worst_loss, double(abs(lost / (1 - exact * exact) - 1)));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst << ", loss " << worst_loss);
  BOOST_TEST(worst < 1e-15); // a few roundings
  BOOST_TEST(worst_loss < 3e-15);
  for (const fine& x : {fine("0.3"), fine("0.999")}) {
    const closed::detail::thornton_ning_impact<fine> impact(x, 1);
    BOOST_TEST(abs(impact.restitution() - as_printed(x)) < 1e-47); // the roundings of 50 digits
    BOOST_TEST(abs(impact.loss() - 1 + square(as_printed(x))) < 1e-47);
  }
}

BOOST_AUTO_TEST_CASE(nothing_cancels_next_to_the_yield_speed) {
  double worst = 0, worst_loss = 0;
  for (double above = 0.3; above > 1e-15; above /= 3) {
    const double v_y = 3.7, v = v_y * (1 + above);
    const fine exact = as_printed(fine(v_y) / fine(v));
    worst = std::max(
        worst, double(abs(closed::plastic_restitution(v_y * metres_per_second, v * metres_per_second) / exact - 1)));
    const double loss = closed::plastic_loss(v_y * metres_per_second, v * metres_per_second);
    // What 50 digits leave of 1 - e^2 = 1e-30 are 20.
    worst_loss = std::max(worst_loss, double(abs(loss / (1 - exact * exact) - 1)));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst << ", loss " << worst_loss);
  BOOST_TEST(worst < 1e-15); // a few roundings
  BOOST_TEST(worst_loss < 3e-15);
}

BOOST_AUTO_TEST_CASE(is_continuous_at_the_yield_speed_with_its_slope) {
  const speed v_y = 3.0 * metres_per_second;
  for (const double ratio : {1e-6, 0.5, 1 - 1e-15, 1.}) {
    BOOST_TEST(closed::plastic_restitution(v_y, ratio * v_y) == 1);
    BOOST_TEST(closed::plastic_loss(v_y, ratio * v_y) == 0);
  }
  // 1 - e = (6/25) u^2 + ..., u = 1 - v_y/v, without a linear term; the next is below u^3
  for (const double u : {1e-1, 1e-3, 1e-5, 1e-7}) {
    const double lost = closed::plastic_loss((1 - u) * metres_per_second, one);
    BOOST_TEST(std::abs(lost / (u * u) - 12. / 25) < u + 1e-8); // 1e-8: u itself, 1e-7, comes rounded at 1e-16
    BOOST_TEST(std::abs(1 - at(1 - u) - 6. / 25 * u * u) < u * u * u + 3e-16);
  }
  const fine h("1e-20");
  BOOST_TEST(abs(as_printed(1) - 1) < 1e-48);
  BOOST_TEST(abs((1 - as_printed(1 - h)) / h) < 1e-19);
}

BOOST_AUTO_TEST_CASE(fast_impacts) {
  const double factor = std::pow(1.2, 0.375) * std::pow(1.5, 0.25);
  BOOST_TEST(std::abs(factor - 1.18499) < 5e-6); // five decimals
  for (const double x : {1e-4, 1e-8, 1e-16, 1e-200})
    BOOST_TEST(deviation(at(x), factor * std::pow(x, 0.25)) < x + 1e-15); // the next order is x/(8 sqrt(6/5))
}

BOOST_AUTO_TEST_CASE(falls_with_the_speed_and_stays_in_its_range) {
  double before = 1;
  for (double v = 1.001; v < 1e12; v *= 1.01) {
    const double now = closed::plastic_restitution(one, v * metres_per_second);
    BOOST_TEST(now < before);
    BOOST_TEST(now > 0);
    BOOST_TEST(std::abs(now * now + closed::plastic_loss(one, v * metres_per_second) - 1) < 1e-15); // roundings
    before = now;
  }
  for (double v = 1; v < 1 + 1e-7; v += 1e-10)
    BOOST_TEST(closed::plastic_restitution(one, v * metres_per_second) <= 1);
}

BOOST_AUTO_TEST_CASE(size_law) {
  // 200 MPa + 0.6 MPa m^{1/2}/sqrt(l): at 4 um 200 + 300 MPa, at 1 mm 200 + 18.973665961 MPa
  const closed::size_strengthening per_metre{
      .macroscopic_strength = 200.0 * megapascals, .gain = 0.6 * megapascals, .reference_length = 1.0 * metres};
  const closed::size_strengthening per_micrometre{
      .macroscopic_strength = 200.0 * megapascals, .gain = 600.0 * megapascals, .reference_length = 1.0 * micrometres};
  for (const auto& law : {per_metre, per_micrometre}) { // the same law
    BOOST_TEST(deviation(in_si(closed::yield_strength(law, 4.0 * micrometres)), 500e6) < 1e-15);
    BOOST_TEST(deviation(in_si(closed::yield_strength(law, 1.0 * millimetres)), 218.973665961e6) < 1e-11);
  }
  // The power alone, n = 1 and n = 2/3.
  const closed::size_strengthening inverse{
      .gain = 30.0 * megapascals, .reference_length = 2.0 * micrometres, .exponent = 1};
  BOOST_TEST(deviation(in_si(closed::yield_strength(inverse, 0.1 * micrometres)), 600e6) < 1e-15);
  const closed::size_strengthening between{.macroscopic_strength = 100.0 * megapascals,
                                           .gain = 5.0 * megapascals,
                                           .reference_length = 8.0 * micrometres,
                                           .exponent = 2. / 3};
  BOOST_TEST(deviation(in_si(closed::yield_strength(between, 1.0 * micrometres)), 120e6) < 1e-15);
}

BOOST_AUTO_TEST_CASE(faster_impacts_press_larger_and_so_weaker_volumes) {
  const closed::size_strengthening law{
      .macroscopic_strength = 200.0 * megapascals, .gain = 600.0 * megapascals, .reference_length = 1.0 * micrometres};
  // l of Krijt 2013 (33) by hand: (15 m* v^2 R^2/(16 E*))^{1/5}
  const double l = std::pow(15 * 2.5e-13 * 100 * 4e-12 / (16 * 110e9), 0.2);
  const speed v = 10.0 * metres_per_second;
  BOOST_TEST(deviation(in_si(closed::yield_strength(law, closed::max_contact_radius(pair, v))),
                       200e6 + 600e6 * std::sqrt(1e-6 / l)) < 1e-14); // roundings of powers
  BOOST_TEST(in_si(closed::yield_strength(law, closed::max_contact_radius(pair, 2.0 * v))) <
             in_si(closed::yield_strength(law, closed::max_contact_radius(pair, v))));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  BOOST_CHECK_EXCEPTION(closed::contact_yield_pressure(modulus{}), bad_input,
                        says("yield_strength", "0 Pa", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::yield_speed(pair, -5.0 * pascals), bad_input,
                        says("yield_strength", "-5 Pa", "(0, inf)"));
  auto flat = pair;
  flat.reduced_radius = length{};
  BOOST_CHECK_EXCEPTION(closed::yield_speed(flat, 1.0 * gigapascals), bad_input,
                        says("reduced_radius", "0 m", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::plastic_restitution(-one, one), bad_input, says("yield_speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::plastic_restitution(one, -one), bad_input, says("speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::plastic_loss(-one, one), bad_input, says("yield_speed", "-1 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::plastic_loss(one, speed{}), bad_input, says("speed", "0 m/s", "(0, inf)"));
  const closed::size_strengthening right{
      .macroscopic_strength = 1.0 * gigapascals, .gain = 1.0 * gigapascals, .reference_length = 1.0 * micrometres};
  auto law = right;
  law.macroscopic_strength = -1.0 * pascals;
  const length l = 1.0 * metres;
  BOOST_CHECK_EXCEPTION(closed::yield_strength(law, l), bad_input, says("macroscopic_strength", "-1 Pa", "[0, inf)"));
  law = right;
  law.gain = -1.0 * pascals;
  BOOST_CHECK_EXCEPTION(closed::yield_strength(law, l), bad_input, says("gain", "-1 Pa", "[0, inf)"));
  law = right;
  law.reference_length = length{};
  BOOST_CHECK_EXCEPTION(closed::yield_strength(law, l), bad_input, says("reference_length", "0 m", "(0, inf)"));
  for (const double n : {0.4, 1.1}) {
    law = right;
    law.exponent = n;
    BOOST_CHECK_EXCEPTION(closed::yield_strength(law, l), bad_input, says("exponent", shown(n), "[0.5, 1]"));
  }
  BOOST_CHECK_EXCEPTION(closed::yield_strength(right, length{}), bad_input, says("length", "0 m", "(0, inf)"));
}
