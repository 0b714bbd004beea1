#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/threshold/threshold.hpp>

using namespace support;

namespace {
const ice_case ice;
const thornton_ning soft{.yield_strength = 50.0 * megapascals};
} // namespace

BOOST_AUTO_TEST_CASE(plastic_flow_alone_gives_its_factor) {
  const auto model = compose(ice.pair, hertz{}, soft);
  const speed yield = closed_form::yield_speed(ice.pair, soft.yield_strength);
  for (const double times : {0.1, 0.999, 1.001, 2., 30.}) {
    const auto out = collide(model, impact{times * yield});
    BOOST_TEST(std::abs(*out.restitution - closed_form::plastic_restitution(yield, times * yield)) < 1e-15);
    BOOST_TEST((out.plastic_loss == 0) == (times < 1));
    BOOST_TEST(out.error_estimate < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(its_loss_is_added_to_the_others) { // [K (30)]
  const auto elastic = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous, energy_ledger{});
  const thornton_ning ductile{.yield_strength = 200.0 * megapascals};
  const auto yielding = compose(ice.pair, ductile, hertz{}, ice.adhesive, ice.fitted(), ice.viscous, energy_ledger{});
  bool captured = false, separated = false;
  for (const double v : {2., 3.6, 5., 8., 12., 20., 40.}) {
    const impact at{v * metres_per_second};
    const auto without = collide(elastic, at);
    const auto with = collide(yielding, at);
    const double left = square(without.restitution.value_or(0)) - ductile.loss(ice.pair, at.speed);
    BOOST_TEST_CONTEXT("v = " << v) {
      BOOST_TEST(with.restitution.has_value() == (left > 0));
      if (with.restitution)
        BOOST_TEST(std::abs(*with.restitution - std::sqrt(left)) < 1e-14);
      BOOST_TEST((with.ending == ending::captured) == (left <= 0));
      BOOST_TEST(std::abs(with.crack_loss + with.bulk_loss + with.plastic_loss + with.remaining_energy - 1) < 1e-6);
      BOOST_TEST(integrate(yielding, at).restitution.value_or(0) == with.restitution.value_or(0));
      captured |= without.restitution && left <= 0;
      separated |= left > 0;
    }
  }
  BOOST_TEST((captured && separated));
}

BOOST_AUTO_TEST_CASE(the_sticking_speed_knows_of_it) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous,
                             thornton_ning{.yield_strength = 200.0 * megapascals});
  const auto found = sticking_speed(model, 1.0 * metres_per_second, 30.0 * metres_per_second, 1e-8);
  const auto elastic = sticking_speed(compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous),
                                      1.0 * metres_per_second, 30.0 * metres_per_second, 1e-8);
  BOOST_TEST(in_si(found.value()) > 1.001 * in_si(elastic.value()));
  BOOST_TEST(in_si(found.smallest_separated) / in_si(found.largest_captured) - 1 < 1.1e-8);
}

BOOST_AUTO_TEST_CASE(wrong_strength_is_refused) {
  BOOST_CHECK_THROW(compose(ice.pair, hertz{}, thornton_ning{}), bad_input);
  static_assert(composable<hertz, jkr, thornton_ning> && !composable<hertz, thornton_ning, thornton_ning>);
}
