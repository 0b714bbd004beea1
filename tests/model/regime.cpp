#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/model/regime.hpp>

using namespace support;

namespace {
template <class Outcome>
concept has_warnings = requires(Outcome out) {
  out.warnings;
};

const ice_case ice;
const speed eight = 8.0 * metres_per_second;

bool says(const regime_report& report, const std::string& words) {
  for (const std::string& sentence : report.warnings())
    if (sentence.find(words) != sentence.npos)
      return true;
  return false;
}
} // namespace

BOOST_AUTO_TEST_CASE(the_ice_case_is_where_its_laws_hold) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous);
  const auto r = regime_of(model, eight, {}, 0.25);
  BOOST_TEST(std::abs(*r.tabor_number - 11.33) < 0.005); // published.csv
  BOOST_TEST(std::abs(*r.speed_over_capture - 8 / 1.459347007) < 1e-8);
  // (A.2), (A.4): viscous losses matter in this collision
  const double time = in_si(closed_form::contact_time(ice.pair, eight));
  BOOST_TEST(std::abs(*r.bulk_loss_scale - 1e-11 / (1e-2 * 0.0625 * time)) < 1e-12 * *r.bulk_loss_scale);
  BOOST_TEST(*r.edge_loss_scale > 1);
  BOOST_TEST(*r.cohesive_zone < 0.1);
  BOOST_TEST(std::abs(r.speed_over_sound - 8 / std::sqrt(in_si(ice.pair.reduced_modulus) / 1000)) < 1e-12);
  BOOST_TEST(!r.speed_over_yield);
  BOOST_TEST(r.warnings().empty());
}

BOOST_AUTO_TEST_CASE(each_law_out_of_its_range_is_named) {
  const auto hard = compose(ice.pair, hertz{}, jkr{1e-3 * joules_per_square_metre});
  BOOST_TEST(says(regime_of(hard, eight, 0.3 * nanometres), "dmt describes adhesion and jkr does not") ==
             (*regime_of(hard, eight, 0.3 * nanometres).tabor_number < 0.1));
  BOOST_TEST(says(regime_of(hard, eight, 3.0 * nanometres), "Tabor"));
  BOOST_TEST(!regime_of(hard, eight).tabor_number);
  const auto soft = compose(ice.pair, hertz{}, dmt{0.74 * joules_per_square_metre});
  BOOST_TEST(says(regime_of(soft, eight, 0.3 * nanometres), "jkr describes adhesion and dmt does not"));
  BOOST_TEST(says(regime_of(hard, 1000.0 * metres_per_second), "sound"));
  BOOST_TEST(says(regime_of(hard, 1000.0 * metres_per_second), "half-spaces"));
  const auto lead = compose(ice.pair, hertz{}, thornton_ning{1.0 * megapascals});
  BOOST_TEST(says(regime_of(lead, eight), "yield speed"));
  auto wide = ice.fitted();
  wide.interaction_range = 30.0 * nanometres;
  BOOST_TEST(says(regime_of(compose(ice.pair, hertz{}, ice.adhesive, wide), eight), "cohesive zone"));
}

BOOST_AUTO_TEST_CASE(the_outcome_carries_them_where_asked_for) {
  const impact fast{1000.0 * metres_per_second};
  const auto same = [&](const auto& model) {
    BOOST_TEST(!collide(model, fast).warnings.empty());
    BOOST_TEST(collide(model, fast).warnings == regime_of(model, fast.speed).warnings());
    BOOST_TEST(integrate(model, fast).warnings == regime_of(model, fast.speed).warnings());
    BOOST_TEST(collide(model, impact{in_si(fast.speed) * millimetres_per_second}).warnings ==
               regime_of(model, metres_per_second).warnings());
  };
  same(compose(ice.pair, hertz{}, regime_warnings{})); // of a closed form
  same(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, regime_warnings{}));
  auto quick = ice.fitted();
  quick.relaxation_time = {};
  same(compose(ice.pair, hertz{}, ice.adhesive, quick, regime_warnings{})); // a static edge after all
  same(compose(ice.pair, hertz{}, thornton_ning{1.0 * megapascals}, regime_warnings{}));
  static_assert(has_warnings<decltype(collide(compose(ice.pair, hertz{}, regime_warnings{}), fast))>);
  static_assert(!has_warnings<decltype(collide(compose(ice.pair, hertz{}), fast))>);
}

BOOST_AUTO_TEST_CASE(a_pair_without_bodies_is_refused) {
  const contact_pair bare{ice.pair.reduced_modulus, ice.pair.reduced_radius, ice.pair.reduced_mass};
  BOOST_CHECK_THROW(regime_of(compose(bare, hertz{}), eight), bad_input);
  BOOST_CHECK_THROW(regime_of(compose(ice.pair, hertz{}), -eight), bad_input);
}
