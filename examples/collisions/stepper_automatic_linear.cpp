// The models of linear springs.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using elastic = std::variant<ricochet::linear>;
  using adhesion = std::variant<no_law>;
  using crack = std::variant<no_law>;
  using damping = std::variant<no_law, ricochet::linear_dashpot>;
};
} // namespace

outcome solve_automatic_linear(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
