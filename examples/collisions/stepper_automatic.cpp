#include "solve_with.hpp"

namespace collisions {

// In files of their names: one for all would take the compiler too long.
outcome solve_automatic_more(const scene& scene, double tolerance);
outcome solve_automatic_stick_slip(const scene& scene, double tolerance);

outcome solve_automatic(const scene& scene, double tolerance) {
  if (std::holds_alternative<ricochet::mindlin>(scene.tangential))
    return solve_automatic_stick_slip(scene, tolerance);
  if (std::holds_alternative<ricochet::hunt_crossley>(scene.damping) ||
      std::holds_alternative<ricochet::tsuji>(scene.damping))
    return solve_automatic_more(scene, tolerance);
  return solve_with<ricochet::stepper::automatic, ricochet::coulomb>(scene, tolerance,
                                                                     damped_by<no_law, ricochet::kuwabara_kono>{});
}

} // namespace collisions
