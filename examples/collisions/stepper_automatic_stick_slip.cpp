// The models with stick and slip.
#include "solve_with.hpp"

namespace collisions {

namespace {
struct laws : usual_laws {
  using tangential = ricochet::mindlin;
};
} // namespace

outcome solve_automatic_stick_slip(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::automatic, laws>(scene, tolerance);
}

} // namespace collisions
