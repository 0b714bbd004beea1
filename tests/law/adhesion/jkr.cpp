#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/number/autodiff.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

using D = dual<>;
using S = reduced<D>;

const contact_pair ice =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const double E = in_si(ice.reduced_modulus), R = in_si(ice.reduced_radius), w = 0.74, pi_ = pi<double>();
const basic_pair<S> pair{D(E), D(R), D(in_si(ice.reduced_mass))};
const jkr_law<S> law{D(w)};

D static_approach(const D& a) { return hertz_law<S>::load_free_approach(pair, a) - law.flattening(pair) * sqrt(a); }
D static_force(const D& a) { return hertz_law<S>::force(pair, {static_approach(a), D(0), a, D(0)}); }

bool same(double a, double b, double within = 4e-15) { return std::abs(a / b - 1) < within; } // two dozen roundings
double slope(const D& x) { return static_cast<double>(x.derivative(1)); }

} // namespace

BOOST_AUTO_TEST_CASE(pull_off_is_the_least_force_of_the_static_branch) {
  const double pull_off = 1.5 * pi_ * w * R, a = std::cbrt(9 * pi_ * w * R * R / (8 * E));
  BOOST_TEST(same(value_of(law.pull_off_force(pair)), pull_off));
  const D force = static_force(seeded(a));
  BOOST_TEST(same(value_of(force), -pull_off));
  BOOST_TEST(std::abs(slope(force)) < 1e-14 * pull_off / a); // two terms of 3 F/a that cancel
  for (const double other : {0.9, 0.99, 1.01, 1.1, 2.})
    BOOST_TEST(value_of(static_force(D(other * a))) > -pull_off);
}

BOOST_AUTO_TEST_CASE(fold) {
  const double a = value_of(law.fold_radius(pair));
  BOOST_TEST(same(a, std::cbrt(pi_ * w * R * R / (8 * E))));
  const D approach = static_approach(seeded(a));
  BOOST_TEST(same(value_of(approach), -0.75 * std::pow(pi_, 2. / 3) * std::cbrt(w * w * R / (E * E))));
  BOOST_TEST(std::abs(slope(approach)) < 1e-14 * a / R); // two terms of 2a/R that cancel
  BOOST_TEST(same(value_of(static_force(D(a))), -5. / 9 * 1.5 * pi_ * w * R));
}

BOOST_AUTO_TEST_CASE(exit_energy) {
  const double expected = 0.1 * std::pow(pi_, 5. / 3) * std::cbrt(std::pow(w, 5) * std::pow(R, 4) / (E * E));
  BOOST_TEST(same(value_of(law.exit_energy(pair)), expected, 1e-14)); // five times the rounding of the cube root
}

BOOST_AUTO_TEST_CASE(energy_released_is_the_work_of_adhesion_all_along_the_branch) {
  const double fold = value_of(law.fold_radius(pair));
  for (double a = fold; a < 1000 * fold; a *= 1.3) {
    const D rate = hertz_law<S>::energy_release_rate(pair, {static_approach(D(a)), D(0), D(a), D(0)});
    // the gap a^2/R - delta = c sqrt(a) is a difference: rounding of a^2/R over it, twice
    const double gap = value_of(law.flattening(pair)) * std::sqrt(a), lost = 1 + a * a / R / gap;
    BOOST_TEST_REQUIRE(same(value_of(rate), w, 2e-15 * lost));
  }
}

BOOST_AUTO_TEST_CASE(special_radii) {
  const double touch = value_of(law.touch_radius(pair)), equilibrium = value_of(law.equilibrium_radius(pair));
  BOOST_TEST(same(touch, std::cbrt(2 * pi_ * w * R * R / E)));
  BOOST_TEST(same(equilibrium, std::cbrt(9 * pi_ * w * R * R / (2 * E))));
  BOOST_TEST(std::abs(value_of(static_force(D(equilibrium)))) < 1e-14 * pi_ * w * R); // zero, up to rounding
  BOOST_TEST(in_si(jkr{w * joules_per_square_metre}.surface_energy(1e-7 * metres)) == -pi_ * 1e-7 * 1e-7 * w);
}

BOOST_AUTO_TEST_CASE(contact_radius_inverts_the_stable_branch) {
  const jkr_law<reduced<double>> numbers{w};
  const basic_pair<reduced<double>> p{E, R, 1};
  const double fold = numbers.fold_radius(p), least = value_of(static_approach(D(fold))), c = numbers.flattening(p);
  for (const double part : {-1 + 1e-12, -1 + 1e-6, -0.9, -0.5, -1e-9, 0., 1e-9, 0.3, 1., 10., 1e3, 1e6}) {
    const double approach = -part * least, a = numbers.contact_radius(p, approach);
    BOOST_TEST(a >= fold);
    BOOST_TEST(std::abs(a * a / R - c * std::sqrt(a) - approach) <= 2e-15 * (a * a / R + c * std::sqrt(a)));
  }
  BOOST_TEST(same(numbers.contact_radius(p, 0), numbers.touch_radius(p)));
}

BOOST_AUTO_TEST_CASE(without_work_of_adhesion_it_is_hertz) {
  const jkr none{};
  BOOST_TEST(in_si(none.pull_off_force(ice)) == 0);
  BOOST_TEST(in_si(none.flattening(ice)) == 0);
  for (const length& radius : {none.touch_radius(ice), none.fold_radius(ice), none.equilibrium_radius(ice)})
    BOOST_TEST(in_si(radius) == 0);
  const jkr_law<reduced<double>> numbers{0};
  BOOST_TEST(numbers.exit_energy({E, R, 1}) == 0);
  for (const double approach : {1e-12, 1e-9, 1e-7})
    BOOST_TEST(same(in_si(none.contact_radius(ice, approach * metres)), std::sqrt(R * approach)));
  BOOST_TEST(in_si(none.contact_radius(ice, length{})) == 0); // at touch
}
