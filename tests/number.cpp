#include <boost/test/unit_test.hpp>

#include <ricochet/number.hpp>

using namespace ricochet;

using floats = std::tuple<float, double, long double>;

BOOST_AUTO_TEST_CASE_TEMPLATE(plain_numbers_are_their_own_value, T, floats) {
  static_assert(std::same_as<real_of<T>, T>);
  static_assert(!number_traits<T>::inverts_exactly);
  static_assert(value_of(T(0.25)) == T(0.25));
  BOOST_TEST(pi<T>() == std::acos(T(-1)));
  const T gamma = T(0.577215664901532860606512090082402431L);
  BOOST_TEST(number_traits<T>::euler_gamma() == gamma);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(powers, T, floats) {
  static_assert(square(T(-3)) == T(9));
  static_assert(cube(T(-3)) == T(-27));
  // one ulp or two: pow with a rounded exponent
  BOOST_TEST(std::abs(cube_root(T(27)) - T(3)) <= 4 * std::numeric_limits<T>::epsilon() * 3);
  BOOST_TEST(cube_root(T(0)) == T(0));
  const T small = std::numeric_limits<T>::min();
  // the rounding of the exponent 1/3 is multiplied by the logarithm
  BOOST_TEST(std::abs(cube(cube_root(small)) / small - 1) < -std::log(small) * std::numeric_limits<T>::epsilon());
}

BOOST_AUTO_TEST_CASE(select_on_a_plain_condition_evaluates_one_side) {
  int yes = 0, no = 0;
  const auto ask = [&](bool condition) {
    return select<double>(
        condition, [&] { return ++yes, 1.5; }, [&] { return ++no, 2.5; });
  };
  BOOST_TEST(ask(true) == 1.5);
  BOOST_TEST((yes == 1 && no == 0));
  BOOST_TEST(ask(false) == 2.5);
  BOOST_TEST((yes == 1 && no == 1));
  // the sides may have other types than the result
  static_assert(std::same_as<float, decltype(select<float>(
                                        true, [] { return 1; }, [] { return 2.0L; }))>);
}

BOOST_AUTO_TEST_CASE(evaluate_calls_the_function) {
  struct line {
    double value(double x) const { return 2 * x + 1; }
    double slope(double) const { return 2; }
  };
  BOOST_TEST(evaluate<double>(line{}, 3.0) == 7);
}

BOOST_AUTO_TEST_CASE(what_stays_the_same_is_divided_by_through_its_reciprocal) {
  const constant<double> three = 3.0;
  static_assert(std::same_as<decltype(1.0 / three), double>);
  BOOST_TEST(2 * three == 6.0);
  BOOST_TEST(1.0 / three == 1.0 / 3.0);
  BOOST_TEST(std::sqrt(three) == std::sqrt(3.0));
  BOOST_TEST(std::abs(10.0 / three - 10.0 / 3.0) <= 2 * std::numeric_limits<double>::epsilon() * 10.0 / 3.0);
}
