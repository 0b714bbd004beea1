#include <boost/test/unit_test.hpp>

#include <ricochet/number/multiprecision.hpp>

#include "support/every_law.hpp"

#include <ricochet/model/compose.hpp>
#include <ricochet/solve/collision.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

using namespace support;
using fine = multiprecise<50>;

namespace {

/// Largest relative deviation of the laws in T from those in 50 digits, the same numbers given to both.
template <class T>
double worst_deviation() {
  double worst = 0;
  for (const auto& contact : contacts()) {
    const auto rounded = contact.in<T>([](double x) { return static_cast<T>(x); });
    const auto exact = rounded.template in<fine>([](const T& x) { return fine(x); });
    const auto compare = [&](const std::vector<T>& found, const std::vector<fine>& expected) {
      for (std::size_t i = 0; i < found.size(); ++i)
        worst = std::max(worst, static_cast<double>(abs(fine(found[i]) / expected[i] - 1)));
    };
    compare(values_in_the_loop(rounded), values_in_the_loop(exact));
    compare(values_at_set_up(rounded), values_at_set_up(exact));
  }
  return worst;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_law_in_float_double_and_long_double) {
  // log((1-k)/(1-beta)) at beta = 0.03 is 0.01: two digits of the number system are lost in the worst of the values.
  BOOST_TEST(worst_deviation<float>() < 200 * std::numeric_limits<float>::epsilon());
  BOOST_TEST(worst_deviation<double>() < 200 * std::numeric_limits<double>::epsilon());
  // the fits' constants are doubles and the table is one of doubles, whatever the scalar
  BOOST_TEST(worst_deviation<long double>() < 20 * std::numeric_limits<double>::epsilon());
}

BOOST_AUTO_TEST_CASE(traits) {
  static_assert(number_traits<fine>::inverts_exactly);
  static_assert(std::same_as<real_of<fine>, fine>);
  BOOST_TEST(static_cast<double>(abs(sin(pi<fine>()))) < 1e-49); // the last of 50 digits
  // gamma to 40 digits, from tables
  const fine gamma("0.5772156649015328606065120900824024310421593359");
  BOOST_TEST(static_cast<double>(abs(number_traits<fine>::euler_gamma() - gamma)) < 1e-45);
  BOOST_TEST(static_cast<double>(cube_root(fine(27)) - 3) < 1e-48);
  BOOST_TEST((cube_root(fine(0)) == 0));
}

BOOST_AUTO_TEST_CASE(the_end_of_a_contact_is_located_to_the_digits_of_the_number) {
  // Undamped JKR: what the contact takes is the energy that it has at its fold, less that where the bodies touch.
  using namespace ricochet::units;
  const contact_pair pair{1.0 * pascals, 1.0 * metres, 1.0 * kilograms};
  const auto model = compose(pair, hertz{}, jkr{0.125 * joules_per_square_metre});
  const reduced_model<fine, std::remove_const_t<decltype(model)>> numbers(model, scales{});
  const auto touch = numbers.contact(numbers.touch(fine(1)), 0);
  const fine lost = numbers.adhesion.exit_energy(numbers.pair) - numbers.potential(touch);
  for (const int v : {1, 2, 3, 4}) {
    collision<decltype(numbers), stepper::fehlberg78> solver(numbers, fine(1e-26), 1'000'000);
    const fine e = solver.solve(fine(v)).restitution.value();
    BOOST_TEST(static_cast<double>(abs(e - sqrt(1 - 2 * lost / (v * v)))) < 1e-26);
  }
}
