#include "solve_with.hpp"

namespace collisions {

// In files of their names: one for all would take the compiler too long.
outcome solve_automatic_more(const scene& scene, double tolerance);
outcome solve_automatic_stick_slip(const scene& scene, double tolerance);
outcome solve_automatic_linear(const scene& scene, double tolerance);
outcome solve_automatic_peeling(const scene& scene, double tolerance);
outcome solve_automatic_power_law(const scene& scene, double tolerance);
outcome solve_automatic_flow(const scene& scene, double tolerance);
outcome solve_automatic_cohesive(const scene& scene, double tolerance);

namespace {
struct laws : usual_laws {
  using damping = std::variant<no_law, ricochet::kuwabara_kono>;
};
} // namespace

outcome solve_automatic(const scene& scene, double tolerance) {
  if (std::holds_alternative<ricochet::thornton_ning_contact>(scene.plasticity))
    return solve_automatic_flow(scene, tolerance);
  if (std::holds_alternative<ricochet::maugis_dugdale>(scene.adhesion))
    return solve_automatic_cohesive(scene, tolerance);
  if (std::holds_alternative<ricochet::linear>(scene.elastic))
    return solve_automatic_linear(scene, tolerance);
  if (std::holds_alternative<ricochet::coulomb_with_peeling>(scene.tangential))
    return solve_automatic_peeling(scene, tolerance);
  if (std::holds_alternative<ricochet::mindlin>(scene.tangential))
    return solve_automatic_stick_slip(scene, tolerance);
  if (std::holds_alternative<ricochet::maugis_barquins>(scene.crack))
    return solve_automatic_power_law(scene, tolerance);
  if (std::holds_alternative<ricochet::hunt_crossley>(scene.damping) ||
      std::holds_alternative<ricochet::tsuji>(scene.damping))
    return solve_automatic_more(scene, tolerance);
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
