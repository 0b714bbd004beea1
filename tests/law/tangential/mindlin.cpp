#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/tangential/mindlin.hpp>
#include <ricochet/model/compose.hpp>

using namespace ricochet;
using namespace ricochet::units;

BOOST_AUTO_TEST_CASE(springs_along_the_surface_are_softer_and_slip_in_proportion_to_their_press) {
  const mindlin_law<reduced<double>> law{.friction_coefficient = 0.3, .stiffness_ratio = 0.75};
  BOOST_TEST(law.stiffness({.reduced_modulus = 8, .reduced_radius = 1, .reduced_mass = 1}) == 6);
  BOOST_TEST(std::abs(law.largest_stretch(2.) - 0.8) < 1e-15); // holds with 0.75 E* 0.8 = 0.3 E* 2
  BOOST_TEST(law.largest_stretch(0.) == 0);
}

BOOST_AUTO_TEST_CASE(the_stiffness_ratio_follows_from_the_solids) {
  material solid = materials::steel;
  for (const double nu : {0., 0.2, 0.3, 0.49}) {
    solid.poissons_ratio = nu;
    BOOST_TEST(std::abs(stiffness_ratio_of(solid, solid) - 2 * (1 - nu) / (2 - nu)) < 1e-15);
  }
  // against 4 G*/E*, worked out from the shear moduli
  const material& a = materials::steel;
  const material& b = materials::acrylic;
  const auto shear = [](const material& m) { return in_si(m.youngs_modulus) / (2 + 2 * m.poissons_ratio); };
  const double along = 1 / ((2 - a.poissons_ratio) / shear(a) + (2 - b.poissons_ratio) / shear(b));
  const double normal = in_si(between(sphere{a, 1 * millimetres}, flat_wall{b}).reduced_modulus);
  BOOST_TEST(std::abs(stiffness_ratio_of(a, b) - 4 * along / normal) < 1e-15);
  BOOST_TEST(stiffness_ratio_of(a, b) == stiffness_ratio_of(b, a));
  solid.poissons_ratio = 0.5;
  BOOST_CHECK_THROW(stiffness_ratio_of(a, solid), bad_input);
}

BOOST_AUTO_TEST_CASE(wrong_parameters_are_refused) {
  const auto pair = between(sphere{materials::steel, 1 * millimetres}, flat_wall{materials::steel});
  BOOST_CHECK_THROW(compose(pair, hertz{}, mindlin{.friction_coefficient = -0.1, .stiffness_ratio = 0.8}), bad_input);
  BOOST_CHECK_THROW(compose(pair, hertz{}, mindlin{.friction_coefficient = 0.1}), bad_input); // of no stiffness
  BOOST_CHECK_THROW(compose(pair, hertz{}, mindlin{.friction_coefficient = 0.1, .stiffness_ratio = 11}), bad_input);
}
