#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/adhesion_law.hpp>
#include <ricochet/law/adhesion/attraction_law.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;

static_assert(cohesive_law<maugis_dugdale> && !cohesive_law<jkr> && !cohesive_law<dmt> && !cohesive_law<hertz>);
static_assert(!attraction_law<maugis_dugdale> && !adhesion_law<maugis_dugdale>);
static_assert(std::is_empty_v<branch_of<jkr, double>>);

BOOST_AUTO_TEST_CASE(axioms) {
  using S = reduced<double>;
  const basic_pair<S> pair{2, 3, 1};
  for (const double z0 : {0.003, 0.3, 3., 30.}) {
    const maugis_dugdale_law<S> law{0.7, z0};
    const auto branch = law.branch(pair, 0.5);
    const double fold = branch.fold();
    const auto configure = [&](double y) {
      const auto p = branch.at(y, y >= 0);
      return cohesive_configuration<S>{{p.approach, 0, p.radius, 0}, p.cohesive_radius, p.angle};
    };
    const auto potential = [&](const cohesive_configuration<S>& c) {
      return hertz_law<S>::stored_energy(pair, c) + law.potential_energy(pair, c);
    };
    BOOST_TEST(branch.first() >= fold);
    const auto first = branch.at(branch.first(), branch.first() >= 0); // of a difference of larger numbers
    BOOST_TEST(std::abs(first.approach + z0) < 1e-14 * (z0 + first.radius * first.radius));
    cohesive_configuration<S> last = configure(fold);
    for (double y = fold + 1e-3; y < 3; y = y < 0 && y + 0.01 > 0 ? 1e-6 : y + 0.01) {
      const auto here = configure(y);
      BOOST_TEST_REQUIRE(law.attraction(pair, here) > 0);
      BOOST_TEST_REQUIRE(here.approach > last.approach);
      BOOST_TEST_REQUIRE(here.radius >= last.radius);
      BOOST_TEST_REQUIRE(here.cohesive_radius > last.cohesive_radius);
      last = here;
      const double h = 1e-5 * (1 + std::abs(y));
      if ((y - h) * (y + h) <= 0 || y - fold < 3e3 * h) // a quotient needs both sides, and a slope there
        continue;
      const double force = hertz_law<S>::force(pair, here) - law.attraction(pair, here);
      const auto before = configure(y - h), after = configure(y + h);
      const double rise = after.approach - before.approach, slope = branch.at(y, y >= 0).slope;
      // second order in h, and the differences' round-off
      BOOST_TEST_REQUIRE(std::abs(rise / (2 * h) - slope) < 1e-7 * (std::abs(slope) + here.cohesive_radius));
      const double round_off = 1e-14 * (hertz_law<S>::stored_energy(pair, here) - law.potential_energy(pair, here));
      BOOST_TEST_REQUIRE(std::abs(potential(after) - potential(before) - force * rise) <
                         1e-5 * std::max(std::abs(force), law.attraction(pair, here)) * rise + round_off);
    }
  }
}
