#include "solve_with.hpp"

#include <ricochet/solve/steppers.hpp>

collisions::outcome collisions::solve_bulirsch_stoer(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::bulirsch_stoer, ricochet::coulomb>(scene, tolerance, all_damping{});
}
