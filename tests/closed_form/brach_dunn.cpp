#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/closed_form/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {
const contact_pair glass_on_steel =
    between(sphere{materials::silver_coated_glass, 5.06 * micrometres}, flat_wall{materials::steel});
}

BOOST_AUTO_TEST_CASE(the_damping_ratio_is_scaled_by_the_two_fifths) {
  const speed v = 2.8 * metres_per_second;
  const double K = 4. / 3 * in_si(glass_on_steel.reduced_modulus), m = in_si(glass_on_steel.reduced_mass),
               r = in_si(glass_on_steel.reduced_radius);
  const double c = in_si(closed_form::damping_coefficient_of_brach_dunn(10.54, glass_on_steel, v));
  BOOST_TEST(c == 10.54 * std::pow(m / (r * r * r * K * std::sqrt(2.8)), 0.4), boost::test_tools::tolerance(1e-14));
  // twice the ratio, twice the coefficient; sixteen times the speed, 16^{-1/5} of it
  BOOST_TEST(in_si(closed_form::damping_coefficient_of_brach_dunn(21.08, glass_on_steel, v)) == 2 * c,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(in_si(closed_form::damping_coefficient_of_brach_dunn(10.54, glass_on_steel, 16.0 * v)) ==
                 c * std::pow(16, -0.2),
             boost::test_tools::tolerance(1e-14));
  BOOST_CHECK_THROW(closed_form::damping_coefficient_of_brach_dunn(-1, glass_on_steel, v), bad_input);
  BOOST_CHECK_THROW(closed_form::damping_coefficient_of_brach_dunn(1, glass_on_steel, 0.0 * v), bad_input);
}

BOOST_AUTO_TEST_CASE(at_the_equilibrium_depth_the_forces_balance) {
  const energy_per_area f0 = 250.0 * newtons_per_metre;
  const double depth = in_si(closed_form::equilibrium_depth(glass_on_steel, f0));
  const double r = in_si(glass_on_steel.reduced_radius), a = std::sqrt(r * depth);
  const double K = 4. / 3 * in_si(glass_on_steel.reduced_modulus);
  BOOST_TEST(K * a * a * a / r == 2 * pi<double>() * 250 * a, boost::test_tools::tolerance(1e-14));
  BOOST_CHECK_THROW(closed_form::equilibrium_depth(glass_on_steel, -1.0 * f0), bad_input);
}

BOOST_AUTO_TEST_CASE(the_hertzian_block_of_table_1_is_that_of_the_smaller_sphere) {
  const material glass{72.0 * gigapascals, 0.21, 2600.0 * kilograms_per_cubic_metre},
      steel{207.0 * gigapascals, 0.27, 7800.0 * kilograms_per_cubic_metre};
  const speed v = 2.8 * metres_per_second;
  const auto radius = [&](double diameter) {
    return in_si(
        closed_form::max_contact_radius(between(sphere{glass, diameter / 2 * micrometres}, flat_wall{steel}), v));
  };
  BOOST_TEST(std::abs(radius(8.6) - 2.911e-7) < 0.0006e-7);
  BOOST_TEST(std::abs(radius(10.12) - 3.4252e-7) < 0.0001e-7);
}
