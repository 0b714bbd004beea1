#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/body/sphere.hpp>

using namespace ricochet;
using namespace ricochet::units;

BOOST_AUTO_TEST_CASE(mass_of_a_sphere) {
  // Brach & Dunn 1995 use 1.41e-12 kg for 10.12 um of glass; 1 m of unit density: 4 pi/3.
  const sphere unit{{pascals, 0, kilograms_per_cubic_metre}, metres};
  BOOST_TEST(std::abs(in_si(unit.mass()) - 4.18879020478639098) < 1e-15); // an ulp
  const sphere glass{materials::silver_coated_glass, 5.06 * micrometres};
  BOOST_TEST(std::abs(in_si(glass.mass()) - 1.41096e-12) < 1e-17); // the digits given
}

BOOST_AUTO_TEST_CASE(mass_goes_with_the_cube_of_the_radius) {
  const sphere small{materials::water_ice, 2.0 * micrometres}, large{materials::water_ice, 4.0 * micrometres};
  BOOST_TEST(in_si(large.mass()) == 8 * in_si(small.mass())); // exact: powers of two
}

BOOST_AUTO_TEST_CASE(a_wall_has_only_a_material) {
  static_assert(sizeof(flat_wall) == sizeof(material));
  constexpr flat_wall wall{materials::steel};
  BOOST_TEST((wall.solid.youngs_modulus == materials::steel.youngs_modulus));
}
