#include <boost/test/unit_test.hpp>

#include <ricochet/solve/stepper/tsitouras_papakostas.hpp>

#include <cmath>

namespace {
using table = ricochet::stepper::tsitouras_papakostas75_table;

/// The sum of weight_i node_i^power.
long double quadrature(const table::row& weight, int power) {
  long double sum = 0;
  for (std::size_t i = 0; i < table::stages; ++i) {
    long double node = 0;
    for (const long double a : table::a[i])
      node += a;
    sum += weight[i] * std::pow(node, static_cast<long double>(power));
  }
  return sum;
}
} // namespace

BOOST_AUTO_TEST_CASE(the_weights_integrate_polynomials_up_to_their_order) {
  for (int power = 0; power < table::order; ++power) {
    BOOST_TEST(std::abs(quadrature(table::b, power) - 1.L / (power + 1)) < 1e-18L);
    if (power < table::error_order)
      BOOST_TEST(std::abs(quadrature(table::e, power)) < 1e-18L);
  }
  BOOST_TEST(std::abs(quadrature(table::b, table::order) - 1.L / (table::order + 1)) > 1e-8L);
  BOOST_TEST(std::abs(quadrature(table::e, table::error_order)) > 1e-8L);
}

BOOST_AUTO_TEST_CASE(a_step_has_order_seven_and_its_estimate_order_five) {
  using state = std::array<double, 2>;
  const auto errors = [](double h) { // of one step and of its estimate, summed over starts with different energies
    ricochet::stepper::tsitouras_papakostas75_pair<state, double> stepper;
    const auto pendulum = [](const state& x, state& dx, double) { dx = {x[1], -std::sin(x[0])}; };
    std::pair sums{0., 0.};
    for (int start = 0; start < 20; ++start) {
      state x{0.1 * start, 1}, slope, whole, part, error, ignored;
      pendulum(x, slope, 0);
      stepper.do_step(pendulum, x, slope, 0, whole, h, error);
      for (int i = 0; i < 32; ++i) {
        pendulum(x, slope, 0);
        stepper.do_step(pendulum, x, slope, 0, part, h / 32, ignored);
        x = part;
      }
      sums.first += std::hypot(whole[0] - x[0], whole[1] - x[1]);
      sums.second += std::hypot(error[0], error[1]);
    }
    return sums;
  };
  const auto [coarse, coarse_estimate] = errors(0.6);
  const auto [fine, fine_estimate] = errors(0.3);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 8) < 0.7);
  BOOST_TEST(std::abs(std::log2(coarse_estimate / fine_estimate) - 6) < 0.7);
}
