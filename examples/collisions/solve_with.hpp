// The composition of a scene's laws: walks the roles once and composes what is there. Coulomb's friction is in nearly
// every model, with a coefficient of zero where the scene has none: it then changes nothing, and only half the models
// are to be compiled. Models with laws beyond the usual ones are compiled for one stepper only. The loss of
// thornton_ning is added to the outcome, so that it needs no model of its own.
#pragma once
#include "solve.hpp"

#include <ricochet/model/compose.hpp>
#include <ricochet/solve/oblique/oblique.hpp>

#include <stdexcept>
#include <tuple>

namespace collisions {

/// The laws of which one file compiles the models, those of Hertzian contacts that slide or roll. A file that compiles
/// others says which. A tangential or plasticity law is in all of its models.
struct usual_laws {
  using elastic = std::variant<ricochet::hertz>;
  using adhesion = std::variant<no_law, ricochet::jkr, ricochet::line_force, ricochet::dmt>;
  using crack = std::variant<no_law, ricochet::greenwood, ricochet::greenwood_fit>;
  using damping = std::variant<no_law, ricochet::kuwabara_kono, ricochet::hunt_crossley, ricochet::tsuji>;
  using tangential = ricochet::coulomb;
  using plasticity = no_law;
  using end = std::variant<no_law, ricochet::end_at_zero_overlap>;
};

/// \throws std::logic_error where the law is not one of the few.
template <class Few, class... All>
Few one_of(const std::variant<All...>& law) {
  return std::visit(
      []<class Law>(const Law& held) -> Few {
        if constexpr (std::is_constructible_v<Few, std::in_place_type_t<Law>, const Law&>)
          return Few(std::in_place_type<Law>, held);
        else
          throw std::logic_error("a law whose models are compiled elsewhere");
      },
      law);
}

template <class Law>
constexpr auto if_present(const Law& law) {
  if constexpr (std::is_same_v<Law, no_law>)
    return std::tuple{};
  else
    return std::tuple{law};
}

/// This law of the scene; where it has none, one whose parameters are zero.
template <class Law, class... All>
Law or_idle(const std::variant<All...>& law) {
  const Law* held = std::get_if<Law>(&law);
  return held ? *held : Law{};
}

/// What all models report of the motion along the normal.
template <class Outcome>
normal_outcome along_normal(const Outcome& found) {
  normal_outcome out;
  static_cast<ricochet::ending_result<double>&>(out) = found;
  static_cast<ricochet::ledger_result<double>&>(out) = found;
  static_cast<ricochet::duration_result<ricochet::duration>&>(out) = found;
  static_cast<ricochet::extremes_result<ricochet::length, ricochet::force>&>(out) = found;
  static_cast<ricochet::warnings_result&>(out) = found;
  return out;
}

template <class Outcome>
friction_outcome along_surface(const Outcome& found) {
  friction_outcome out{found.tangential_speed, found.spin_1,     found.spin_2,        found.tangential_restitution,
                       found.rebound_angle,    found.rolls,      found.impulse_ratio, found.friction_loss,
                       found.rotation_1,       found.rotation_2, found.normal_turn,   std::nullopt};
  if constexpr (requires { found.peeling_loss; })
    out.peeling_loss = found.peeling_loss;
  return out;
}

template <class Stepper, class... Laws>
outcome solve_composed(const scene& scene, double tolerance, const Laws&... laws) {
  const auto model = ricochet::compose(scene.pair, laws..., ricochet::energy_ledger{}, ricochet::contact_duration{},
                                       ricochet::extremes{}, ricochet::regime_warnings{});
  using model_type = std::remove_const_t<decltype(model)>;
  if constexpr (model_type::has_friction) {
    const auto found = ricochet::collide(
        model,
        ricochet::oblique_impact{
            .speed = scene.speed, .angle = scene.angle, .spin_1 = scene.spin_1, .spin_2 = scene.spin_2},
        {.tolerance = tolerance}, Stepper{});
    outcome all{along_normal(found.normal), std::nullopt, std::nullopt};
    if (!std::holds_alternative<no_law>(scene.tangential))
      all.friction = along_surface(found);
    return all;
  } else {
    const auto found = ricochet::collide(model, ricochet::impact{scene.speed}, {.tolerance = tolerance}, Stepper{});
    outcome all{along_normal(found), std::nullopt, std::nullopt};
    if constexpr (model_type::flows)
      all.plastic_loss = found.plastic_loss;
    return all;
  }
}

/// \throws std::logic_error for laws that do not go together, or of which this file does not compile the models.
template <class Stepper, class Laws = usual_laws>
outcome solve_with(const scene& scene, double tolerance) {
  const auto tangential = or_idle<typename Laws::tangential>(scene.tangential);
  const auto plasticity = or_idle<typename Laws::plasticity>(scene.plasticity);
  const auto solve_if_composable = [&]<class... Roles>(const Roles&... roles) -> outcome {
    if constexpr (ricochet::composable<Roles...>)
      return solve_composed<Stepper>(scene, tolerance, roles...);
    else
      throw std::logic_error("laws that do not go together");
  };
  outcome out = std::visit(
      [&](const auto&... roles) {
        return std::apply(solve_if_composable,
                          std::tuple_cat(if_present(roles)..., if_present(tangential), if_present(plasticity)));
      },
      one_of<typename Laws::elastic>(scene.elastic), one_of<typename Laws::adhesion>(scene.adhesion),
      one_of<typename Laws::crack>(scene.crack), one_of<typename Laws::damping>(scene.damping),
      one_of<typename Laws::end>(scene.end));
  if (const auto* plastic = std::get_if<ricochet::thornton_ning>(&scene.plasticity)) {
    out.plastic_loss = plastic->loss(scene.pair, scene.speed);
    ricochet::add_plastic_loss(out, *out.plastic_loss);
  }
  return out;
}

/// With the models that every stepper has. \throws ricochet::bad_input for a law that needs others.
template <class Stepper>
outcome solve_usual(const scene& scene, double tolerance) {
  const auto refuse = [](bool given, const char* law) {
    if (given)
      throw ricochet::bad_input(std::string(law) + " goes with the automatic stepper only");
  };
  refuse(std::holds_alternative<ricochet::linear>(scene.elastic), "linear");
  refuse(std::holds_alternative<ricochet::maugis_dugdale>(scene.adhesion), "maugis_dugdale");
  refuse(std::holds_alternative<ricochet::maugis_barquins>(scene.crack), "maugis_barquins");
  refuse(std::holds_alternative<ricochet::mindlin>(scene.tangential), "mindlin");
  refuse(std::holds_alternative<ricochet::coulomb_with_peeling>(scene.tangential), "coulomb_with_peeling");
  refuse(std::holds_alternative<ricochet::thornton_ning_contact>(scene.plasticity), "thornton_ning_contact");
  return solve_with<Stepper>(scene, tolerance);
}

} // namespace collisions
