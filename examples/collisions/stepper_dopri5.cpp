#include "solve_with.hpp"

#include <ricochet/solve/steppers.hpp>

collisions::outcome collisions::solve_dopri5(const scene& scene, double tolerance) {
  return solve_with<ricochet::stepper::dopri5, ricochet::coulomb>(scene, tolerance, all_damping{});
}
