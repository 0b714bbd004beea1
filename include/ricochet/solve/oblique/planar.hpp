// Motion of a sphere on a wall that stays in a plane.
#pragma once
#include <ricochet/body/validate.hpp>

#include <algorithm>

#include <Eigen/Geometry>

namespace ricochet::detail {

/// The contact point slides forward, and the sphere turns so as to roll forward where its spin is > 0.
struct planar_motion {
  Eigen::Vector3d forward; ///< zero where nothing moves along the surface
  double slip, spin;       ///< m/s, >= 0; rad/s
};

/// n: normal, of length one; velocity: of the sphere along the surface; approach: its speed along the normal.
/// \throws bad_input where the spin takes the motion out of the plane, beyond round-off.
inline planar_motion planar(const Eigen::Vector3d& n, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin,
                            double radius, double approach) {
  const Eigen::Vector3d surface_velocity = radius * n.cross(spin);
  const double moving = velocity.norm(), turning = surface_velocity.norm(), faster = std::max(moving, turning);
  const double round_off = 1e-12 * (faster + approach);
  const auto refuse = [&](double part, const char* where) {
    throw bad_input("spin_1 = " + shown(part) + " rad/s " + where +
                    ": with a peeling moment the sphere rolls in a plane");
  };
  if (const double drilling = n.dot(spin); std::abs(drilling) * radius > round_off)
    refuse(drilling, "about the normal");
  if (faster > 0)
    if (const double aside = velocity.cross(surface_velocity).norm() / faster; aside > round_off)
      refuse(spin.norm(), "is not perpendicular to the plane of normal and velocity");
  if (!(faster > 0))
    return {Eigen::Vector3d::Zero(), 0, 0};
  const Eigen::Vector3d along = (turning > moving ? surface_velocity : velocity) / faster;
  const double slip = (velocity - surface_velocity).dot(along), sign = slip < 0 ? -1 : 1;
  return {sign * along, sign * slip, sign * surface_velocity.dot(along) / radius};
}

} // namespace ricochet::detail
