// Impacts at an angle: symmetries, and the limits of little and of much friction.
// RICOCHET_SCENES sets the number of random scenes of each relation (40 unless given).
#include <boost/test/unit_test.hpp>

#include "metamorphic/relation.hpp"

#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>
#include <ricochet/solve/oblique/oblique.hpp>

using namespace metamorphic;
using Eigen::Vector3d;

namespace {

/// Directions and spins of random impacts; `flat` where they have to stay in the plane of x and y.
class directions {
public:
  Vector3d any() { return {component_(generator_), component_(generator_), component_(generator_)}; }
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator_); }

  /// The first body moves towards the second, which is along x.
  spatial_impact onto(const scene& s, bool flat) {
    const double v = in_si(s.speed), angle = between(0.05, 1.4), spin = v / in_si(s.one.radius);
    spatial_impact motion{.normal = Vector3d::UnitX(), .velocity = {v * std::cos(angle), v * std::sin(angle), 0}};
    motion.spin_1 = flat ? Vector3d(0, 0, between(-2, 2) * spin) : Vector3d(spin * any());
    if (!s.wall)
      motion.spin_2 = flat ? Vector3d(0, 0, between(-2, 2) * spin) : Vector3d(spin * any());
    return motion;
  }

private:
  std::mt19937 generator_{7};
  std::normal_distribution<> component_;
};

double largest_distance = 0; ///< of motions that ought to be the same, over the speed

/// Calls `use(model, flat)` with models of a scene that have friction.
template <class Use>
void for_each_friction(const scene& s, double f, const Use& use) {
  use(viscous_hertz(s, coulomb{f}), false);
  use(viscous_jkr(s, coulomb{f}), false);
  use(static_jkr(s, edge(s), coulomb{f}), false);
  use(viscous_hertz(s, mindlin{f, stiffness_ratio_of(s.one.solid, s.other.solid)}), false);
  const double R = in_si(s.pair.reduced_radius), moment = 0.1 * in_si(s.force_per_length) * R * R;
  if (s.wall)
    use(hertzian(s, line_force{s.force_per_length, s.rebound_coefficient},
                 coulomb_with_peeling{f, moment * newton_metres}),
        true);
}

/// Two motions after an impact are the same as far as their bounds of error tell: to round-off, but where a rounding
/// decides over the steps of a free edge or of a bed of springs.
template <class Outcome>
void same(const Outcome& a, const Outcome& b, const scene& s, const spatial_impact& motion) {
  const double v = in_si(s.speed), r1 = in_si(s.one.radius), r2 = s.wall ? 0 : in_si(s.other.radius);
  const double closing = motion.velocity.dot(motion.normal) / motion.normal.norm();
  const double touching = (motion.velocity.norm() + r1 * motion.spin_1.norm() + r2 * motion.spin_2.norm()) / v;
  const double apart = std::max({(a.velocity - b.velocity).norm(), (a.slip - b.slip).norm(),
                                 r1 * (a.spin_1 - b.spin_1).norm(), r2 * (a.spin_2 - b.spin_2).norm()}) /
                       v;
  const double error = (a.normal.slip_error_estimate + b.normal.slip_error_estimate + 1e-14) * touching +
                       a.normal.error_estimate + b.normal.error_estimate;
  BOOST_TEST(name_of(a.normal.ending) == name_of(b.normal.ending));
  BOOST_TEST(apart <= error);
  BOOST_TEST(std::abs(a.friction_loss - b.friction_loss) <= error * touching * v * v / (closing * closing));
  largest_distance = std::max(largest_distance, apart);
}

} // namespace

BOOST_AUTO_TEST_CASE(space_has_no_preferred_direction) {
  directions random;
  for_random_scenes(31, 40, [&](const scene& s) {
    for_each_friction(s, random.between(0.02, 1), [&](const auto& model, bool flat) {
      const auto motion = random.onto(s, flat);
      const Eigen::Matrix3d turn =
          Eigen::Quaterniond(Eigen::Vector4d(random.any().x(), random.any().x(), random.any().x(), 1).normalized())
              .toRotationMatrix();
      auto expected = collide(model, motion);
      for (Vector3d* each : {&expected.velocity, &expected.slip, &expected.spin_1, &expected.spin_2})
        *each = turn * *each;
      same(collide(model, spatial_impact{turn * motion.normal, turn * motion.velocity, turn * motion.spin_1,
                                         turn * motion.spin_2}),
           expected, s, motion);
    });
  });
  BOOST_TEST_MESSAGE("apart by up to " << std::exchange(largest_distance, 0));
}

BOOST_AUTO_TEST_CASE(a_mirror_shows_a_possible_impact) {
  // Mirrored at the plane of x and z: velocities change sign along y, spins along x and z.
  const Vector3d of_velocity(1, -1, 1), of_spin(-1, 1, -1);
  directions random;
  for_random_scenes(32, 40, [&](const scene& s) {
    for_each_friction(s, random.between(0.02, 1), [&](const auto& model, bool flat) {
      const auto mirrored = [&](const Vector3d& x, const Vector3d& signs) -> Vector3d { return x.cwiseProduct(signs); };
      const auto motion = random.onto(s, flat);
      auto expected = collide(model, motion);
      expected.velocity = mirrored(expected.velocity, of_velocity),
      expected.slip = mirrored(expected.slip, of_velocity);
      expected.spin_1 = mirrored(expected.spin_1, of_spin), expected.spin_2 = mirrored(expected.spin_2, of_spin);
      same(collide(model, spatial_impact{motion.normal, mirrored(motion.velocity, of_velocity),
                                         mirrored(motion.spin_1, of_spin), mirrored(motion.spin_2, of_spin)}),
           expected, s, motion);
    });
  });
  BOOST_TEST_MESSAGE("apart by up to " << std::exchange(largest_distance, 0));
}

BOOST_AUTO_TEST_CASE(either_body_may_be_called_the_first) {
  directions random;
  for_random_scenes(33, 40, [&](const scene& s) {
    if (s.wall)
      return;
    scene swapped = s;
    std::swap(swapped.one, swapped.other);
    swapped.pair = bodies(swapped);
    const double f = random.between(0.02, 1);
    const auto motion = random.onto(s, false);
    const spatial_impact seen{-motion.normal, -motion.velocity, motion.spin_2, motion.spin_1};
    const auto check = [&](auto out, const auto& expected) {
      out.velocity *= -1, out.slip *= -1;
      std::swap(out.spin_1, out.spin_2);
      same(out, expected, s, motion);
    };
    const double kappa = stiffness_ratio_of(s.one.solid, s.other.solid);
    check(collide(viscous_jkr(swapped, coulomb{f}), seen), collide(viscous_jkr(s, coulomb{f}), motion));
    check(collide(viscous_hertz(swapped, mindlin{f, kappa}), seen),
          collide(viscous_hertz(s, mindlin{f, kappa}), motion));
  });
}

BOOST_AUTO_TEST_CASE(head_on_without_spin_friction_has_nothing_to_do) {
  for_random_scenes(34, 40, [&](const scene& s) {
    for_each_friction(s, 0.3, [&](const auto& model, bool) {
      const auto out = collide(model, oblique_impact{.speed = s.speed, .angle = 0});
      BOOST_TEST(in_si(out.tangential_speed) == 0);
      BOOST_TEST(in_si(out.spin_1) == 0);
      BOOST_TEST(out.friction_loss == 0);
    });
    const auto tilted = collide(viscous_jkr(s, coulomb{0.3}), oblique_impact{.speed = s.speed, .angle = 0}).normal;
    const auto normal = collide(viscous_jkr(s), impact{s.speed});
    BOOST_TEST(std::abs(tilted.restitution.value_or(0) - normal.restitution.value_or(0)) <=
               tilted.error_estimate + normal.error_estimate);
  });
}

BOOST_AUTO_TEST_CASE(little_friction_changes_little_and_much_friction_makes_roll) {
  directions random;
  for_random_scenes(35, 40, [&](const scene& s) {
    const oblique_impact motion{.speed = s.speed, .angle = random.between(0.05, 1.3)};
    const double v = in_si(s.speed), along = v * std::sin(motion.angle);
    for_each_friction(s, 1e-3, [&](auto model, bool peels) {
      if (peels) // a moment acts without friction too
        return;
      const auto out = collide(model, motion);
      model.tangential.friction_coefficient /= 100;
      const auto less = collide(model, motion);
      const double taken = 1 - in_si(out.tangential_speed) / along, left = 1 - in_si(less.tangential_speed) / along;
      BOOST_TEST(std::abs(left - taken / 100) <= 2e-4 * taken + less.normal.slip_error_estimate);
    });
    // Rolling takes 2/7 of the slip from the motion along the surface, whatever else there is.
    const auto rolling = collide(viscous_jkr(s, coulomb{1e4}), motion);
    BOOST_TEST(rolling.rolls);
    BOOST_TEST(std::abs(in_si(rolling.tangential_speed) / along - 5. / 7) < 1e-12);
  });
}

BOOST_AUTO_TEST_CASE(elastic_contacts_that_hardly_slip) {
  // Slip stays in a ring as wide as 1/f, at touch and when the contact opens. Of Hertz's contact nothing but the angle,
  // f and kappa matters.
  directions random;
  const double angle = random.between(0.5, 1);
  std::vector<double> all;
  for_random_scenes(37, 40, [&](const scene& s) {
    double error = 0;
    const auto rebound = [&](double f) {
      const auto out = collide(hertzian(s, mindlin{f, 0.8}), oblique_impact{.speed = s.speed, .angle = angle});
      error = std::max(error, out.normal.slip_error_estimate);
      return *out.tangential_restitution;
    };
    const double some = rebound(10), more = rebound(100), most = rebound(1000);
    BOOST_TEST(std::abs((most - more) / (more - some) - 0.1) < 0.002);
    all.push_back(some);
    BOOST_TEST(std::abs(all.front() - some) <= error);
  });
}

BOOST_AUTO_TEST_CASE(sliding_friction_takes_its_share_of_the_momentum) {
  // While all of the contact slides the impulse along the surface is f times that along the normal, m v (1 + e).
  for_random_scenes(36, 40, [&](const scene& s) {
    const double f = 0.01;
    const oblique_impact motion{.speed = s.speed, .angle = 1.2};
    const double v = in_si(s.speed), normal = v * std::cos(motion.angle);
    const auto out = collide(hertzian(s, coulomb{f}), motion);
    const double lost = v * std::sin(motion.angle) - in_si(out.tangential_speed);
    BOOST_TEST(std::abs(lost / (f * normal * (1 + *out.normal.restitution)) - 1) < 1e-7);
    BOOST_TEST(std::abs(out.impulse_ratio / f - 1) < 1e-7);
  });
}
