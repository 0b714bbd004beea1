#include <boost/test/unit_test.hpp>

#include <ricochet/law/crack/greenwood_table.hpp>

using namespace ricochet;

namespace {

/// Calls use(Q, exact closing value, exact opening value) at Q between the table's nodes, from alpha in long double.
template <class Use>
void along(double k, const Use& use) {
  for (long double alpha = 1e-9L; alpha < 1e15L; alpha *= 1.37L) {
    const auto shut = cohesive_zone::closing<long double>(alpha, k);
    const auto open = cohesive_zone::opening<long double>(alpha);
    use(shut.ratio, shut.slowness / shut.ratio, open.ratio, open.slowness / open.ratio);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_the_formula_for_every_modulus_ratio) {
  for (const double k : {1e-4, 1e-3, 0.02, 0.1, 0.5, 0.9, 0.98}) {
    const greenwood_table table(k);
    BOOST_TEST(table.modulus_ratio == k);
    long double worst_closing = 0, worst_opening = 0;
    along(k, [&](long double Qc, long double shut, long double Qo, long double open) {
      worst_closing = std::max(worst_closing, std::abs(table.closing.value(static_cast<double>(Qc)) / shut - 1));
      worst_opening = std::max(worst_opening, std::abs(table.opening.value(static_cast<double>(Qo)) / open - 1));
    });
    BOOST_TEST_MESSAGE("k " << k << ": closing off by " << worst_closing << ", opening by " << worst_opening);
    // 1e-13 is promised in beta, to which these are proportional with a factor of one at most
    BOOST_TEST(worst_closing < 1e-13L);
    BOOST_TEST(worst_opening < 1e-13L);
  }
}

BOOST_AUTO_TEST_CASE(slope_is_the_derivative_of_the_value) {
  const greenwood_table table(0.02);
  for (const greenwood_curve* curve : {&table.closing, &table.opening})
    for (double Q = 1e-6; Q < 1e12; Q *= 3.1) {
      const double h = 1e-4 * Q, difference = (curve->value(Q + h) - curve->value(Q - h)) / (2 * h);
      // h^2 = 1e-8 of third derivatives of order one, and 1e-16/1e-4 of rounding of the value
      const double expected = curve->slope(Q);
      BOOST_TEST(std::abs(difference - expected) < 1e-7 * std::abs(expected) + 1e-11 * curve->value(Q) / Q);
    }
}

BOOST_AUTO_TEST_CASE(is_continued_beyond_both_ends) {
  const greenwood_table table(0.1);
  for (const greenwood_curve* curve : {&table.closing, &table.opening}) {
    BOOST_TEST(curve->value(-1.0) == curve->value(0.0));
    BOOST_TEST(curve->slope(-1) == 0);
    BOOST_TEST(curve->slope(0) == 0);
    BOOST_TEST(curve->value(1e30) == curve->value(greenwood_curve::last));
    BOOST_TEST(curve->value(1e30) > 0);
    BOOST_TEST(curve->value(std::numeric_limits<double>::quiet_NaN()) == curve->value(0.0)); // and not beyond the table
  }
  // As Q -> 0, Q = alpha/3 for both edges, so 4 alpha/Q = 12; and slowness = 4 alpha k/pi of the closing one.
  BOOST_TEST(std::abs(table.opening.value(0.0) / 12 - 1) < 1e-13); // the table's error
  BOOST_TEST(std::abs(table.closing.value(0.0) / (12 * 0.1 / pi<double>()) - 1) < 1e-13);
}

BOOST_AUTO_TEST_CASE(is_continuous_from_piece_to_piece) {
  const greenwood_table table(0.02);
  for (int piece = 1; piece < 210; ++piece) {
    const double at = (4 + piece % 4) * std::exp2(piece / 4 - 6) - 0x1p-4; // of the opening curve, Q0 = 1/16
    const double below = table.opening.value(at * (1 - 1e-15)), above = table.opening.value(at * (1 + 1e-15));
    BOOST_TEST(std::abs(below / above - 1) < 1e-13); // twice the interpolation's error
  }
}
