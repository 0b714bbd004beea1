#include <boost/test/unit_test.hpp>

#include <ricochet/body/validate.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

/// The sentence of refusal, empty where the quantity is accepted.
template <class Quantity>
std::string refused(const Quantity& quantity, const range& allowed) {
  try {
    require("thing", quantity, allowed);
  } catch (const bad_input& e) {
    return e.what();
  }
  return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(open_and_closed_ends) {
  static_assert(!positive.contains(0) && positive.contains(5e-324) && positive.contains(1e308));
  static_assert(non_negative.contains(0) && non_negative.contains(-0.0) && !non_negative.contains(-5e-324));
  static_assert(poissons_ratio_range.contains(0) && poissons_ratio_range.contains(0.4999));
  static_assert(!poissons_ratio_range.contains(0.5));
  static_assert(modulus_ratio_range.contains(1e-4) && modulus_ratio_range.contains(0.98));
  static_assert(!modulus_ratio_range.contains(0.9999e-4) && !modulus_ratio_range.contains(0.9801));
  for (const range& each : {positive, non_negative, poissons_ratio_range, modulus_ratio_range}) {
    BOOST_TEST(!each.contains(not_a_number));
    BOOST_TEST(!each.contains(inf));
    BOOST_TEST(!each.contains(-inf));
  }
  constexpr range whole{.low = -inf, .high = inf, .high_included = true};
  static_assert(whole.contains(inf) && whole.contains(-inf) && !whole.contains(not_a_number));
}

BOOST_AUTO_TEST_CASE(text_of_a_range) {
  BOOST_TEST(positive.text() == "(0, inf)");
  BOOST_TEST(non_negative.text() == "[0, inf)");
  BOOST_TEST(poissons_ratio_range.text() == "[0, 0.5)");
  BOOST_TEST(modulus_ratio_range.text() == "[0.0001, 0.98]");
}

BOOST_AUTO_TEST_CASE(refusal_names_quantity_value_range_and_unit) {
  BOOST_TEST(refused(1.5, positive) == "");
  BOOST_TEST(refused(0.0, positive) == "thing = 0 is outside (0, inf)");
  BOOST_TEST(refused(-2.5, non_negative) == "thing = -2.5 is outside [0, inf)");
  BOOST_TEST(refused(inf, non_negative) == "thing = inf is outside [0, inf)");
  BOOST_TEST(refused(0.5, poissons_ratio_range) == "thing = 0.5 is outside [0, 0.5)");
  BOOST_TEST(refused(-3.0 * micrometres, positive) == "thing = -3e-06 m is outside (0, inf) m");
  BOOST_TEST(refused(0.0 * gigapascals, positive) == "thing = 0 Pa is outside (0, inf) Pa");
  BOOST_TEST(refused(-1.0 * joules_per_square_metre, non_negative) == "thing = -1 J/m^2 is outside [0, inf) J/m^2");
  BOOST_TEST(refused(not_a_number * metres_per_second, positive).find("nan m/s is outside (0, inf) m/s") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(bad_input_is_an_invalid_argument) {
  BOOST_CHECK_THROW(require("thing", -1.0, positive), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(parameter_knows_its_member) {
  struct law {
    length reach;
  };
  constexpr parameter p{"reach", &law::reach, positive};
  const law one{2.0 * metres};
  BOOST_TEST(in_si(one.*(p.member)) == 2);
  BOOST_TEST(p.name == std::string("reach"));
}
