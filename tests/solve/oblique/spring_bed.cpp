#include <boost/test/unit_test.hpp>

#include <ricochet/law/tangential/mindlin.hpp>
#include <ricochet/solve/oblique/spring_bed.hpp>

#include <random>

using namespace ricochet;

namespace {

using law = mindlin_law<reduced<double>>;
using part = configuration<reduced<double>>;
constexpr double f = 0.3, kappa = 0.8, E = 1.7, R = 1.3;
constexpr basic_pair<reduced<double>> pair{E, R, 1.};

part contact(double radius, double rate) { return {square(radius) / R, rate, radius, 0}; }
double press(double radius) { return 4. / 3 * E * cube(radius) / R; }

/// A bed that was loaded along the normal up to this radius.
auto pressed_bed(double friction, double radius, int springs) {
  spring_bed<double, law> bed(law{friction, kappa}, pair);
  for (int i = 1; i <= springs; ++i)
    bed.force(contact(radius * i / springs, 1), 0);
  return bed;
}

/// Force of a contact of constant press that is sheared by s from rest: Cattaneo and Mindlin, f F_N (1 - (1 - s/s_max)
/// ^{3/2}), s_max = f delta/kappa.
double mindlins_force(double radius, double s) {
  const double part = s * kappa / (f * square(radius) / R);
  return f * press(radius) * (part < 1 ? 1 - std::pow(1 - part, 1.5) : 1);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_contact_that_sticks_has_the_stiffness_of_mindlin) { // 8 G* a = 2 kappa E* a
  auto bed = pressed_bed(1e12, 0.7, 100);
  BOOST_TEST(std::abs(bed.force(contact(0.7, 0), 1e-3) / (2 * kappa * E * 0.7 * 1e-3) - 1) < 1e-3);
  BOOST_TEST(bed.sticks());
}

BOOST_AUTO_TEST_CASE(pressed_and_sheared_together_it_sticks_below_the_slope_of_friction) { // psi_1 < 1 of Maw et al.
  for (const double psi : {0., 0.3, 0.99, 1.01, 2.}) {
    const double slope = psi * f / kappa; // of the way over the approach
    spring_bed<double, law> bed(law{f, kappa}, pair);
    for (int i = 1; i <= 20; ++i) {
      const double radius = 0.7 * i / 20, before = 0.7 * (i - 1) / 20;
      const double force = bed.force(contact(radius, 1), slope * (square(radius) - square(before)) / R);
      BOOST_TEST(std::abs(force - std::min(psi, 1.) * f * press(radius)) < 1e-14);
      BOOST_TEST(bed.sticks() == (psi < 1));
    }
  }
}

BOOST_AUTO_TEST_CASE(sheared_at_constant_press_it_follows_cattaneo_and_mindlin) {
  const double a = 0.7, most = f * square(a) / R / kappa;
  for (const int springs : {5, 50, 200}) { // the sum is exact: stretches are the same, or linear in x^2
    auto bed = pressed_bed(f, a, springs);
    double s = 0;
    for (const double part : {0.02, 0.1, 0.35, 0.7, 0.93}) {
      const double force = bed.force(contact(a, 0), part * most - s);
      s = part * most;
      BOOST_TEST(std::abs(force - mindlins_force(a, s)) < 1e-14);
      BOOST_TEST(bed.sticks());
    }
    BOOST_TEST(std::abs(bed.force(contact(a, 0), 5 * most) - f * press(a)) < 1e-14);
    BOOST_TEST(!bed.sticks());
  }
}

BOOST_AUTO_TEST_CASE(sheared_back_and_forth_it_follows_mindlin_and_deresiewicz) {
  const double a = 0.7, most = f * square(a) / R / kappa, peak = 0.8 * most;
  auto bed = pressed_bed(f, a, 400);
  double s = 0, worst = 0;
  const auto shear_to = [&](double to, double expected) {
    worst = std::max(worst, std::abs(bed.force(contact(a, 0), to - s) - expected) / (f * press(a)));
    s = to;
  };
  shear_to(peak, mindlins_force(a, peak));
  for (const double to : {0.7, 0.3, -0.2, -0.7}) // unloading: twice the virgin curve at half the way
    shear_to(to * most, mindlins_force(a, peak) - 2 * mindlins_force(a, (peak - to * most) / 2));
  shear_to(-peak, -mindlins_force(a, peak));
  for (const double to : {-0.5, 0.1, 0.6})
    shear_to(to * most, -mindlins_force(a, peak) + 2 * mindlins_force(a, (peak + to * most) / 2));
  shear_to(peak, mindlins_force(a, peak)); // the loop closes
  BOOST_TEST(worst < 1e-4);                // second order in the cells with the corners of earlier borders
}

BOOST_AUTO_TEST_CASE(whatever_happens_friction_holds_no_more_than_f_times_the_press) {
  std::mt19937_64 generator(17);
  std::uniform_real_distribution<> any(-1, 1);
  for (int walk = 0; walk < 200; ++walk) {
    const double friction = walk % 5 == 0 ? 0 : 0.3 * std::pow(10., 3 * any(generator));
    spring_bed<double, law> bed(law{friction, kappa}, pair);
    double radius = 0, rate = 0.02;
    for (int i = 0; i < 300; ++i) {
      if (any(generator) > 0.9 || radius > 1)
        rate = -rate;
      radius += rate * std::abs(any(generator));
      if (radius <= 0) {
        bed.touch();
        radius = 0;
        rate = 0.02;
        continue;
      }
      const double force = bed.force(contact(radius, rate), 0.02 * cube(any(generator)));
      BOOST_TEST_REQUIRE(std::abs(force) <= friction * press(radius) * (1 + 1e-12));
    }
  }
}
