#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

using namespace support;

namespace {
const ice_case ice;
} // namespace

BOOST_AUTO_TEST_CASE(automatic_changes_over_where_the_edge_is_stiff_and_saves_work) {
  auto edge = ice.exact(1e-15 * seconds);
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, edge, ice.viscous);
  const impact fast{8.0 * metres_per_second};
  const auto both = integrate(model, fast, {.tolerance = 1e-6});
  const auto explicit_only = collide(model, fast, {.tolerance = 1e-6}, stepper::tsitouras_papakostas75{});
  BOOST_TEST(std::abs(*both.restitution - *explicit_only.restitution) < 2e-6);
  BOOST_TEST(both.evaluations < explicit_only.evaluations / 2);
}

BOOST_AUTO_TEST_CASE(where_nothing_is_stiff_automatic_is_explicit) {
  for (const auto& T : {0.0 * seconds, ice.relaxation_time}) {
    const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T), ice.viscous);
    const impact fast{8.0 * metres_per_second};
    BOOST_TEST(*integrate(model, fast, {.tolerance = 1e-8}).restitution ==
               *collide(model, fast, {.tolerance = 1e-8}, stepper::tsitouras_papakostas75{}).restitution);
  }
}
