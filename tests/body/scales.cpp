#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/body/scales.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

bool of_order_one(double x, double factor) { return x > 1 / factor && x < factor; }

/// x measured in the scales and back, up to rounding in three powers and three products.
template <class Quantity>
bool round_trips(const Quantity& x, const scales& unit) {
  return std::abs(reduce<double>(x, unit) * unit.factor(x) / in_si(x) - 1) < 1e-15;
}

} // namespace

BOOST_AUTO_TEST_CASE(factor_of_every_dimension) {
  const scales unit{.length = 4, .duration = 3, .mass = 5};
  BOOST_TEST(unit.factor(2.5) == 1);
  BOOST_TEST(unit.factor(length{}) == 4);
  BOOST_TEST(unit.factor(root_length{}) == 2);
  BOOST_TEST(unit.factor(duration{}) == 3);
  BOOST_TEST(unit.factor(mass{}) == 5);
  // the rest within an ulp or two: reciprocals and products are rounded
  const auto is = [](double a, double b) { return std::abs(a / b - 1) < 1e-15; };
  BOOST_TEST(is(unit.factor(density{}), 5. / 64));
  BOOST_TEST(is(unit.factor(modulus{}), 5. / (4 * 9)));
  BOOST_TEST(is(unit.factor(speed{}), 4. / 3));
  BOOST_TEST(is(unit.factor(force{}), 5. * 4 / 9));
  BOOST_TEST(is(unit.factor(energy{}), 5. * 16 / 9));
  BOOST_TEST(is(unit.factor(energy_per_area{}), 5. / 9));
  BOOST_TEST(is(unit.factor(inverse_speed{}), 3. / 4));
  BOOST_TEST(is(unit.factor(damping{}), 5. / 3));
}

BOOST_AUTO_TEST_CASE(scales_without_adhesion_are_those_of_hertz) {
  const contact_pair p{3e9 * pascals, 1e-6 * metres, 2e-14 * kilograms};
  const scales unit = scales_of(p, 8.0 * metres_per_second, energy_per_area{});
  BOOST_TEST(unit.mass == 2e-14);
  BOOST_TEST(std::abs(unit.length / unit.duration - 8) < 1e-14);
  // (m v^2/(E sqrt R))^(2/5); largest approach of Hertz is (15/16)^(2/5) of it
  BOOST_TEST(std::abs(unit.length / std::pow(2e-14 * 64 / (3e9 * 1e-3), 0.4) - 1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(reduced_numbers_are_of_order_one_whatever_the_scene) {
  for (double radius = 1e-9; radius < 0.2; radius *= 10)
    for (double v = 1e-6; v < 2e3; v *= 10)
      for (const material& solid : {materials::tedlar, materials::water_ice, materials::molybdenum})
        for (const double w : {0., 1e-3, 0.74, 3.}) {
          const contact_pair p = between(sphere{solid, radius * metres}, flat_wall{materials::steel});
          const auto adhesion = w * joules_per_square_metre;
          const scales unit = scales_of(p, v * metres_per_second, adhesion);
          const double m = reduce<double>(p.reduced_mass, unit), E = reduce<double>(p.reduced_modulus, unit),
                       R = reduce<double>(p.reduced_radius, unit), u = reduce<double>(v * metres_per_second, unit);
          // By the scales' definition, up to rounding, whatever is huge or tiny:
          BOOST_TEST_REQUIRE(std::abs(m - 1) < 1e-15);
          BOOST_TEST_REQUIRE(u <= 1 + 1e-14);
          // elastic force at unit approach, (4/3) E sqrt(R) delta^{3/2}: 4/3
          BOOST_TEST_REQUIRE(of_order_one(E * std::sqrt(R), 1 + 1e-12));
          // pull-off force 1.5 pi w R of order one or, in fast impacts, less; in slow ones of order one
          const double pull = 1.5 * pi<double>() * reduce<double>(adhesion, unit) * R;
          BOOST_TEST_REQUIRE(pull < 5);
          if (u < 0.999)
            BOOST_TEST_REQUIRE(pull > 4); // 1.5 pi: the scales then are those of adhesion
          BOOST_TEST_REQUIRE(round_trips(p.reduced_modulus, unit));
          BOOST_TEST_REQUIRE(round_trips(p.reduced_radius, unit));
          BOOST_TEST_REQUIRE(round_trips(v * metres_per_second, unit));
          BOOST_TEST_REQUIRE(round_trips(1e-11 * seconds, unit));
          BOOST_TEST_REQUIRE(round_trips(boost::units::root<2>(1e-9 * metres), unit));
        }
}

BOOST_AUTO_TEST_CASE(reduce_to_another_scalar_keeps_its_precision) {
  const scales unit{.length = 3, .duration = 1, .mass = 1};
  BOOST_TEST(reduce<long double>(1.0 * metres, unit) == 1.0L / 3.0L);
  BOOST_TEST(reduce<float>(1.0 * metres, unit) == 1.0f / 3.0f);
}
