// scene -> outcome, with the stepper chosen at run time.
#pragma once
#include "scene.hpp"

#include <ricochet/outcome/outcome.hpp>
#include <ricochet/units.hpp>

#include <array>
#include <string_view>

namespace collisions {

using outcome = ricochet::basic_outcome<double, ricochet::length, ricochet::duration, ricochet::force, ricochet::speed,
                                        ricochet::requests{.ledger = true, .duration = true, .extremes = true}>;

// One for each stepper, each compiled in a file of its own: stepper_*.cpp.
// \throws ricochet::bad_input where the library refuses the scene.
outcome solve_automatic(const scene& scene, double tolerance);
outcome solve_dopri5(const scene& scene, double tolerance);
outcome solve_bulirsch_stoer(const scene& scene, double tolerance);

struct stepper_choice {
  std::string_view name;
  outcome (*solve)(const scene&, double tolerance);
};
inline constexpr std::array<stepper_choice, 3> steppers{
    {{"automatic", solve_automatic}, {"dopri5", solve_dopri5}, {"bulirsch_stoer", solve_bulirsch_stoer}}};

} // namespace collisions
