#include <boost/test/unit_test.hpp>

#include <ricochet/law/tangential/coulomb_with_peeling.hpp>

using namespace ricochet;

namespace {
const coulomb_with_peeling_law<reduced<double>> law{.friction_coefficient = 0.3, .peeling_moment = 6};
const basic_pair<reduced<double>> pair{.reduced_modulus = 1, .reduced_radius = 2, .reduced_mass = 1};
} // namespace

BOOST_AUTO_TEST_CASE(its_friction_is_coulombs) {
  for (const double elastic_force : {-2., 0., 2.})
    BOOST_TEST(law.sliding_force(elastic_force) == coulomb_law<reduced<double>>{0.3}.sliding_force(elastic_force));
}

BOOST_AUTO_TEST_CASE(the_edge_resists_the_turning) {
  // g = lambda c_A a omega, of which a is the arm: 6 * 0.5 * (4/2)
  BOOST_TEST(law.edge_resistance(pair, 0.5, 4.) == 6);
  BOOST_TEST(law.edge_resistance(pair, 0.5, -4.) == -6);
  BOOST_TEST(law.edge_resistance(pair, 0.5, 0.) == 0);
  BOOST_TEST(law.edge_resistance(pair, 0., 4.) == 0);
}
