// The models that stepper_automatic.cpp leaves.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using damping = std::variant<ricochet::hunt_crossley, ricochet::tsuji>;
};
} // namespace

outcome solve_automatic_more(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
