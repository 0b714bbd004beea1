// The models whose edge has no bound of G.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using adhesion = std::variant<ricochet::jkr>;
  using crack = std::variant<ricochet::maugis_barquins>;
  using end = std::variant<no_law>;
};
} // namespace

outcome solve_automatic_power_law(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
