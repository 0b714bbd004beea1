#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius);

configuration<dimensional> at(double approach, double radius) {
  return {approach * metres, 0.0 * metres_per_second, radius * metres, {}};
}
bool same(double a, double b) { return std::abs(a / b - 1) < 2e-15; } // ten roundings

} // namespace

BOOST_AUTO_TEST_CASE(force_and_energy_at_the_hertzian_radius) {
  for (const double approach : {1e-12, 1e-9, 3.7e-8}) {
    const double a = std::sqrt(R * approach);
    const double force = 4 * E * std::sqrt(R) * std::pow(approach, 1.5) / 3; // [K (5)]
    BOOST_TEST(same(in_si(hertz::force(pair, at(approach, a))), force));
    BOOST_TEST(same(in_si(hertz::stored_energy(pair, at(approach, a))), 0.4 * force * approach));
    BOOST_TEST(same(in_si(hertz::load_free_approach(pair, a * metres)), approach));
    BOOST_TEST(same(hertz::load_free_slope(pair, a * metres), 2 * a / R));
  }
}

BOOST_AUTO_TEST_CASE(other_radii) {
  const double a = 1.2e-7, approach = 2e-8;
  BOOST_TEST(same(in_si(hertz::force(pair, at(approach, a))), 2 * E / (3 * R) * (3 * a * approach * R - a * a * a)));
  BOOST_TEST(same(in_si(hertz::stored_energy(pair, at(approach, a))),
                  E * (approach * approach * a - 2 * approach * a * a * a / (3 * R) + std::pow(a, 5) / (5 * R * R))));
  BOOST_TEST(same(in_si(hertz::energy_release_rate(pair, at(approach, a))),
                  E * std::pow(a * a - approach * R, 2) / (2 * pi<double>() * a * R * R)));
}

BOOST_AUTO_TEST_CASE(sign_convention) {
  BOOST_TEST(in_si(hertz::force(pair, at(1e-8, 1e-7))) > 0);  // compressed: repulsive
  BOOST_TEST(in_si(hertz::force(pair, at(-1e-9, 1e-7))) < 0); // held open: attractive
}

BOOST_AUTO_TEST_CASE(no_contact_no_force) {
  BOOST_TEST(in_si(hertz::force(pair, at(1e-8, 0))) == 0);
  BOOST_TEST(in_si(hertz::stored_energy(pair, at(1e-8, 0))) == 0);
  static_assert(std::is_empty_v<hertz>);
}
