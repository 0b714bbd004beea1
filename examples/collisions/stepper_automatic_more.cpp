// The models that stepper_automatic.cpp leaves.
#include "solve_with.hpp"

namespace collisions {

outcome solve_automatic_more(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, ricochet::coulomb>(
      scene, tolerance, damped_by<ricochet::hunt_crossley, ricochet::tsuji>{});
}

} // namespace collisions
