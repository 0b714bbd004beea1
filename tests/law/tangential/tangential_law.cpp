#include <boost/test/unit_test.hpp>

#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/tangential/coulomb.hpp>

using namespace ricochet;

static_assert(tangential_law<coulomb> && !tangential_law<hertz>);

BOOST_AUTO_TEST_CASE(sliding_only_dissipates) {
  for (const double friction : {0., 0.3, 5.})
    for (const double elastic_force : {-2., 0., 1e-9, 2.})
      BOOST_TEST(coulomb_law<reduced<double>>{friction}.sliding_force(elastic_force) >= 0);
}
