#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/adhesion_law.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;

static_assert(attraction_law<line_force> && attraction_law<dmt>);
static_assert(rebound_opposing_law<line_force> && !rebound_opposing_law<dmt>);
static_assert(!attraction_law<jkr> && !attraction_law<hertz> && !adhesion_law<line_force> && !adhesion_law<dmt>);

BOOST_AUTO_TEST_CASE(attractions_are_no_work_of_adhesion_at_an_edge) {
  using S = reduced<double>;
  const basic_pair<S> pair{2, 3, 1};
  const configuration<S> touch{0, 1, 0, 0}, deep{0.1, -1, std::sqrt(0.3), 0};
  const auto axioms = [&](const auto& law) {
    BOOST_TEST(law.potential_energy(pair, touch) == 0);
    BOOST_TEST(law.potential_energy(pair, deep) < 0);
    BOOST_TEST(law.attraction(pair, deep) > 0);
    if constexpr (requires { law.rebound_damping(pair, deep); }) {
      BOOST_TEST(law.rebound_damping(pair, touch) == 0);
      BOOST_TEST(law.rebound_damping(pair, deep) > 0);
    }
    BOOST_TEST(law.equivalent_work_of_adhesion(pair) > 0);
  };
  axioms(line_force_law<S>{0.7, 0.2});
  axioms(dmt_law<S>{0.7});
}
