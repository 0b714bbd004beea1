#include <boost/test/unit_test.hpp>

#include <ricochet/solve/stepper/radau_table.hpp>

#include <Eigen/LU>

#include <cmath>
#include <complex>

using namespace ricochet;

namespace {
template <int stages>
const stepper::radau_table<stages>& coefficients = stepper::radau_table<stages>::get();

template <class Check>
void for_both(const Check& check) {
  check(std::integral_constant<int, 3>{});
  check(std::integral_constant<int, 5>{});
}
} // namespace

BOOST_AUTO_TEST_CASE(the_table_of_three_stages_is_that_of_radau5) {
  // Hairer & Wanner, Solving ODEs II, table IV.5.6 and (IV.8.17)-(IV.8.19)
  const double s = std::sqrt(6.);
  const double a[3][3] = {{(88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225},
                          {(296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225},
                          {(16 - s) / 36, (16 + s) / 36, 1. / 9}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      BOOST_TEST(std::abs(coefficients<3>.a(i, j) - a[i][j]) < 1e-14);
  const double gamma = coefficients<3>.error_slope;
  BOOST_TEST(std::abs(gamma - 1 / (3 + std::cbrt(9.) - std::cbrt(3.))) < 1e-14);
  BOOST_TEST(std::abs(coefficients<3>.error[0] - gamma / 3 * (-13 - 7 * s)) < 1e-13);
  BOOST_TEST(std::abs(coefficients<3>.error[1] - gamma / 3 * (-13 + 7 * s)) < 1e-13);
  BOOST_TEST(std::abs(coefficients<3>.error[2] + gamma / 3) < 1e-13);
}

BOOST_AUTO_TEST_CASE(collocation_is_exact_for_polynomials) {
  for_both([](auto stages) {
    const auto& [node, a] = std::tie(coefficients<stages>.node, coefficients<stages>.a);
    for (int i = 0; i < stages; ++i)
      for (int power = 0; power < (i + 1 < stages ? stages : 2 * stages - 1);
           ++power) { // the last row to the full order
        double sum = 0;
        for (int j = 0; j < stages; ++j)
          sum += a(i, j) * std::pow(node[j], power);
        BOOST_TEST(std::abs(sum - std::pow(node[i], power + 1) / (power + 1)) < 1e-15);
      }
    BOOST_TEST((coefficients<stages>.inverse * a).isIdentity(1e-14));
  });
}

BOOST_AUTO_TEST_CASE(modes_give_the_inverse) {
  for_both([](auto stages) {
    const auto& t = coefficients<stages>;
    const auto eigenvalue = [&](int m) { return std::complex(t.eigenvalue_real[m], t.eigenvalue_imaginary[m]); };
    for (int i = 0; i < stages; ++i)
      for (int j = 0; j < stages; ++j) {
        std::complex<double> one = 0, inverse = 0;
        for (int m = 0; m < t.modes; ++m) {
          const std::complex part = std::complex(t.from_modes.real(m, i), t.from_modes.imaginary(m, i)) *
                                    std::complex(t.to_modes.real(m, j), t.to_modes.imaginary(m, j));
          one += part;
          inverse += eigenvalue(m) * part;
        }
        BOOST_TEST(std::abs(one.real() - (i == j)) < 1e-14);
        BOOST_TEST(std::abs(inverse.real() - t.inverse(i, j)) < 1e-13);
      }
    BOOST_TEST(t.eigenvalue_imaginary[0] == 0);
    BOOST_TEST(t.error_slope == 1 / t.eigenvalue_real[0], boost::test_tools::tolerance(1e-15));
  });
}

BOOST_AUTO_TEST_CASE(the_error_is_that_of_a_quadrature_of_lower_order) {
  // Its weights and that at the beginning together give zero for all powers but as many as there are stages.
  for_both([](auto stages) {
    const auto& t = coefficients<stages>;
    for (int power = 0; power < stages; ++power) {
      double sum = power == 0 ? t.error_slope : 0;
      for (int i = 0; i < stages; ++i)
        sum += t.quadrature_error[i] * std::pow(t.node[i], power);
      BOOST_TEST(std::abs(sum) < 1e-15);
    }
    BOOST_TEST((t.error - t.inverse.transpose() * t.quadrature_error).cwiseAbs().maxCoeff() < 1e-14);
  });
}

BOOST_AUTO_TEST_CASE(powers_give_the_polynomial_through_the_nodes) {
  for_both([](auto stages) {
    const auto& t = coefficients<stages>;
    for (int i = 0; i <= stages; ++i)
      for (int j = 0; j <= stages; ++j) { // the polynomial that is 1 at node j, 0 at the others and at 0
        double sum = 0;
        for (int power = stages; power >= 0; --power)
          sum = sum * (i == 0 ? 0 : t.node[i - 1]) + t.powers(power, j);
        BOOST_TEST(std::abs(sum - (i == j)) < 1e-13);
      }
  });
}
