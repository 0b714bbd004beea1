// The models of contacts that resist rolling.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using adhesion = std::variant<ricochet::line_force>;
  using crack = std::variant<no_law>;
  using tangential = ricochet::coulomb_with_peeling;
  using end = std::variant<no_law>;
};
} // namespace

outcome solve_automatic_peeling(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
