// What must not matter: units of measurement, the order of the bodies, and that a wall is but a very large sphere.
// RICOCHET_SCENES sets the number of random scenes of each composition (12 unless given).
#include <boost/test/unit_test.hpp>

#include "metamorphic/relation.hpp"

using namespace metamorphic;

namespace {

/// The same collision, its numbers in units that are `unit` times smaller than SI's.
scene in_smaller_units(scene s, const scales& unit) {
  const auto convert = [&](auto&... quantity) { ((quantity *= unit.factor(quantity)), ...); };
  convert(s.one.solid.youngs_modulus, s.one.solid.mass_density, s.one.radius, s.other.solid.youngs_modulus,
          s.other.solid.mass_density, s.other.radius, s.speed, s.work_of_adhesion, s.relaxation_time, s.bulk_time,
          s.interaction_range, s.hunt_crossley_coefficient, s.edge_speed, s.force_per_length, s.rebound_coefficient,
          s.yield_strength);
  s.pair = bodies(s);
  return s;
}

} // namespace

BOOST_AUTO_TEST_CASE(decimal_units_of_length_mass_and_time_do_not_matter) {
  // Numbers in other units are rounded anew, so that round-off is what is reached: 1e-16 to 1e-15 in the median. Where
  // a rounding decides over the steps of a free edge or of a ring force, it is 1e-10.
  for (const composition& laws : compositions()) {
    spread apart(laws.name);
    std::mt19937 random(3);
    const auto power = [&] { return std::pow(10., 12 * (int(random() % 3) - 1)); };
    for_random_scenes(1, 60, [&](const scene& s) {
      const scales unit{.length = power(), .duration = power(), .mass = power()};
      const scene other = in_smaller_units(s, unit);
      const summary a = laws.integrate(s, 1e-8), b = laws.integrate(other, 1e-8);
      apart.compare(a, b);
      if (a.ending == ending::separated)
        BOOST_TEST(std::abs(b.duration / unit.duration / a.duration - 1) < 1e-6);
      apart.compare(laws.collide(s, 1e-8), laws.collide(other, 1e-8));
    });
    apart.tell();
    BOOST_TEST(apart.median() <= 4e-15);
    BOOST_TEST(apart.largest() <= 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(binary_units_change_but_last_bits) {
  // No number is rounded, but the roots and the power of 2/5 in a collision's own scales are: not all outcomes are the same.
  for (const composition& laws : compositions()) {
    spread apart(laws.name);
    std::mt19937 random(4);
    const auto power = [&] { return std::ldexp(1., 30 * (int(random() % 3) - 1)); };
    for_random_scenes(2, 60, [&](const scene& s) {
      const scene other = in_smaller_units(s, {.length = power(), .duration = power(), .mass = power()});
      apart.compare(laws.integrate(s, 1e-8), laws.integrate(other, 1e-8));
      apart.compare(laws.collide(s, 1e-8), laws.collide(other, 1e-8));
    });
    apart.tell();
    BOOST_TEST(apart.median() <= 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(bodies_may_be_swapped) {
  for (const composition& laws : compositions())
    for_random_scenes(3, 20, [&](scene s) {
      if (s.wall)
        return;
      const summary one_way = laws.integrate(s, 1e-8);
      std::swap(s.one, s.other);
      s.pair = bodies(s);
      BOOST_TEST(laws.integrate(s, 1e-8).restitution == one_way.restitution); // addition commutes
    });
}

BOOST_AUTO_TEST_CASE(a_huge_sphere_is_nearly_a_wall) {
  // 1/R = 1/R_1 + 1/R_2, so that all differences go as R_1/R_2, until the tolerance covers them.
  for (const composition& laws : compositions()) {
    double furthest = 0;
    for_random_scenes(4, 20, [&](const scene& s) {
      if (!s.wall)
        return;
      const summary at_wall = laws.integrate(s, 1e-10);
      if (!at_wall.ended() || !at_wall.certain || at_wall.restitution < 0.1)
        return; // near sticking e has an infinite slope
      const auto difference = [&](double times) {
        scene huge = s;
        huge.wall = false;
        huge.other.radius = times * s.one.radius;
        huge.pair = bodies(huge);
        const summary out = laws.integrate(huge, 1e-10);
        BOOST_TEST(name_of(out.ending) == name_of(at_wall.ending));
        return out.restitution - at_wall.restitution;
      };
      const double large = difference(1e4), larger = difference(1e6);
      furthest = std::max(furthest, std::abs(larger));
      BOOST_TEST(std::abs(larger - large / 100) < 1e-3 * std::abs(large) + 4e-10);
    });
    BOOST_TEST_MESSAGE(laws.name << ": a million times larger sphere differs by " << furthest);
    BOOST_TEST(furthest < 1e-5);
  }
}
