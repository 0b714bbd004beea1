// The models whose adhesion has a range of its own.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using adhesion = std::variant<ricochet::maugis_dugdale>;
  using crack = std::variant<no_law>;
  using tangential = no_law;
  using end = std::variant<no_law>;
};
} // namespace

outcome solve_automatic_cohesive(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
