#include <boost/test/unit_test.hpp>

#include <ricochet/law/crack/cohesive_zone.hpp>
#include <ricochet/number/multiprecision.hpp>

#include "support/reference_rows.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace zone = ricochet::cohesive_zone;
using ricochet::pi;

namespace {

template <class T>
struct ratio_and_speed {
  T ratio, speed;
};

/// beta and v of the closing edge, from Q = (beta - k)/(1 - beta) and 1/v.
template <class T>
ratio_and_speed<T> closing(const T& alpha, const T& k) {
  const auto p = zone::closing<T>(alpha, k);
  return {(k + p.ratio) / (1 + p.ratio), 1 / p.slowness};
}

/// beta and v of the opening edge, from Q = (1 - k beta)/(beta - 1) and pi beta/v.
template <class T>
ratio_and_speed<T> opening(const T& alpha, const T& k) {
  const auto p = zone::opening<T>(alpha);
  const T beta = (1 + p.ratio) / (k + p.ratio);
  return {beta, pi<T>() * beta / p.slowness};
}

template <class T>
T deviation(const T& found, const T& expected) {
  return std::abs(found / expected - 1);
}

} // namespace

using scalars = std::tuple<double, long double>;

BOOST_AUTO_TEST_CASE_TEMPLATE(reference_values, T, scalars) {
  const auto rows = support::read_rows("geff_checkvalues.csv");
  BOOST_TEST_REQUIRE(rows.size() == 50u);
  for (const auto& row : rows) {
    const auto number = [&](const char* name) { return static_cast<T>(std::stold(row.at(name))); };
    const T k = number("k"), alpha = number("alpha");
    const auto shut = closing(alpha, k), open = opening(alpha, k);
    BOOST_TEST_CONTEXT("k " << k << ", alpha " << alpha) {
      // 1e-12 is asked for; the file has 17 digits
      BOOST_TEST(deviation(shut.ratio, number("beta_close")) < 1e-12);
      BOOST_TEST(deviation(shut.speed, number("vhat_close")) < 1e-12);
      BOOST_TEST(deviation(open.ratio, number("beta_open")) < 1e-12);
      BOOST_TEST(deviation(open.speed, number("vhat_open")) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(integrals_agree_with_quadrature) {
  // Dawson's integral as D(s)/s = int_0^1 exp(-s^2 (1-u^2)) du; so with x = alpha (1-u^2): N = int e^-x,
  // n = int 1-e^-x, I = int (1-e^-x)/x, i = int 1-(1-e^-x)/x.
  boost::math::quadrature::tanh_sinh<long double> integrate;
  for (const long double alpha : {-0.5L, 1e-5L, 1e-2L, 0.5L, 0.999L, 1.L, 1.001L, 3.L, 20.L, 51.L, 52.L, 61.L, 100.L}) {
    const auto mean = [&](auto f) {
      // u -> 1-s, so that 1-u^2 = s(2-s) keeps its digits where e^-x varies
      return integrate.integrate([&](long double s) { return f(alpha * s * (2 - s)); }, 0.L, 1.L, 1e-18L);
    };
    const auto z = zone::evaluate_integrals<long double>(alpha);
    BOOST_TEST_CONTEXT("alpha " << alpha) {
      // 2e-16: the quadrature's own accuracy in long double, with a thousand round-offs to spare
      BOOST_TEST(deviation(z.N, mean([](long double x) { return std::exp(-x); })) < 2e-16L);
      BOOST_TEST(deviation(z.n, mean([](long double x) { return -std::expm1(-x); })) < 2e-16L);
      BOOST_TEST(deviation(z.I, mean([](long double x) { return -std::expm1(-x) / x; })) < 2e-16L);
      if (alpha > 0.1L) // else the integrand cancels
        BOOST_TEST(deviation(z.i, mean([](long double x) { return 1 + std::expm1(-x) / x; })) < 5e-16L);
    }
  }
}

BOOST_AUTO_TEST_CASE(complements_keep_their_digits) {
  for (const double alpha : {1e-300, 1e-12, 1e-6, 0.1, 0.9}) {
    const auto z = zone::evaluate_integrals(alpha);
    const auto fine = zone::evaluate_integrals(ricochet::multiprecise<50>(alpha));
    // five ulp: sums of a quickly falling series
    BOOST_TEST(deviation(z.n, static_cast<double>(fine.n)) < 1e-15);
    BOOST_TEST(deviation(z.i, static_cast<double>(fine.i)) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(slopes_are_derivatives) {
  using fine = ricochet::multiprecise<50>;
  const fine h = 1e-16; // relative step; the error of the central difference is h^2, that of rounding 1e-50/h
  for (const double k : {1e-4, 0.02, 0.5, 0.98})
    for (const double alpha : {1e-6, 0.1, 0.99, 1., 1.01, 5., 50., 150., 1e4}) {
      const fine a = alpha, up = a * (1 + h), down = a * (1 - h), kk = k;
      const auto difference = [&](const auto& curve) {
        return static_cast<double>((curve(up).ratio - curve(down).ratio) / (up - down));
      };
      const double of_closing = difference([&](const fine& x) { return zone::closing<fine>(x, kk); });
      const double of_opening = difference([](const fine& x) { return zone::opening<fine>(x); });
      BOOST_TEST_CONTEXT("k " << k << ", alpha " << alpha) {
        // 1e-12: what cancels between above and below in double, seen to be 1e-13 at worst
        BOOST_TEST(deviation(zone::closing<double>(alpha, k).slope, of_closing) < 1e-12);
        BOOST_TEST(deviation(zone::opening<double>(alpha).slope, of_opening) < 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(both_limits) {
  for (const long double k : {1e-4L, 0.02L, 0.5L, 0.98L}) {
    // fast: beta -> k and 1/k; alpha = 0 itself is in the domain
    BOOST_TEST(zone::closing<long double>(0, k).ratio == 0);
    BOOST_TEST(zone::closing<long double>(0, k).slowness == 0);
    BOOST_TEST(zone::opening<long double>(0).ratio == 0);
    // slow: |1-beta| = (1-k)[ln(4 alpha)+gamma]/(2 alpha), alpha = pi/(4v), to relative order |1-beta| < 2e-7
    for (const auto& edge : {closing<long double>(1e8L, k), opening<long double>(1e8L, k)}) {
      const long double alpha = pi<long double>() / (4 * edge.speed);
      const long double expected = (1 - k) * (std::log(4 * alpha) + 0.5772157L) / (2 * alpha);
      BOOST_TEST(deviation(std::abs(1 - edge.ratio), expected) < 4e-7L);
    }
  }
}

BOOST_AUTO_TEST_CASE(inversion) {
  for (const double k : {1e-4, 0.02, 0.98})
    for (const double alpha : {1e-8, 1e-3, 0.7, 4., 1e3}) {
      const auto curve = [k](double a) { return zone::closing<double>(a, k); };
      // 1e-12: a dozen ulp over the slope d ln Q/d ln alpha, which is above 0.1
      BOOST_TEST(deviation(zone::invert(curve, curve(alpha).ratio, 10 * alpha), alpha) < 1e-12);
      BOOST_TEST(deviation(zone::invert(zone::opening<double>, zone::opening(alpha).ratio, 0.1 * alpha), alpha) <
                 1e-12);
    }
}
