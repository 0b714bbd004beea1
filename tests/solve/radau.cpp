#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/solve/radau.hpp>

using namespace support;

namespace {
const ice_case ice;

/// The approach rate some slowed time after touch, in this many steps of the same size.
template <int stages, class Model>
double rate_after(const Model& model, int steps) {
  using reduced_type = reduced_model<double, Model>;
  const reduced_type numbers(model, scales_at(model, 8.0 * metres_per_second));
  flow<reduced_type> f{numbers};
  typename stepper::radau<stages>::template method<flow<reduced_type>> method(
      1e-11, numbers.typical()); // Newton's iterations stop a thousandth below
  auto x = numbers.touch(1.0);
  for (int i = 0; i < steps; ++i) {
    x = method.try_step(f, x, 1.0 / steps).x;
    method.moved();
  }
  return x[approach_rate];
}
} // namespace

BOOST_AUTO_TEST_CASE(the_table_of_three_stages_is_that_of_radau5) {
  // Hairer & Wanner, Solving ODEs II, table IV.5.6 and (IV.8.17)-(IV.8.19)
  const auto& table = stepper::radau_table<3>::get();
  const double s = std::sqrt(6.);
  const double a[3][3] = {{(88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225},
                          {(296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225},
                          {(16 - s) / 36, (16 + s) / 36, 1. / 9}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      BOOST_TEST(std::abs(table.a(i, j) - a[i][j]) < 1e-14);
  const double gamma = table.error_slope;
  BOOST_TEST(std::abs(gamma - 1 / (3 + std::cbrt(9.) - std::cbrt(3.))) < 1e-14);
  BOOST_TEST(std::abs(table.error[0] - gamma / 3 * (-13 - 7 * s)) < 1e-13);
  BOOST_TEST(std::abs(table.error[1] - gamma / 3 * (-13 + 7 * s)) < 1e-13);
  BOOST_TEST(std::abs(table.error[2] + gamma / 3) < 1e-13);
}

BOOST_AUTO_TEST_CASE(collocation_is_exact_for_polynomials) {
  const auto check = [](const auto& table, int stages) {
    for (int i = 0; i < stages; ++i)
      for (int power = 0; power < stages; ++power) {
        double sum = 0;
        for (int j = 0; j < stages; ++j)
          sum += table.a(i, j) * std::pow(table.node[j], power);
        BOOST_TEST(std::abs(sum - std::pow(table.node[i], power + 1) / (power + 1)) < 1e-13);
      }
    for (int power = 0; power < 2 * stages - 1; ++power) { // the last row, to the full order
      double sum = 0;
      for (int j = 0; j < stages; ++j)
        sum += table.a(stages - 1, j) * std::pow(table.node[j], power);
      BOOST_TEST(std::abs(sum - 1. / (power + 1)) < 1e-13);
    }
  };
  check(stepper::radau_table<3>::get(), 3);
  check(stepper::radau_table<5>::get(), 5);
}

BOOST_AUTO_TEST_CASE(steps_are_of_order_five_and_nine) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  const double exact = rate_after<5>(model, 64);
  const auto order = [&](auto stages, int steps) {
    const auto error = [&](int n) { return std::abs(rate_after<stages>(model, n) - exact); };
    const double found = std::log2(error(steps) / error(2 * steps));
    BOOST_TEST_MESSAGE(stages << " stages: order " << found << ", error " << error(steps) << " of " << steps
                              << " steps");
    return found;
  };
  BOOST_TEST(std::abs(order(std::integral_constant<int, 3>{}, 16) - 5) < 0.4);
  BOOST_TEST(std::abs(order(std::integral_constant<int, 5>{}, 6) - 9) <
             0.5); // the fewest steps that converge leave room above round-off
}

BOOST_AUTO_TEST_CASE(order_holds_where_the_edge_is_stiff) {
  // From an edge at rest at some approach, over a stretch on which it keeps up with the bodies: here RODAS, of order
  // four, showed two.
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-16 * seconds));
  using reduced_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
  const reduced_type numbers(model, scales_at(model, 8.0 * metres_per_second));
  const auto after = [&](auto stages, int steps) {
    flow<reduced_type> f{numbers};
    typename stepper::radau<stages>::template method<flow<reduced_type>> method(1e-11, numbers.typical());
    auto x = numbers.touch(1.0);
    x[reduced_type::coordinate] = 1.8;
    x[mutual_approach] = numbers.approach_at(1.8, 1 - 1e-5);
    for (int i = 0; i < 14; ++i) { // onto the motion that it keeps to
      x = method.try_step(f, x, 1e-6 * (1 << i)).x;
      method.moved();
    }
    for (int i = 0; i < steps; ++i) {
      x = method.try_step(f, x, 0.4 / steps).x;
      method.moved();
    }
    return x[approach_rate];
  };
  const auto five = std::integral_constant<int, 5>{};
  const auto three = std::integral_constant<int, 3>{};
  const double exact = after(five, 16);
  const double found = std::log2(std::abs(after(three, 4) - exact) / std::abs(after(three, 8) - exact));
  BOOST_TEST_MESSAGE("order of three stages, stiff: " << found);
  BOOST_TEST(found > 4);
  const double higher = std::log2(std::abs(after(five, 2) - exact) / std::abs(after(five, 4) - exact));
  BOOST_TEST_MESSAGE("order of five stages, stiff: " << higher);
  BOOST_TEST(higher > 6);
}
