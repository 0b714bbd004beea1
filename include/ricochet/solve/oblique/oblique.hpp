// Impacts at an angle and with spin, in the plane and in space: what friction at the contact does to the bodies.
#pragma once
#include <ricochet/solve/collide.hpp>
#include <ricochet/solve/oblique/planar.hpp>

#include <Eigen/Geometry>

namespace ricochet {

/// An impact in space. Vectors in SI: normal from the first body's centre to the second's, any length; velocity of the
/// first relative to the second, m/s; spins, rad/s. Of a wall, which is the second body, the spin is zero.
struct spatial_impact {
  Eigen::Vector3d normal, velocity, spin_1 = Eigen::Vector3d::Zero(), spin_2 = Eigen::Vector3d::Zero();
};

/// An impact in a plane. speed: whole speed of the relative motion, > 0; angle: between it and the normal, in [0,
/// pi/2); spins: > 0 where the body would roll forward along the other's surface, as 0 slip for spin * radius = speed
/// sin(angle).
struct oblique_impact {
  ricochet::speed speed;
  double angle = 0;
  angular_speed spin_1{}, spin_2{};
};

/// Of a model with a peeling moment.
struct peeling_outcome {
  double peeling_loss = 0; ///< taken by it, in units of the initial kinetic energy of the motion along the normal
};

namespace detail {
template <class Model>
using peeling_part = part<Model::peels, peeling_outcome, 0>;
}

/// What came of an impact with friction. `normal` is the outcome of the motion along the normal.
template <class Model>
struct spatial_outcome : detail::peeling_part<Model> {
  outcome_of<Model> normal;
  Eigen::Vector3d velocity, spin_1, spin_2; ///< at the ending, as in spatial_impact; captured: when that was certain
  Eigen::Vector3d slip;                     ///< velocity of the contact point of the first body over the second
  bool rolls = false;                       ///< at the ending, as does one that never slid; or sticks somewhere
  double impulse_ratio = 0;                 ///< tangential over normal impulse, >= 0
  double friction_loss = 0;                 ///< in units of the initial kinetic energy of the motion along the normal
  double rotation_1 = 0, rotation_2 = 0;    ///< angle turned during the contact, of the spin along its final axis, rad
  double normal_turn = 0;                   ///< angle by which the normal turns during contact, rad: neglected
  std::vector<std::string> warnings;        ///< one sentence where that angle is above 0.01
};

template <class Model>
struct oblique_outcome : detail::peeling_part<Model> {
  outcome_of<Model> normal;
  speed tangential_speed; ///< of the relative motion, along its initial direction
  angular_speed spin_1, spin_2;
  std::optional<double> tangential_restitution; ///< tangential speed over the initial one; absent if that was zero
  std::optional<double> rebound_angle; ///< between normal and relative velocity, > 0 forward; absent when captured
  bool rolls = false;
  double impulse_ratio = 0, friction_loss = 0; ///< as in spatial_outcome; impulse_ratio > 0 where it slows the motion
  double rotation_1 = 0, rotation_2 = 0, normal_turn = 0;
  std::vector<std::string> warnings;
};

namespace detail {
inline void require_finite(const char* name, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i)
    require(std::string(name) + "[" + std::to_string(i) + "]", vector[i], any_finite);
}
inline constexpr double negligible_turn = 1e-2; // rad
} // namespace detail

/// With the given stepper, stepper::automatic unless another is wanted.
/// \throws bad_input for a vector that is not finite, a normal of no length, bodies that do not approach, and as
/// collide().
/// Friction is tangential, so that the contact point moves along one direction, of an elastic contact also backwards,
/// and slip and way are measured along it; homogeneous spheres: d(slip) = -(7/2) impulse/m*. The normal is held fixed
/// during contact. With a peeling moment, of a sphere on a wall, the motion has to stay in a plane: \throws bad_input
/// for spin_1 out of it. Source: Brach & Dunn 1995, appendix B, in space.
template <class Stepper = stepper::automatic, class Model>
auto collide(const Model& model, const spatial_impact& impact, const collide_options& options = {}, Stepper = {}) {
  static_assert(Model::has_friction, "an oblique impact needs a tangential law: add coulomb");
  detail::require_finite("normal", impact.normal);
  detail::require_finite("velocity", impact.velocity);
  detail::require_finite("spin_1", impact.spin_1);
  detail::require_finite("spin_2", impact.spin_2);
  require("length of the normal", impact.normal.norm(), positive);
  const Eigen::Vector3d n = impact.normal.normalized();
  const auto& bodies = model.pair.bodies;
  require("radius of the first body", bodies.radius_1, positive);
  const double r1 = in_si(bodies.radius_1), r2 = in_si(bodies.radius_2), m1 = in_si(bodies.mass_1),
               m2 = in_si(bodies.mass_2), m = in_si(model.pair.reduced_mass);
  const bool wall = std::isinf(r2);
  const double closing = impact.velocity.dot(n);
  require("speed of approach", closing * units::metres_per_second, positive);

  const Eigen::Vector3d surface_spin =
      r1 * impact.spin_1 + (wall ? Eigen::Vector3d::Zero() : Eigen::Vector3d(r2 * impact.spin_2));
  const Eigen::Vector3d slip = impact.velocity - closing * n + surface_spin.cross(n);
  double sliding = slip.norm(), spin = 0;
  Eigen::Vector3d direction = sliding > 0 ? Eigen::Vector3d(slip / sliding) : Eigen::Vector3d::Zero();
  if constexpr (Model::peels) {
    const auto motion = detail::planar(n, impact.velocity - closing * n, impact.spin_1, r1, closing);
    direction = motion.forward, sliding = motion.slip, spin = motion.spin;
  }

  spatial_outcome<Model> out;
  out.normal = integrate(model,
                         {.speed = closing * units::metres_per_second,
                          .slip = sliding * units::metres_per_second,
                          .spin = spin * units::radians_per_second},
                         options, Stepper{});
  double still_sliding = in_si(out.normal.slip);
  if constexpr (!Model::peels) // a moment may make it slide faster
    still_sliding = std::clamp(still_sliding, -sliding, sliding);
  if (std::abs(sliding - still_sliding) <= 4 * std::numeric_limits<double>::epsilon() * sliding)
    still_sliding = sliding; // the round-off of scales is no friction
  const double time = in_si(out.normal.elapsed_time),
               rate = out.normal.restitution ? -*out.normal.restitution * closing : in_si(out.normal.approach_rate);
  double impulse = 2. / 7 * m * (sliding - still_sliding); // on the first body, against the direction
  if constexpr (Model::peels)
    impulse = m * (sliding - still_sliding + r1 * (spin - in_si(out.normal.spin)));
  const Eigen::Vector3d turning = impulse * n.cross(direction); // each spin changes by -turning r/(2/5 m r^2)
  out.velocity = impact.velocity + (rate - closing) * n - impulse / m * direction;
  out.spin_1 = impact.spin_1 - turning * (2.5 / (m1 * r1));
  out.spin_2 = wall ? impact.spin_2 : Eigen::Vector3d(impact.spin_2 - turning * (2.5 / (m2 * r2)));
  out.slip = still_sliding * direction;
  out.rolls = out.normal.sticks;
  out.impulse_ratio = std::abs(impulse) / (m * (closing - rate));
  out.friction_loss = 2. / 7 * (sliding - still_sliding) * (sliding + still_sliding) / (closing * closing);
  // Impulse over time and twice over time: int J dt = (2/7) m* (slip_0 t - slip distance).
  const double impulse_time = 2. / 7 * m * (sliding * time - in_si(out.normal.slip_distance));
  const Eigen::Vector3d turned = impulse_time * n.cross(direction);
  out.rotation_1 = (impact.spin_1 * time - turned * (2.5 / (m1 * r1))).norm();
  out.rotation_2 = wall ? 0 : (impact.spin_2 * time - turned * (2.5 / (m2 * r2))).norm();
  const Eigen::Vector3d shift = (impact.velocity - closing * n) * time - impulse_time / m * direction;
  out.normal_turn = wall ? 0 : shift.norm() / (r1 + r2);
  if constexpr (Model::peels) { // the impulse does not say all
    out.spin_1 = impact.spin_1 - (spin - in_si(out.normal.spin)) * direction.cross(n);
    out.rotation_1 = std::abs(out.normal.rotation);
    out.friction_loss = out.normal.friction_loss;
    out.peeling_loss = out.normal.peeling_loss;
  }
  if (out.normal_turn > detail::negligible_turn)
    out.warnings.push_back("the turn of the normal in contact is " + shown(out.normal_turn) +
                           " rad: above 0.01 rad, it should not be neglected");
  return out;
}

/// \throws bad_input as collide() of a spatial_impact, and for an angle outside [0, pi/2).
template <class Stepper = stepper::automatic, class Model>
auto collide(const Model& model, const oblique_impact& impact, const collide_options& options = {}, Stepper = {}) {
  require("speed", impact.speed, positive);
  require("angle", impact.angle, range{.high = pi<double>() / 2, .high_included = false});
  require("spin_1", impact.spin_1, any_finite);
  require("spin_2", impact.spin_2, any_finite);
  // normal x, motion along y; a spin about -z rolls the first body along y, and so does it with the second
  const double v = in_si(impact.speed);
  const Eigen::Vector3d axis = -Eigen::Vector3d::UnitZ();
  const auto solved = collide(model,
                              spatial_impact{.normal = Eigen::Vector3d::UnitX(),
                                             .velocity = {v * std::cos(impact.angle), v * std::sin(impact.angle), 0},
                                             .spin_1 = in_si(impact.spin_1) * axis,
                                             .spin_2 = in_si(impact.spin_2) * axis},
                              options, Stepper{});
  oblique_outcome<Model> out;
  out.normal = solved.normal;
  const double before = v * std::sin(impact.angle), after = solved.velocity.y();
  out.tangential_speed = after * units::metres_per_second;
  out.spin_1 = solved.spin_1.dot(axis) * units::radians_per_second;
  out.spin_2 = solved.spin_2.dot(axis) * units::radians_per_second;
  if (before != 0)
    out.tangential_restitution = after / before;
  if (solved.normal.ending == ending::separated)
    out.rebound_angle = std::atan2(after, -solved.velocity.x());
  out.rolls = solved.rolls;
  out.impulse_ratio = std::copysign(solved.impulse_ratio, before - after);
  out.friction_loss = solved.friction_loss;
  if constexpr (Model::peels)
    out.peeling_loss = solved.peeling_loss;
  out.rotation_1 = solved.rotation_1;
  out.rotation_2 = solved.rotation_2;
  out.normal_turn = solved.normal_turn;
  out.warnings = solved.warnings;
  return out;
}

} // namespace ricochet
