#include <boost/test/unit_test.hpp>

#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/maugis_dugdale.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/threshold/threshold.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const energy_per_area w = 0.74 * joules_per_square_metre;

/// The range of adhesion at which the transition parameter is lambda, of which it is a multiple.
maugis_dugdale law_of(double lambda) {
  maugis_dugdale law{w, nanometres};
  law.interaction_range *= law.transition_parameter(pair) / lambda;
  return law;
}

} // namespace

// The potential at both ends is a closed form; here the force has to do the same work along the branch.
BOOST_AUTO_TEST_CASE(without_other_losses_the_integration_gives_the_closed_form) {
  for (const double lambda : {0.1, 0.3, 0.6, 0.9, 0.938, 0.94, 1., 1.3, 2., 5., 20., 1e3, 1e5}) {
    const auto law = law_of(lambda);
    const closed_form::maugis_dugdale_contact contact(pair, law);
    const auto model = compose(pair, hertz{}, law, energy_ledger{}, contact_duration{}, extremes{});
    for (const double ratio : {0.9, 1.1, 3., 30.}) {
      const speed v = ratio * contact.sticking_speed();
      if (lambda < 0.5 && ratio < 10)
        continue; // so slow that the energies of contact, 1e4 to 1e10 times that of the impact, leave few digits of e
      for (const double tolerance : {1e-6, 1e-10}) {
        const auto out = collide(model, impact{v}, {.tolerance = tolerance});
        BOOST_TEST_CONTEXT("lambda " << lambda << ", " << ratio << " sticking speeds, tolerance " << tolerance) {
          BOOST_TEST(out.restitution.has_value() == (ratio > 1));
          BOOST_TEST(out.ending_is_certain);
          BOOST_TEST(out.error_estimate <= tolerance);
          if (ratio > 1)
            BOOST_TEST(std::abs(*out.restitution - *contact.restitution(v)) <= out.error_estimate + 1e-13);
          BOOST_TEST(std::abs(out.ledger_residual) < tolerance);
          BOOST_TEST(out.evaluations < 60'000);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(lies_between_dmt_and_jkr) {
  const speed v = 4.0 * metres_per_second;
  const auto depth = [&](const auto& adhesion) {
    return in_si(collide(compose(pair, hertz{}, adhesion, extremes{}), impact{v}, {.tolerance = 1e-9}).max_approach);
  };
  const double from_jkr = depth(jkr{w});
  // Pulled over a range, the bodies meet the faster; JKR's are drawn together by the jump of the edge alone.
  double last = 1;
  for (const double lambda : {10., 100., 1e3, 1e4}) {
    const double off = std::abs(depth(law_of(lambda)) / from_jkr - 1);
    BOOST_TEST(off < last / 3);
    last = off;
  }
  BOOST_TEST(last < 2e-4);
  // DMT starts at the end of the pull: after the fall through its range, at the speed that this gives
  for (const double lambda : {1e-2, 1e-3}) {
    const auto law = law_of(lambda);
    const energy fall =
        pi<double>() * w * pair.reduced_radius * law.interaction_range; // of the disc, c^2 = 2R(z0 + delta)
    const double K = in_si(pair.reduced_mass) * square(in_si(v)) / 2;
    const double faster = in_si(v) * std::sqrt(1 + in_si(fall) / K);
    const double expected =
        in_si(collide(compose(pair, hertz{}, dmt{w}, extremes{}), impact{faster * metres_per_second}).max_approach);
    BOOST_TEST(std::abs(depth(law) / expected - 1) < 0.4 * std::sqrt(lambda));
  }
}

BOOST_AUTO_TEST_CASE(goes_with_damping_and_plastic_loss) {
  const auto law = law_of(0.8);
  const speed v = 10.0 * metres_per_second;
  const auto check = [&](const auto& model) {
    const auto out = collide(model, impact{v}, {.tolerance = 1e-9});
    BOOST_TEST(name_of(out.ending) == "separated");
    BOOST_TEST(out.error_estimate <= 1e-9);
    BOOST_TEST(std::abs(out.ledger_residual) < 1e-9);
    BOOST_TEST(out.crack_loss > 0);
    BOOST_TEST(std::abs(out.crack_loss / in_si(closed_form::maugis_dugdale_contact(pair, law).hysteresis()) *
                            in_si(pair.reduced_mass) * square(in_si(v)) / 2 -
                        1) < 1e-9); // both jumps, nothing else
    return out;
  };
  const auto bare = check(compose(pair, hertz{}, law, energy_ledger{}));
  const auto viscous = check(compose(pair, hertz{}, law, kuwabara_kono{1e-10 * seconds}, energy_ledger{}));
  check(compose(pair, hertz{}, law, tsuji{0.1}, energy_ledger{})); // whose coefficient has a root where they touch
  BOOST_TEST(*viscous.restitution < *bare.restitution);
  const auto yielding = collide(compose(pair, hertz{}, law, thornton_ning{100.0 * megapascals}), impact{v});
  BOOST_TEST(yielding.plastic_loss > 0);
  BOOST_TEST(yielding.restitution.value_or(0) < *bare.restitution);
}

BOOST_AUTO_TEST_CASE(sticking_speed_of_the_study) {
  const auto law = law_of(1);
  const auto found = sticking_speed(compose(pair, hertz{}, law), 1e-3 * metres_per_second, 100.0 * metres_per_second);
  const double expected = in_si(closed_form::maugis_dugdale_contact(pair, law).sticking_speed());
  BOOST_TEST(in_si(found.largest_captured) <= expected * (1 + 1e-12));
  BOOST_TEST(in_si(found.smallest_separated) >= expected * (1 - 1e-12));
}

BOOST_AUTO_TEST_CASE(static_radius_is_that_of_the_branch) {
  const auto law = law_of(1);
  const auto model = compose(pair, hertz{}, law);
  const auto expected = closed_form::maugis_dugdale_contact(pair, law).at(10.0 * nanometres);
  BOOST_TEST(std::abs(in_si(model.static_radius(10.0 * nanometres)) / in_si(expected->contact_radius) - 1) < 1e-13);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const auto says = [](const char* name) {
    return [name](const bad_input& e) { return std::string(e.what()).find(name) == 0; };
  };
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, maugis_dugdale{}), bad_input, says("work_of_adhesion = 0"));
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, maugis_dugdale{w, {}}), bad_input, says("interaction_range = 0 m"));
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, maugis_dugdale{w, 1e9 * metres}), bad_input,
                        says("transition_parameter = "));
}
