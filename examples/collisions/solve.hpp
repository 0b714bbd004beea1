// scene -> outcome, with the stepper chosen at run time.
#pragma once
#include "scene.hpp"

#include <ricochet/outcome/outcome.hpp>
#include <ricochet/units.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace collisions {

using normal_outcome =
    ricochet::basic_outcome<double, ricochet::length, ricochet::duration, ricochet::force, ricochet::speed,
                            ricochet::requests{.ledger = true, .duration = true, .extremes = true, .warnings = true}>;

/// What friction did to the bodies: the members of ricochet::oblique_outcome, of any model.
struct friction_outcome {
  ricochet::speed tangential_speed;
  ricochet::angular_speed spin_1, spin_2;
  std::optional<double> tangential_restitution, rebound_angle; ///< rad
  bool rolls;
  double impulse_ratio, friction_loss, rotation_1, rotation_2, normal_turn;
  std::optional<double> peeling_loss; ///< of a contact that resists rolling
};

/// Of the motion along the normal, and of friction and plastic flow where the scene has a law for them.
struct outcome : normal_outcome {
  std::optional<friction_outcome> friction;
  std::optional<double> plastic_loss;
};

// One for each stepper, compiled in stepper_*.cpp.
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
