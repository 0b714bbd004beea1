// The models with stick and slip.
#include "solve_with.hpp"

namespace collisions {

outcome solve_automatic_stick_slip(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, ricochet::mindlin>(scene, tolerance, all_damping{});
}

} // namespace collisions
