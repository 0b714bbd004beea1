#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/maugis_dugdale.hpp>
#include <ricochet/closed_form/regime.hpp>
#include <ricochet/law/adhesion/dmt.hpp>

using namespace ricochet;
using namespace ricochet::units;
using closed_form::maugis_dugdale_contact;

namespace {

const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const energy_per_area w = 0.74 * joules_per_square_metre;
const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), K = 4 * E / 3, W = 0.74;
const double load_unit = std::numbers::pi * W * R, radius_unit = std::cbrt(std::numbers::pi * W * R * R / K),
             depth_unit = radius_unit * radius_unit / R;

/// The range for this lambda, from its definition.
length range_of(double lambda) { return 2 * W / lambda * std::cbrt(R / (std::numbers::pi * W * K * K)) * metres; }
maugis_dugdale_contact contact(double lambda) { return {pair, {w, range_of(lambda)}}; }

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

// Maugis 1992 as printed: m of the reduced radius a by bisection, then load and approach.
struct printed {
  double a, load, approach, c;
};
printed as_printed(double lambda, double a) {
  const auto condition = [&](double m) {
    const double s = std::sqrt(m * m - 1), t = std::atan(s);
    return lambda * a * a / 2 * (s + (m * m - 2) * t) + 4 * lambda * lambda * a / 3 * (s * t - m + 1) - 1;
  };
  double low = 1, high = 2;
  while (condition(high) < 0)
    high *= 2;
  for (int i = 0; i < 200; ++i)
    (condition((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  const double s = std::sqrt(low * low - 1), t = std::atan(s);
  return {a, a * a * a - lambda * a * a * (s + low * low * t), a * a - 4 * lambda * a * s / 3, low * a};
}

const double all[] = {1e-3, 0.01, 0.1, 0.3, 0.6, 0.9, 0.93, 0.938, 0.9385, 0.94, 1, 1.3, 2, 5, 20, 100, 1000};

} // namespace

BOOST_AUTO_TEST_CASE(the_transition_parameter) {
  for (const double lambda : all) {
    const auto law = contact(lambda);
    BOOST_TEST(deviation(maugis_dugdale{w, range_of(lambda)}.transition_parameter(pair), lambda) <
               1e-14); // a dozen roundings and cube roots
    const double tabor = closed_form::tabor_number(pair, w, range_of(lambda));
    BOOST_TEST(deviation(lambda, 2 * std::cbrt(9 / (16 * std::numbers::pi)) * tabor) < 1e-14);
    BOOST_TEST(deviation(in_si(law.approach_of_jump_in()), -in_si(range_of(lambda))) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(equilibria_in_contact_as_printed) {
  for (const double lambda : {0.01, 0.1, 0.5, 0.9, 1., 2., 5.}) {
    const auto law = contact(lambda);
    for (const double a : {0.3, 0.8, 1.3, 2., 6.}) {
      const printed expected = as_printed(lambda, a);
      if (a * radius_unit < 1.001 * in_si(law.jump_out().contact_radius))
        continue; // not stable
      const auto found = law.at(expected.approach * depth_unit * metres);
      BOOST_TEST_REQUIRE(found.has_value());
      // The condition as printed cancels where m is near one, and approach is flat in a near the fold.
      BOOST_TEST(deviation(in_si(found->contact_radius), a * radius_unit) < 1e-9);
      BOOST_TEST(std::abs(in_si(found->load) / load_unit - expected.load) < 1e-9 * (1 + a * a * a));
      BOOST_TEST(deviation(in_si(found->cohesive_radius), expected.c * radius_unit) < 1e-9);
    }
  }
}

// Half-spaces pulled by sigma_0 within r < c rise by 4 sigma_0 c/(pi E*) at its edge, by 2 sigma_0 c/E* at its centre.
BOOST_AUTO_TEST_CASE(before_contact_the_gap_is_the_range_at_the_edge) {
  for (const double lambda : {0.01, 0.2, 0.6, 0.9}) {
    const auto law = contact(lambda);
    const double z0 = in_si(range_of(lambda)), stress = W / z0, first = in_si(law.jump_out().approach);
    int seen = 0;
    for (double approach = first * (1 - 1e-12); approach < 0; approach += 0.01 * std::abs(first)) {
      const auto found = law.at(approach * metres);
      BOOST_TEST_REQUIRE(found.has_value());
      if (in_si(found->contact_radius) > 0)
        break;
      ++seen;
      const double c = in_si(found->cohesive_radius), edge = 4 * stress * c / (std::numbers::pi * E);
      BOOST_TEST(std::abs(c * c / (2 * R) - approach - edge - z0) < 1e-13 * (z0 + c * c / R));
      BOOST_TEST(-approach - 2 * stress * c / E > -1e-13 * z0); // not yet in contact
      BOOST_TEST(deviation(in_si(found->load), -std::numbers::pi * c * c * stress) < 1e-13);
    }
    BOOST_TEST(seen > 0);
  }
}

BOOST_AUTO_TEST_CASE(the_path_is_continuous_and_stable) {
  for (const double lambda : all) {
    const auto law = contact(lambda);
    const auto out = law.jump_out();
    BOOST_TEST(!law.at(out.approach * 1.0001).has_value());
    BOOST_TEST((out.approach <= law.approach_of_jump_in()));
    double last = 0, last_radius = 0;
    // s^2 because a fold is a root; both radii only grow with the approach
    for (double s = 1e-4; s < 3; s += 0.01) {
      const auto here = law.at(out.approach + s * s * depth_unit * metres);
      BOOST_TEST_REQUIRE(here.has_value());
      BOOST_TEST_REQUIRE(in_si(here->cohesive_radius) > last);
      BOOST_TEST_REQUIRE(in_si(here->contact_radius) >= last_radius);
      last = in_si(here->cohesive_radius);
      last_radius = in_si(here->contact_radius);
    }
  }
}

BOOST_AUTO_TEST_CASE(pull_off_force_between_both_limits) {
  double last = 2;
  for (const double lambda : all) {
    const double found = in_si(contact(lambda).pull_off_force()) / load_unit;
    BOOST_TEST((found < last && found > 1.5));
    last = found;
    // Carpick, Ogletree & Salmeron 1999, fitted to Maugis' solution to 1 % or 2 %
    const double power = 4.04 * std::pow(lambda, 1.4), fitted = 1.75 - 0.25 * (power - 1) / (power + 1);
    BOOST_TEST(deviation(found, fitted) < 0.02);
  }
  BOOST_TEST(deviation(in_si(contact(1e-3).pull_off_force()), in_si(dmt{w}.pull_off_force(pair))) < 1e-3);
  BOOST_TEST(deviation(in_si(contact(1e3).pull_off_force()), in_si(jkr{w}.pull_off_force(pair))) < 1e-5);
}

BOOST_AUTO_TEST_CASE(the_loss_is_the_area_between_both_paths) {
  for (const double lambda : all) {
    const auto law = contact(lambda);
    const double from = in_si(law.jump_out().approach), to = in_si(law.approach_of_jump_in());
    // The substitution takes the root from the fold; where contact begins in between, the slope of the load has a kink.
    const auto pull = [&](double s) {
      const auto here = law.at((from + s * s) * metres);
      return here ? -2 * s * in_si(here->load) : 0;
    };
    const double area =
        boost::math::quadrature::gauss_kronrod<double, 61>::integrate(pull, 0., std::sqrt(to - from), 6, 1e-10);
    // 1e-8: of the kink; at small lambda the loop is a millionth of the approaches whose difference it is made of
    BOOST_TEST(deviation(in_si(law.hysteresis()), area) < 1e-8 + 1e-15 / std::pow(lambda, 3));
  }
}

BOOST_AUTO_TEST_CASE(tends_to_jkr) {
  const double jkr_loss = in_si(pair.reduced_mass) * std::pow(in_si(closed_form::sticking_speed(pair, w)), 2) / 2;
  double last = 1;
  for (const double lambda : {10., 100., 1e3, 1e4}) {
    const auto law = contact(lambda);
    const double off = 1 - in_si(law.hysteresis()) / jkr_loss;
    BOOST_TEST((off > 0 && off < last * 0.2)); // as 1/lambda: the bodies jump together at -z0 already
    last = off;
    const auto out = law.jump_out();
    BOOST_TEST(deviation(in_si(out.contact_radius), in_si(jkr{w}.fold_radius(pair))) < 1 / lambda);
    const double fold = -0.75 * std::pow(std::numbers::pi, 2. / 3) * std::cbrt(W * W * R / (E * E));
    BOOST_TEST(deviation(in_si(out.approach), fold) < 1 / lambda);
    BOOST_TEST(deviation(in_si(out.load), -5. / 6 * load_unit) < 1 / lambda);
  }
  BOOST_TEST(last < 1e-4);
  const speed eight = 8.0 * metres_per_second;
  BOOST_TEST(std::abs(*contact(1e4).restitution(eight) - *closed_form::restitution(pair, w, eight)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(tends_to_dmt) {
  const auto law = contact(1e-3);
  const double jkr_speed = in_si(closed_form::sticking_speed(pair, w));
  BOOST_TEST(in_si(law.sticking_speed()) < 1e-3 * jkr_speed);
  for (const double a : {0.5, 1., 3.}) { // F = 4E*a^3/3R - 2 pi w R at a^2 = R delta
    double last_radius = 1, last_load = 10;
    for (const double lambda : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const auto here = contact(lambda).at(a * a * depth_unit * metres);
      const double r = in_si(here->contact_radius) / radius_unit;
      const double radius_off = std::abs(r / a - 1),
                   load_off = std::abs(in_si(here->load) / load_unit - (r * r * r - 2));
      BOOST_TEST(radius_off < 0.4 * last_radius); // as sqrt(lambda)
      BOOST_TEST(load_off < 0.4 * last_load);
      last_radius = radius_off;
      last_load = load_off;
    }
  }
}

BOOST_AUTO_TEST_CASE(the_loss_grows_with_lambda) {
  double last = 0;
  for (const double lambda : all) {
    const double now = in_si(contact(lambda).hysteresis());
    BOOST_TEST(now > last);
    last = now;
  }
  const auto law = contact(1);
  BOOST_TEST(!law.restitution(0.999 * law.sticking_speed()).has_value());
  BOOST_TEST(law.restitution(1.001 * law.sticking_speed()).has_value());
  // Before contact the loop is int (pi lambda/2) c^2 dc(c - c_f) from c_f to 2c_f: (17/24) pi lambda c_f^4.
  const double c = 8 * 0.01 / (3 * std::numbers::pi);
  BOOST_TEST(deviation(in_si(contact(0.01).hysteresis()),
                       17. / 24 * std::numbers::pi * 0.01 * std::pow(c, 4) * load_unit * depth_unit) < 1e-12);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const auto says = [](const char* name) {
    return [name](const bad_input& e) { return std::string(e.what()).find(name) == 0; };
  };
  BOOST_CHECK_EXCEPTION(maugis_dugdale_contact(pair, {{}, nanometres}), bad_input, says("work_of_adhesion = 0"));
  BOOST_CHECK_EXCEPTION(maugis_dugdale_contact(pair, {w, {}}), bad_input, says("interaction_range = 0 m"));
  BOOST_CHECK_EXCEPTION(maugis_dugdale_contact(pair, {w, 1e9 * metres}), bad_input, says("transition_parameter = "));
  BOOST_CHECK_EXCEPTION(contact(1).restitution({}), bad_input, says("speed = 0 m/s"));
}
