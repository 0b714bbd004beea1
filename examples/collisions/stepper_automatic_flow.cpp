// The models with plastic flow within the motion.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using adhesion = std::variant<no_law, ricochet::jkr>;
  using crack = std::variant<no_law>;
  using tangential = no_law;
  using plasticity = ricochet::thornton_ning_contact;
};
} // namespace

outcome solve_automatic_flow(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
