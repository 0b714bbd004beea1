#include "solve_with.hpp"

namespace collisions {

/// In stepper_automatic_more.cpp: one file for all would take the compiler too long.
outcome solve_automatic_more(const scene& scene, double tolerance);

outcome solve_automatic(const scene& scene, double tolerance) {
  if (std::holds_alternative<ricochet::hunt_crossley>(scene.damping) ||
      std::holds_alternative<ricochet::tsuji>(scene.damping))
    return solve_automatic_more(scene, tolerance);
  return solve_with<ricochet::stepper::automatic>(scene, tolerance, damped_by<no_law, ricochet::kuwabara_kono>{});
}

} // namespace collisions
