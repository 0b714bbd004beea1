#include "solve_with.hpp"

#include <ricochet/solve/stepper/steppers.hpp>

collisions::outcome collisions::solve_dopri5(const scene& scene, double tolerance) {
  return solve_usual<ricochet::stepper::dopri5>(scene, tolerance);
}
