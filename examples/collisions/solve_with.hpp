// The composition of a scene's laws: walks the roles once and composes what is there. Coulomb's friction is in every
// model, with a coefficient of zero where the scene has none: it then changes nothing, and only half the models are to
// be compiled. Models with stick and slip are compiled for one stepper only. The loss of plastic flow is added to the
// outcome, so that it needs no model of its own.
#pragma once
#include "solve.hpp"

#include <ricochet/model/compose.hpp>
#include <ricochet/solve/oblique.hpp>

#include <stdexcept>
#include <tuple>

namespace collisions {

template <class Law>
constexpr auto if_present(const Law& law) {
  if constexpr (std::is_same_v<Law, no_law>)
    return std::tuple{};
  else
    return std::tuple{law};
}

/// Laws of bulk damping of which one file compiles the models.
template <class... Damping>
struct damped_by {};
using all_damping = damped_by<no_law, ricochet::kuwabara_kono, ricochet::hunt_crossley, ricochet::tsuji>;

/// \throws ricochet::bad_input for a scene with another tangential law, std::logic_error for laws that do not go
/// together or for damping compiled elsewhere.
template <class Stepper, class Tangential, class... Damping>
outcome solve_with(const scene& scene, double tolerance, damped_by<Damping...>) {
  const auto* friction = std::get_if<Tangential>(&scene.tangential);
  if (!friction && !std::holds_alternative<no_law>(scene.tangential))
    throw ricochet::bad_input("mindlin goes with the automatic stepper only");
  const auto solve_composed = [&]<class... Laws>(const Laws&... laws) -> outcome {
    if constexpr (ricochet::composable<Laws..., Tangential>) {
      const auto model =
          ricochet::compose(scene.pair, laws..., friction ? *friction : Tangential{}, ricochet::energy_ledger{},
                            ricochet::contact_duration{}, ricochet::extremes{}, ricochet::regime_warnings{});
      const auto out = ricochet::collide(
          model,
          ricochet::oblique_impact{
              .speed = scene.speed, .angle = scene.angle, .spin_1 = scene.spin_1, .spin_2 = scene.spin_2},
          {.tolerance = tolerance}, Stepper{});
      outcome all{out.normal, std::nullopt, std::nullopt};
      if (friction)
        all.friction = {out.tangential_speed, out.spin_1,     out.spin_2,        out.tangential_restitution,
                        out.rebound_angle,    out.rolls,      out.impulse_ratio, out.friction_loss,
                        out.rotation_1,       out.rotation_2, out.normal_turn};
      return all;
    } else {
      throw std::logic_error("laws that do not go together");
    }
  };
  const auto solve_damped = [&]<class Law>(const Law& damping) -> outcome {
    if constexpr ((std::is_same_v<Law, Damping> || ...))
      return std::visit(
          [&](const auto&... roles) {
            return std::apply(solve_composed, std::tuple_cat(if_present(damping), if_present(roles)...));
          },
          scene.elastic, scene.adhesion, scene.crack, scene.end);
    else
      throw std::logic_error("a damping law that is compiled elsewhere");
  };
  outcome out = std::visit(solve_damped, scene.damping);
  if (const auto* plastic = std::get_if<ricochet::thornton_ning>(&scene.plasticity)) {
    out.plastic_loss = plastic->loss(scene.pair, scene.speed);
    ricochet::add_plastic_loss(out, *out.plastic_loss);
  }
  return out;
}

} // namespace collisions
