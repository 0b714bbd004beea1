#include <boost/test/unit_test.hpp>

#include <ricochet/number/autodiff.hpp>
#include <ricochet/number/gradient.hpp>

#include "support/random_scenes.hpp"

using namespace support;
using pairwise = gradient<double, 2>;

BOOST_AUTO_TEST_CASE(functions_of_two_quantities_and_their_derivatives) {
  const double a = 1.3, b = 0.7;
  const auto check = [&](const auto& f) {
    const pairwise found = f(pairwise::seeded(a, 0), pairwise::seeded(b, 1));
    const auto by_a = f(seeded(a), dual<>(b)), by_b = f(dual<>(a), seeded(b));
    BOOST_TEST(found.value == f(a, b), boost::test_tools::tolerance(3e-14)); // of a difference, a fiftieth of its parts
    BOOST_TEST(found.slope[0] == by_a.derivative(1), boost::test_tools::tolerance(3e-14));
    BOOST_TEST(found.slope[1] == by_b.derivative(1), boost::test_tools::tolerance(3e-14));
  };
  using std::abs, std::exp, std::log, std::pow, std::sqrt;
  check([](auto x, auto y) { return x * x * y - x / y + y; });
  check([](auto x, auto y) { return sqrt(x + y * y) * log(x * y) / exp(y - x); });
  check([](auto x, auto y) { return pow(x, y) - abs(y - x); });
  check([](auto x, auto y) {
    auto sum = x;
    sum += y;
    sum *= x;
    sum -= y * y;
    sum /= x;
    return sum;
  });
}

BOOST_AUTO_TEST_CASE(the_root_of_a_zero_that_depends_on_nothing_does_not_either) {
  BOOST_TEST(sqrt(pairwise(0.0)).slope == pairwise{}.slope);
  BOOST_TEST(sqrt(pairwise::seeded(0.0, 1)).slope[1] == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(the_jacobian_of_a_contact_is_that_of_dual_numbers) {
  scenes random(4);
  for (int i = 0; i < 20; ++i) {
    const auto s = random.next();
    const auto model = viscoelastic_jkr(s);
    const scales unit = scales_at(model, s.speed);
    const reduced_model<double, decltype(model)> numbers(model, unit);
    const reduced_model<gradient<double, 3>, decltype(model)> by_gradient(numbers);
    const reduced_model<dual<>, decltype(model)> by_dual(numbers);
    auto x = numbers.touch(1.0);
    x[mutual_approach] = 0.01 * random.log_uniform(0.1, 1);
    x[numbers.coordinate] *= random.log_uniform(1, 2);
    typename decltype(by_gradient)::state_type seeded_at_once{}, all{};
    for (std::size_t j = 0; j < 3; ++j)
      seeded_at_once[j] = gradient<double, 3>::seeded(x[j], j);
    if (!by_gradient.derivative(seeded_at_once, all, 0))
      continue;
    for (std::size_t j = 0; j < 3; ++j) {
      typename decltype(by_dual)::state_type one{}, slope{};
      for (std::size_t k = 0; k < 3; ++k)
        one[k] = k == j ? seeded(x[k]) : dual<>(x[k]);
      BOOST_TEST(by_dual.derivative(one, slope, 0));
      for (std::size_t k = 0; k < 3; ++k)
        BOOST_TEST(std::abs(all[k].slope[j] - slope[k].derivative(1)) <=
                   1e-10 * (std::abs(slope[k].derivative(1)) + 1e-3));
    }
  }
}
