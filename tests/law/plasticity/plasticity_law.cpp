#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>

using namespace support;

static_assert(plasticity_law<thornton_ning> && !plasticity_law<hertz>);

BOOST_AUTO_TEST_CASE(the_loss_is_a_part_and_none_at_small_speeds) {
  const ice_case ice;
  const thornton_ning law{.yield_strength = 200.0 * megapascals};
  double last = 0;
  for (double v = 1e-3; v < 1e4; v *= 2) {
    const double loss = law.loss(ice.pair, v * metres_per_second);
    BOOST_TEST(loss >= last);
    BOOST_TEST(loss < 1);
    BOOST_TEST((v > 1 || loss == 0));
    last = loss;
  }
  BOOST_TEST(last > 0.5);
}
