#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/body/pair.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
const sphere ice{materials::water_ice, 2.0 * micrometres}, ball{materials::steel, 5.0 * micrometres};
const flat_wall wall{materials::silicon};

bool same(double a, double b) { return std::abs(a / b - 1) < 1e-15; } // a few roundings

auto says(const std::string& name, const std::string& value, const std::string& range) {
  return [=](const bad_input& e) {
    const std::string what = e.what();
    return what.find(name + " = " + value) != std::string::npos && what.find(range) != std::string::npos;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(like_spheres) {
  const contact_pair p = between(ice, ice);
  BOOST_TEST(same(in_si(p.reduced_modulus), 7e9 / (2 * (1 - 0.0625))));
  BOOST_TEST(same(in_si(p.reduced_radius), 1e-6));
  BOOST_TEST(same(in_si(p.reduced_mass), in_si(ice.mass()) / 2));
}

BOOST_AUTO_TEST_CASE(unlike_spheres) {
  const contact_pair p = between(ice, ball);
  BOOST_TEST(same(1 / in_si(p.reduced_modulus), (1 - 0.25 * 0.25) / 7e9 + (1 - 0.28 * 0.28) / 190e9));
  BOOST_TEST(same(in_si(p.reduced_radius), 2e-6 * 5e-6 / 7e-6));
  const double m = in_si(ice.mass()), n = in_si(ball.mass());
  BOOST_TEST(same(in_si(p.reduced_mass), m * n / (m + n)));
}

BOOST_AUTO_TEST_CASE(bodies_may_be_swapped) {
  const contact_pair p = between(ice, ball), q = between(ball, ice);
  BOOST_TEST((p.reduced_modulus == q.reduced_modulus)); // exact: addition commutes
  BOOST_TEST((p.reduced_radius == q.reduced_radius));
  BOOST_TEST((p.reduced_mass == q.reduced_mass));
}

BOOST_AUTO_TEST_CASE(a_wall_is_the_limit_of_a_huge_sphere) {
  const contact_pair limit = between(ice, wall);
  BOOST_TEST((limit.reduced_radius == ice.radius));
  BOOST_TEST((limit.reduced_mass == ice.mass()));
  for (const double larger : {1e3, 1e6}) {
    const contact_pair p = between(ice, sphere{wall.solid, larger * ice.radius});
    BOOST_TEST((p.reduced_modulus == limit.reduced_modulus));
    // 1/R = 1/R1 + 1/R2 and likewise for the masses: relative differences of R1/R2 and m1/m2 to first order
    const double radii = 1 / larger, masses = in_si(ice.mass()) / in_si(sphere{wall.solid, larger * ice.radius}.mass());
    BOOST_TEST(std::abs(in_si(limit.reduced_radius / p.reduced_radius) - 1 - radii) < 1e-15);
    BOOST_TEST(std::abs(in_si(limit.reduced_mass / p.reduced_mass) - 1 - masses) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(wrong_bodies_are_named) {
  const std::pair<double, std::string> wrong[] = {{0, "0"}, {-1, "-1"}, {not_a_number, ""}, {inf, "inf"}};
  for (const auto& [x, text] : wrong) {
    const sphere radius{ice.solid, x * metres};
    BOOST_CHECK_EXCEPTION(between(radius, ice), bad_input, says("first sphere: radius", text, "(0, inf) m"));
    BOOST_CHECK_EXCEPTION(between(ice, radius), bad_input, says("second sphere: radius", text, "(0, inf) m"));
    BOOST_CHECK_EXCEPTION(between(radius, wall), bad_input, says("sphere: radius", text, "(0, inf) m"));
    sphere soft = ice;
    soft.solid.youngs_modulus = x * pascals;
    BOOST_CHECK_EXCEPTION(between(soft, ice), bad_input, says("first sphere: youngs_modulus", text, "(0, inf) Pa"));
    BOOST_CHECK_EXCEPTION(between(ice, soft), bad_input, says("second sphere: youngs_modulus", text, "(0, inf) Pa"));
    BOOST_CHECK_EXCEPTION(between(soft, wall), bad_input, says("sphere: youngs_modulus", text, "(0, inf) Pa"));
    BOOST_CHECK_EXCEPTION(between(ice, flat_wall{soft.solid}), bad_input,
                          says("wall: youngs_modulus", text, "(0, inf) Pa"));
    sphere light = ice;
    light.solid.mass_density = x * kilograms_per_cubic_metre;
    BOOST_CHECK_EXCEPTION(between(light, ice), bad_input, says("first sphere: density", text, "(0, inf) kg/m^3"));
    BOOST_CHECK_EXCEPTION(between(ice, light), bad_input, says("second sphere: density", text, "(0, inf) kg/m^3"));
  }
  sphere incompressible = ice;
  incompressible.solid.poissons_ratio = 0.5;
  BOOST_CHECK_EXCEPTION(between(ice, incompressible), bad_input,
                        says("second sphere: poissons_ratio", "0.5", "[0, 0.5)"));
}
