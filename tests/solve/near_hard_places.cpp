// Rows of scenes ever nearer to what is hard: thresholds, limits of laws, the ends of double's range. Every outcome is
// to be right to its estimate, or to say that it is not certain, in bounded work.
#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/solve/oblique/oblique.hpp>
#include <ricochet/study/threshold/threshold.hpp>

using namespace support;

namespace {
const ice_case ice;

bool ended(ending e) { return e == ending::separated || e == ending::captured; }

/// Solves, compares with a hundredth of the tolerance, and looks at what must hold.
auto examined(const auto& model, double v, long most_evaluations = 200'000, double tolerance = 1e-8) {
  const impact motion{v * metres_per_second};
  const auto out = integrate(model, motion, {.tolerance = tolerance});
  BOOST_TEST_CONTEXT("v " << v << " m/s, " << name_of(out.ending) << ", e " << out.restitution.value_or(0) << " +- "
                          << out.error_estimate) {
    BOOST_TEST_REQUIRE(ended(out.ending));
    BOOST_TEST(out.evaluations < most_evaluations);
    BOOST_TEST((std::isfinite(out.error_estimate) && std::isfinite(out.ledger_residual)));
    const double e = out.restitution.value_or(0);
    BOOST_TEST((e >= 0 && e <= 1));
    if (out.ending_is_certain && out.error_estimate <= tolerance)
      BOOST_TEST(std::abs(out.ledger_residual) <= tolerance + 1e-10);
    const auto finer = integrate(model, motion, {.tolerance = tolerance / 100});
    if (out.ending_is_certain && ended(finer.ending) && finer.ending_is_certain) {
      BOOST_TEST(name_of(out.ending) == name_of(finer.ending));
      BOOST_TEST(std::abs(e - finer.restitution.value_or(0)) <= out.error_estimate + finer.error_estimate + 1e-12);
    }
  }
  return out;
}

/// On both sides of a speed known to `width`, by 1e-2 to 1e-14 of it.
void look_around(const auto& model, double threshold, double width) {
  for (double distance = 1e-2; distance > 0.9e-14; distance /= 10)
    for (const int side : {-1, 1}) {
      const auto out = examined(model, threshold * (1 + side * distance));
      if (out.ending_is_certain && distance > 2 * width)
        BOOST_TEST((out.ending == ending::separated) == (side > 0), "distance " << side * distance);
      if (distance > 1e-5)
        BOOST_TEST(out.ending_is_certain, "distance " << side * distance);
    }
}

void look_around_sticking(const auto& model) {
  const auto found = sticking_speed(model, 0.01 * metres_per_second, 200.0 * metres_per_second, 1e-11);
  look_around(model, in_si(found.value()), 1e-11);
}

/// Whatever comes of it, numbers or a refusal, is none that is not a number.
void survives(const auto& make_model, double v) {
  try {
    const auto out = collide(make_model(), impact{v * metres_per_second}, {.tolerance = 1e-6});
    BOOST_TEST((!std::isnan(out.restitution.value_or(0)) && !std::isnan(out.error_estimate)));
    BOOST_TEST((ended(out.ending) || !out.reason.empty()));
    if (ended(out.ending))
      BOOST_TEST((out.restitution.value_or(0) >= 0 && out.restitution.value_or(0) <= 1));
  } catch (const bad_input& refused) {
    BOOST_TEST(!std::string(refused.what()).empty());
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(sticking_thresholds_from_both_sides) {
  const auto undamped = compose(ice.pair, hertz{}, ice.adhesive, energy_ledger{});
  look_around(undamped, in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion)), 1e-14);
  look_around_sticking(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, energy_ledger{}));
  look_around_sticking(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-11 * seconds), energy_ledger{}));
  look_around_sticking(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-13 * seconds), energy_ledger{}));
  look_around_sticking(
      compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-11 * seconds), ice.viscous, energy_ledger{}));
  look_around_sticking(compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous, energy_ledger{}));
}

BOOST_AUTO_TEST_CASE(overdamped_contacts) {
  for (double time = 1e-9; time < 2e-4; time *= 3) {
    const kuwabara_kono viscous{time * seconds};
    if (time < 1.5e-7) { // ten contact times; beyond, it creeps apart in millions of evaluations
      examined(compose(ice.pair, hertz{}, viscous, energy_ledger{}), 5);
      examined(compose(ice.pair, hertz{}, viscous, end_at_zero_overlap{}, energy_ledger{}), 5, 500'000);
    }
    examined(compose(ice.pair, hertz{}, ice.adhesive, viscous, energy_ledger{}), 5);
    examined(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-11 * seconds), viscous, energy_ledger{}), 5);
  }
  const double critical = std::sqrt(5.); // of tsuji, from where nothing ends at zero overlap
  for (double distance = 1; distance > 1e-14; distance /= 10)
    for (const int side : {-1, 1})
      BOOST_TEST_CONTEXT("tsuji, from critical " << side * distance) {
        const tsuji damped{critical * (1 + side * distance * 0.9)};
        examined(compose(ice.pair, hertz{}, damped, energy_ledger{}), 5);
        if (side > 0 || distance > 5e-3) // nearer, it takes the longer to leave the less is left of its speed
          examined(compose(ice.pair, hertz{}, damped, end_at_zero_overlap{}, energy_ledger{}), 5, 1'000'000);
        examined(compose(ice.pair, hertz{}, ice.adhesive, damped, energy_ledger{}), 5);
      }
}

BOOST_AUTO_TEST_CASE(time_does_not_run_backwards_where_bodies_creep) {
  // Far beyond critical damping, where errors below the tolerance decide when the contact lets go.
  const material soft{.youngs_modulus = 135318.54830914934 * pascals,
                      .poissons_ratio = 0.40632175347503896,
                      .mass_density = 1.2519284912811957 * kilograms_per_cubic_metre};
  const material hard{.youngs_modulus = 9930126090.5824299 * pascals,
                      .poissons_ratio = 0.15566796803493951,
                      .mass_density = 1412.2924261684664 * kilograms_per_cubic_metre};
  const auto pair =
      between(sphere{soft, 2.1499251803264211e-07 * metres}, sphere{hard, 0.00035162509627958125 * metres});
  const auto model =
      compose(pair, hertz{}, kuwabara_kono{0.71478179715529622 * seconds}, energy_ledger{}, contact_duration{});
  for (const double tolerance : {4.8571646669597094e-08, 1e-6, 1e-10}) {
    const auto out = integrate(model, impact{0.0034533581668875317 * metres_per_second}, {.tolerance = tolerance},
                               stepper::bulirsch_stoer{});
    BOOST_TEST(name_of(out.ending) == name_of(ending::separated));
    BOOST_TEST(in_si(out.contact_duration) > 0);
  }
}

BOOST_AUTO_TEST_CASE(edges_at_the_limits_of_their_law) {
  // Fast ones have G = w, slow ones close at G = k w and open at w/k; between, the edge meets one limit or both.
  for (const double k : {1e-4, 0.02, 0.5, 0.98})
    for (double time = 1e-16; time < 2; time *= 100)
      for (const double v : {2., 12., 200.})
        BOOST_TEST_CONTEXT("k " << k << ", T_vis " << time << " s")
  examined(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(time * seconds, k), kuwabara_kono{2e-10 * seconds},
                   energy_ledger{}),
           v, 5'000'000, 1e-6);
}

// Tsuji's damping goes as the root of the contact radius, which is zero until the surfaces touch, amid the motion.
BOOST_AUTO_TEST_CASE(damping_that_sets_in_with_a_root_where_surfaces_touch) {
  const material soft{1.0 * gigapascals, 0, 1300.0 * kilograms_per_cubic_metre};
  for (const double alpha : {0.03, 0.17, 0.44}) {
    const auto model =
        compose(between(sphere{soft, 0.23 * micrometres}, flat_wall{soft}), hertz{},
                maugis_dugdale{1.7e-3 * joules_per_square_metre, 0.43 * nanometres}, tsuji{alpha}, energy_ledger{});
    for (double v = 0.5; v < 50; v *= 1.003)
      examined(model, v, 5000, 4e-9);
  }
}

BOOST_AUTO_TEST_CASE(grazing_impacts) {
  const coulomb friction{0.3};
  const auto look = [](const auto& model) {
    for (const double degrees_left : {0.1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      const double left = degrees_left * pi<double>() / 180, v = 10;
      const auto out =
          collide(model, oblique_impact{v * metres_per_second, pi<double>() / 2 - left, {}, {}}, {.tolerance = 1e-8});
      BOOST_TEST_CONTEXT("89.9.. degrees less " << degrees_left) {
        BOOST_TEST_REQUIRE(ended(out.normal.ending));
        BOOST_TEST((std::isfinite(in_si(out.tangential_speed)) && std::isfinite(in_si(out.spin_1))));
        // Friction takes no more than the normal impulse allows: nearly nothing is lost along the surface.
        BOOST_TEST(in_si(out.tangential_speed) <= v);
        if (out.normal.ending == ending::separated)
          BOOST_TEST(in_si(out.tangential_speed) >= v * (1 - 2 * left));
        BOOST_TEST((out.friction_loss >= 0 && std::abs(out.normal.ledger_residual) <= 1e-8 + 1e-10));
      }
    }
  };
  look(compose(ice.pair, hertz{}, friction, energy_ledger{}));
  look(compose(ice.pair, hertz{}, ice.viscous, friction, energy_ledger{}));
  look(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, friction, energy_ledger{}));
  look(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-11 * seconds), ice.viscous, friction, energy_ledger{}));
}

BOOST_AUTO_TEST_CASE(denormal_and_extreme_numbers_are_solved_or_refused) {
  for (const double x : {5e-324, 1e-310, 2.3e-308, 1e-300, 1e300, 1.7e308}) {
    const auto with = [&](double modulus, double density, double radius, double w, double T, double A) {
      return [=] {
        const material solid{modulus * pascals, 0.25, density * kilograms_per_cubic_metre};
        return compose(
            between(sphere{solid, radius * metres}, flat_wall{solid}), hertz{}, jkr{w * joules_per_square_metre},
            greenwood{.relaxation_time = T * seconds, .modulus_ratio = 0.02, .interaction_range = 3e-10 * metres},
            kuwabara_kono{A * seconds}, energy_ledger{});
      };
    };
    BOOST_TEST_CONTEXT("number " << x) {
      survives(with(7e9, 1000, 2e-6, 0.74, 1e-11, 1e-11), x);
      survives(with(x, 1000, 2e-6, 0.74, 1e-11, 1e-11), 8);
      survives(with(7e9, x, 2e-6, 0.74, 1e-11, 1e-11), 8);
      survives(with(7e9, 1000, x, 0.74, 1e-11, 1e-11), 8);
      survives(with(7e9, 1000, 2e-6, x, 1e-11, 1e-11), 8);
      survives(with(7e9, 1000, 2e-6, 0.74, x, 1e-11), 8);
      survives(with(7e9, 1000, 2e-6, 0.74, 1e-11, x), 8);
    }
  }
}

BOOST_AUTO_TEST_CASE(onset_of_yield) {
  const modulus strength = 200.0 * megapascals;
  const double onset = in_si(closed_form::yield_speed(ice.pair, strength));
  for (double distance = 1e-1; distance > 0.9e-14; distance /= 10)
    for (const int side : {-1, 1}) {
      const double v = onset * (1 + side * distance);
      const auto within =
          examined(compose(ice.pair, hertz{}, thornton_ning_contact{.yield_strength = strength}, energy_ledger{}), v);
      BOOST_TEST((within.plastic_loss >= 0 && within.plastic_loss <= 1 - square(*within.restitution) + 2e-8));
      const auto added =
          collide(compose(ice.pair, hertz{}, thornton_ning{.yield_strength = strength}), impact{v * metres_per_second});
      BOOST_TEST(std::abs(*added.restitution - *within.restitution) <=
                 added.error_estimate + within.error_estimate + 1e-12);
    }
}
