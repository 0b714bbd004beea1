#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

bool same(double a, double b) { return std::abs(a / b - 1) < 2e-15; } // ten roundings

auto says(const std::string& name, const std::string& range) {
  return [=](const bad_input& e) {
    const std::string what = e.what();
    return what.find(name + " = ") != std::string::npos && what.find(range) != std::string::npos;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(published_form_at_the_hertzian_radius) {
  const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
  const kuwabara_kono law{1e-10 * seconds};
  for (const double approach : {1e-10, 4e-8}) {
    const double a = std::sqrt(1e-6 * approach);
    const configuration<dimensional> c{approach * metres, 2.0 * metres_per_second, a * metres, {}};
    // F_D = 2 A E* sqrt(R delta) rate [K (19)]; that is A times the rate of the elastic force, (3/2)A rho sqrt(delta)
    // rate
    const double rho = 4. / 3 * 3e9 * std::sqrt(1e-6);
    BOOST_TEST(same(in_si(law.coefficient(pair, c)) * 2, 2 * 1e-10 * 3e9 * std::sqrt(1e-6 * approach) * 2));
    BOOST_TEST(same(in_si(law.coefficient(pair, c)), 1.5 * 1e-10 * rho * std::sqrt(approach)));
  }
}

BOOST_AUTO_TEST_CASE(named_choices_of_the_bulk_time) {
  const duration T = 1e-11 * seconds;
  BOOST_TEST(same(in_si(bulk_time_of_krijt(T, 0.25)), 1.6e-10)); // the ice case of theory.md
  BOOST_TEST(same(in_si(bulk_time_of_three_element_solid(T, 0.02)), 9.8e-12));
  BOOST_TEST(in_si(bulk_time_of_krijt(duration{}, 0.25)) == 0);
  BOOST_TEST(in_si(bulk_time_of_three_element_solid(duration{}, 0.02)) == 0);
}

BOOST_AUTO_TEST_CASE(named_choices_refuse_wrong_input) {
  const duration T = 1e-11 * seconds;
  for (const double nu : {0., 0.5, -0.25, 1., not_a_number, inf}) // A diverges for nu -> 0
    BOOST_CHECK_EXCEPTION(bulk_time_of_krijt(T, nu), bad_input, says("poissons_ratio", "(0, 0.5)"));
  for (const double k : {0., 0.9e-4, 0.99, -1., not_a_number, inf})
    BOOST_CHECK_EXCEPTION(bulk_time_of_three_element_solid(T, k), bad_input, says("modulus_ratio", "[0.0001, 0.98]"));
  for (const double t : {-1., not_a_number, inf}) {
    BOOST_CHECK_EXCEPTION(bulk_time_of_krijt(t * seconds, 0.25), bad_input, says("relaxation_time", "[0, inf) s"));
    BOOST_CHECK_EXCEPTION(bulk_time_of_three_element_solid(t * seconds, 0.5), bad_input,
                          says("relaxation_time", "[0, inf) s"));
  }
}

BOOST_AUTO_TEST_CASE(unlike_bodies_are_weighted_by_their_compliances) {
  const material soft = materials::tedlar, hard = materials::steel;
  const duration one = 3e-11 * seconds, other = 5e-12 * seconds;
  const double c1 = (1 - 0.33 * 0.33) / 2e9, c2 = (1 - 0.28 * 0.28) / 190e9;
  BOOST_TEST(same(in_si(bulk_time_of_pair(soft, one, hard, other)), (c1 * 3e-11 + c2 * 5e-12) / (c1 + c2)));
  BOOST_TEST((bulk_time_of_pair(soft, one, hard, other) == bulk_time_of_pair(hard, other, soft, one)));
  BOOST_TEST(same(in_si(bulk_time_of_pair(soft, one, soft, one)), 3e-11));
}

BOOST_AUTO_TEST_CASE(unlike_bodies_refuse_wrong_input) {
  const material ice = materials::water_ice;
  // a negative time of one body may hide behind a larger one of the other
  BOOST_CHECK_THROW(bulk_time_of_pair(ice, -1e-12 * seconds, ice, 1e-10 * seconds), bad_input);
  BOOST_CHECK_THROW(bulk_time_of_pair(ice, 1e-12 * seconds, ice, not_a_number * seconds), bad_input);
  material wrong = ice;
  wrong.youngs_modulus = -1.0 * gigapascals;
  BOOST_CHECK_THROW(bulk_time_of_pair(wrong, 1e-12 * seconds, ice, 1e-10 * seconds), bad_input);
}
