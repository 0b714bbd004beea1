#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/number/autodiff.hpp>
#include <ricochet/number/multiprecision.hpp>

using namespace ricochet;

BOOST_AUTO_TEST_CASE(excess_over_sine_keeps_its_digits) {
  for (const double x : {1e-9, 1e-3, 0.3, 0.99, 1.01, 3., 6.}) {
    const multiprecise<50> wide(x);
    const double expected = static_cast<double>(multiprecise<50>(wide - sin(wide)));
    BOOST_TEST(std::abs(excess_over_sine(x, std::sin(x)) / expected - 1) < 1e-15); // eight roundings at most
    BOOST_TEST(abs(excess_over_sine(wide, multiprecise<50>(sin(wide))) / (wide - sin(wide)) - 1) < 1e-20);
  }
}

// Gap where the pull ends, by integrating the displacement of the half-space, u(r) - (delta - r^2/2R), over rings.
BOOST_AUTO_TEST_CASE(the_gap_at_the_edge_of_the_pull_is_its_range) {
  using S = reduced<double>;
  const basic_pair<S> pair{2, 3, 1};
  for (const double z0 : {0.01, 0.4, 2.}) {
    const maugis_dugdale_law<S> law{0.7, z0};
    const auto branch = law.branch(pair, 0.5);
    const double strain = 2 * 0.7 / (z0 * 2);
    for (const double beyond : {0.2, 0.7, 1.5}) {
      const double y = std::max(branch.fold(), 0.) + beyond;
      const auto p = branch.at(y, true);
      // gap(c) = (2/pi) int_a^c [s^2/R - delta - strain sqrt(c^2 - s^2)] ds/sqrt(c^2 - s^2), with s = c cos(phi)
      const int parts = 2000;
      double sum = 0;
      for (int i = 0; i < parts; ++i) {
        const double phi = p.angle * (i + 0.5) / parts, s = p.cohesive_radius * std::cos(phi);
        sum += s * s / 3 - p.approach - strain * p.cohesive_radius * std::sin(phi);
      }
      const double gap = 2 / std::numbers::pi * sum * p.angle / parts;
      BOOST_TEST(std::abs(gap / z0 - 1) < 1e-5); // midpoint rule
      BOOST_TEST(std::abs(branch.y_at(p.approach) - y) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(where_the_surfaces_touch_both_sides_meet) {
  using S = reduced<double>;
  const basic_pair<S> pair{2, 3, 1};
  for (const double z0 : {0.5, 3., 40.}) {
    const auto branch = maugis_dugdale_law<S>{0.7, z0}.branch(pair, 0.5);
    const auto disc = branch.at(0, false), ring = branch.at(0, true);
    BOOST_TEST(std::abs(disc.approach - ring.approach) < 1e-14 * (z0 + std::abs(ring.approach)));
    BOOST_TEST(disc.radius == 0);
    BOOST_TEST(std::abs(ring.radius) < 1e-15);
    BOOST_TEST(branch.at(0.3, true).radius < 0.5); // the typical radius that was asked for
    BOOST_TEST(branch.at(3, true).radius > 0.5);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_of_the_first_pull) {
  using S = reduced<dual<>>;
  for (const double z0 : {0.02, 0.3}) {
    const auto first = [&](double range) {
      const auto branch = maugis_dugdale_law<reduced<double>>{0.7, range}.branch({2., 3., 1.}, 0.5);
      return branch.at(branch.first(), branch.first() >= 0).cohesive_radius;
    };
    const auto branch =
        maugis_dugdale_law<S>{dual<>(0.7), seeded(z0)}.branch({dual<>(2), dual<>(3), dual<>(1)}, dual<>(0.5));
    const double found = branch.at(branch.first(), value_of(branch.first()) >= 0).cohesive_radius.derivative(1);
    const double h = 1e-5 * z0, expected = (first(z0 + h) - first(z0 - h)) / (2 * h);
    BOOST_TEST(std::abs(found / expected - 1) < 1e-7); // of the difference quotient
  }
}
