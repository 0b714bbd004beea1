#include "solve_with.hpp"

#include <ricochet/solve/stepper/steppers.hpp>

collisions::outcome collisions::solve_bulirsch_stoer(const scene& scene, double tolerance) {
  return solve_usual<ricochet::stepper::bulirsch_stoer>(scene, tolerance);
}
