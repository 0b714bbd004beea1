#include <boost/test/unit_test.hpp>

#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

using namespace ricochet;

static_assert(sliding_law<coulomb> && !stick_slip_law<coulomb> && tangential_law<coulomb>);
static_assert(stick_slip_law<mindlin> && !sliding_law<mindlin> && tangential_law<mindlin>);
static_assert(peeling_law<coulomb_with_peeling> && sliding_law<coulomb_with_peeling>);
static_assert(!peeling_law<coulomb> && !peeling_law<mindlin> && !peeling_law<hertz>);
static_assert(!tangential_law<hertz> && !tangential_law<absent<role::tangential>>);

BOOST_AUTO_TEST_CASE(sliding_only_dissipates) {
  for (const double friction : {0., 0.3, 5.})
    for (const double elastic_force : {-2., 0., 1e-9, 2.})
      BOOST_TEST(coulomb_law<reduced<double>>{friction}.sliding_force(elastic_force) >= 0);
}

BOOST_AUTO_TEST_CASE(springs_slip_in_proportion_to_their_press) {
  for (const double friction : {0., 0.3, 5.})
    for (const double stiffness_ratio : {0.5, 1.2}) {
      const mindlin_law<reduced<double>> law{friction, stiffness_ratio};
      BOOST_TEST(law.stiffness({.reduced_modulus = 2, .reduced_radius = 1, .reduced_mass = 1}) > 0);
      for (const double press : {0., 1e-9, 2.}) {
        BOOST_TEST(law.largest_stretch(press) >= 0);
        BOOST_TEST(std::abs(law.largest_stretch(3 * press) - 3 * law.largest_stretch(press)) <= 1e-14 * press);
      }
    }
}

BOOST_AUTO_TEST_CASE(what_is_peeled_opposes_the_turning_in_proportion_to_its_speed) {
  const basic_pair<reduced<double>> pair{.reduced_modulus = 2, .reduced_radius = 3, .reduced_mass = 1};
  for (const double moment : {0., 0.5})
    for (const double rebound_coefficient : {0., 2.})
      for (const double surface_speed : {-2., 0., 1e-9, 5.}) {
        const coulomb_with_peeling_law<reduced<double>> law{0.3, moment};
        const double resistance = law.edge_resistance(pair, rebound_coefficient, surface_speed);
        BOOST_TEST(resistance * surface_speed >= 0);
        BOOST_TEST(std::abs(law.edge_resistance(pair, rebound_coefficient, 3 * surface_speed) - 3 * resistance) <=
                   1e-15 * std::abs(resistance));
      }
}
