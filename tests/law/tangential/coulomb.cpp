#include <boost/test/unit_test.hpp>

#include <ricochet/law/tangential/coulomb.hpp>

using namespace ricochet;

BOOST_AUTO_TEST_CASE(friction_is_in_proportion_to_the_force_that_presses) {
  const coulomb_law<reduced<double>> law{0.3};
  BOOST_TEST(law.sliding_force(2.) == 0.6);
  BOOST_TEST(law.sliding_force(0.) == 0);
  BOOST_TEST(law.sliding_force(-2.) == 0); // a force that pulls does not press
}
