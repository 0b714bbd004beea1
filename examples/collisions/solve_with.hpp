// The composition of a scene's laws: walks the roles once and composes what is there.
#pragma once
#include "solve.hpp"

#include <ricochet/model/compose.hpp>
#include <ricochet/solve/collide.hpp>

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

/// \throws std::logic_error for laws that do not go together, or for damping compiled elsewhere.
template <class Stepper, class... Damping>
outcome solve_with(const scene& scene, double tolerance, damped_by<Damping...>) {
  const auto solve_composed = [&]<class... Laws>(const Laws&... laws) -> outcome {
    if constexpr (ricochet::composable<Laws...>) {
      const auto model = ricochet::compose(scene.pair, laws..., ricochet::energy_ledger{}, ricochet::contact_duration{},
                                           ricochet::extremes{});
      return ricochet::integrate(model, {.speed = scene.speed}, {.tolerance = tolerance}, Stepper{});
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
  return std::visit(solve_damped, scene.damping);
}

} // namespace collisions
