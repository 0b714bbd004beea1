#pragma once
#include <ricochet/law/end.hpp>
#include <ricochet/model/composable.hpp>
#include <ricochet/model/contact_model.hpp>

namespace ricochet {

namespace detail {

template <class L>
consteval bool diagnose() {
  static_assert(has_role<L>,
                "every argument of compose() after the pair must be a law or a request: it needs `using role = ...`");
  if constexpr (plays<L, role::elastic> || plays<L, role::adhesion> || plays<L, role::crack> ||
                plays<L, role::damping> || plays<L, role::tangential> || plays<L, role::plasticity>)
    static_assert(any_law<L>, "a law needs `template <class S> using in = ...`, its form in the number system S, and "
                              "`static constexpr auto parameters()` (law/role.hpp)");
  if constexpr (plays<L, role::elastic>)
    static_assert(elastic_law<L>, "elastic law: force, stored_energy, energy_release_rate or load_free_approach is "
                                  "missing or returns another type (law/elastic/elastic_law.hpp)");
  if constexpr (plays<L, role::adhesion>)
    static_assert(adhesion_law<L> || attraction_law<L> || cohesive_law<L>,
                  "adhesion law: work_of_adhesion, surface_energy, flattening, touch_radius, fold_radius, "
                  "contact_radius, pull_off_force or exit_energy is missing or returns another type "
                  "(law/adhesion/adhesion_law.hpp); or, of a force without an edge, attraction, potential_energy, "
                  "or equivalent_work_of_adhesion (law/adhesion/attraction_law.hpp); or, of a force "
                  "with a range, branch too (law/adhesion/cohesive_law.hpp)");
  if constexpr (attraction_law<L> && requires { &L::rebound_damping; })
    static_assert(rebound_opposing_law<L>, "attraction law: rebound_damping(pair, configuration) returns another type "
                                           "(law/adhesion/attraction_law.hpp)");
  if constexpr (plays<L, role::crack>)
    static_assert(crack_velocity_law<L>, "crack-velocity law: joints, speed_scale, first_ratio or rate is "
                                         "missing or returns another type (law/crack/crack_velocity_law.hpp)");
  if constexpr (plays<L, role::damping>)
    static_assert(bulk_damping_law<L>,
                  "bulk damping law: coefficient(pair, configuration) is missing or returns another "
                  "type (law/damping/bulk_damping_law.hpp)");
  if constexpr (plays<L, role::tangential>)
    static_assert(tangential_law<L>, "tangential law: sliding_force(elastic_force) is missing or returns another type; "
                                     "or, of a contact that sticks and slips, stiffness or largest_stretch "
                                     "(law/tangential/tangential_law.hpp)");
  if constexpr (plays<L, role::plasticity>)
    static_assert(plasticity_law<L> || flowing_law<L>,
                  "plasticity law: loss(pair, speed) is missing or returns another type "
                  "(law/plasticity/plasticity_law.hpp); or, of one within the motion, yield_strength, yield_radius, "
                  "shape, lost_force or least_strength (law/plasticity/flowing_law.hpp)");
  return true;
}

/// The law of this role among the arguments, or the fallback.
template <class Role, class Fallback, class First, class... Rest>
constexpr auto pick(const Fallback& fallback, const First& first, const Rest&... rest) {
  if constexpr (plays<First, Role>)
    return first;
  else if constexpr (sizeof...(Rest) == 0)
    return fallback;
  else
    return pick<Role>(fallback, rest...);
}

template <class Request, class... Arguments>
inline constexpr bool names = (std::same_as<Request, Arguments> || ...);

/// Instantiates a law's formulas on Boost.Units quantities, without ever calling them: a wrong exponent in the law of a
/// user does not compile either.
template <class Law>
void check_dimensions() {
  using pair = const contact_pair&;
  using part = const configuration<dimensional>&;
  if constexpr (plays<Law, role::elastic>)
    (void)[](const Law& law, pair p, part c) {
      (void)force(law.force(p, c));
      (void)energy(law.stored_energy(p, c));
      (void)energy_per_area(law.energy_release_rate(p, c));
      (void)length(law.load_free_approach(p, c.radius));
      (void)double(law.load_free_slope(p, c.radius));
    };
  else if constexpr (attraction_law<Law>)
    (void)[](const Law& law, pair p, part c) {
      (void)force(law.attraction(p, c));
      (void)energy(law.potential_energy(p, c));
      (void)energy_per_area(law.equivalent_work_of_adhesion(p));
      if constexpr (rebound_opposing_law<Law>)
        (void)damping(law.rebound_damping(p, c));
    };
  else if constexpr (cohesive_law<Law>)
    (void)[](const Law& law, pair p, const cohesive_configuration<dimensional>& c) {
      (void)force(law.attraction(p, c));
      (void)energy(law.potential_energy(p, c));
      (void)energy_per_area(law.equivalent_work_of_adhesion(p));
      (void)length(law.branch(p, c.radius).at(1.0, true).slope);
    };
  else if constexpr (plays<Law, role::adhesion>)
    (void)[](const Law& law, pair p, part c) {
      (void)energy_per_area(law.work_of_adhesion);
      (void)energy(law.surface_energy(c.radius));
      (void)root_length(law.flattening(p));
      (void)length(law.touch_radius(p) + law.fold_radius(p) + law.contact_radius(p, c.approach));
      (void)force(law.pull_off_force(p));
      (void)energy(law.exit_energy(p));
    };
  else if constexpr (plays<Law, role::crack>)
    (void)[](const Law& law, pair p, energy_per_area w) { (void)speed(law.speed_scale(p, w)); };
  else if constexpr (plays<Law, role::damping>)
    (void)[](const Law& law, pair p, part c) { (void)damping(law.coefficient(p, c)); };
  else if constexpr (stick_slip_law<Law>)
    (void)[](const Law& law, pair p, part c) {
      (void)modulus(law.stiffness(p));
      (void)length(law.largest_stretch(c.approach));
    };
  else if constexpr (plays<Law, role::tangential>)
    (void)[](const Law& law, pair p, force f) {
      (void)force(law.sliding_force(f));
      if constexpr (peeling_law<Law>)
        (void)force(law.edge_resistance(p, 1.0 / speed{}, speed{}));
    };
  else if constexpr (flowing_law<Law>)
    (void)[](const Law& law, pair p, flattened_configuration<dimensional>& c, root_length flattening) {
      c.take(p, law.shape(p, flattening, law.yield_radius(p, flattening), c.radius));
      (void)force(law.lost_force(c));
      (void)modulus(law.least_strength(p, flattening) + law.yield_strength);
    };
}

template <class Law>
void admit(Law& law) {
  if constexpr (is_present<Law>)
    check_dimensions<Law>();
  if constexpr (requires { Law::parameters(); })
    validate_law(law);
  if constexpr (requires { law.validate(); })
    law.validate();
  if constexpr (requires { law.tabulate(); })
    law.tabulate();
}

} // namespace detail

namespace detail {
/// \throws bad_input where the contact would yield while adhesion draws it together.
template <class Adhesion, class Flow>
void admit_flow(const contact_pair& pair, const Adhesion& adhesion, const Flow& law) {
  if constexpr (adhesion_law<Adhesion> && flowing_law<Flow>) {
    const modulus least = law.least_strength(pair, adhesion.flattening(pair));
    if (law.yield_strength < least)
      throw bad_input("yield_strength = " + shown(in_si(law.yield_strength)) + " Pa is below " + shown(in_si(least)) +
                      " Pa: the contact would yield while adhesion draws it together, where this law creates energy");
  }
}

/// \throws bad_input where a contact with a peeling moment is not that of a sphere on a flat wall.
template <class Tangential>
void admit_bodies(const contact_pair& pair, const Tangential&) {
  if constexpr (peeling_law<Tangential>)
    if (const double r = in_si(pair.bodies.radius_2); !std::isinf(r))
      throw bad_input("radius of the second body = " + shown(r) +
                      " m is not that of a flat wall: the peeling moment is for a sphere on one");
}
} // namespace detail

/// A contact model of exactly the physics named, in any order; laws' parameters are validated and tables made here.
/// \throws bad_input naming quantity, value and range. An illegal composition does not compile; its static_assert is
/// one sentence.
template <class... Arguments>
auto compose(const contact_pair& pair, const Arguments&... arguments) {
  static_assert((detail::diagnose<Arguments>() && ...));
  constexpr role_count n = count_roles<Arguments...>();
  static_assert(n.elastic != 0, "a contact model needs an elastic law: add hertz");
  static_assert(n.elastic < 2, "two elastic laws were given: keep one");
  static_assert(n.adhesion < 2, "two adhesion laws were given: keep one");
  static_assert(n.crack < 2, "two crack-velocity laws were given: keep one");
  static_assert(n.damping < 2, "two bulk damping laws were given: keep one");
  static_assert(n.tangential < 2, "two tangential laws were given: keep one");
  static_assert(n.plasticity < 2, "two plasticity laws were given: keep one");
  static_assert(n.plasticity == 0 || n.tangential == 0,
                "plastic flow is added to the normal motion only: drop the tangential law or the plasticity law");
  static_assert(
      n.flow == 0 || n.crack == 0,
      "plastic flow within the motion goes with a static edge: drop the crack-velocity law or take thornton_ning");
  static_assert(
      n.cohesion == 0 || n.tangential == 0,
      "a contact with a cohesive zone moves along its normal only: drop the tangential law or take jkr or dmt");
  static_assert(
      n.flow == 0 || n.attraction + n.cohesion == 0,
      "plastic flow within the motion goes with an adhesion law with a surface energy: take jkr or thornton_ning");
  static_assert(n.stick_slip == 0 || n.adhesion == n.attraction,
                "a tangential law with stick and slip needs a Hertzian contact: drop the adhesion law or take coulomb");
  static_assert(n.peeling == 0 || n.rebounding != 0,
                "a peeling moment needs an adhesion law with a rebound coefficient: add line_force or take coulomb");
  static_assert(n.end < 2, "two end conditions were given: keep one");
  static_assert(n.crack == 0 || n.adhesion != n.attraction + n.cohesion,
                "a crack-velocity law needs an adhesion law with a surface energy: add jkr");
  static_assert(
      n.edgeless == 0 || n.adhesion == n.attraction,
      "an adhesion law with a surface energy needs an elastic law with an edge: take hertz, or dmt or line_force");
  static_assert(n.edgeless == 0 || n.stick_slip == 0,
                "stick and slip is that of a Hertzian contact: take hertz or coulomb");
  static_assert(n.edgeless == 0 || n.plasticity == 0,
                "plastic flow is added to Hertzian contacts only: drop the plasticity law or take hertz");
  static_assert(
      n.end == 0 || n.adhesion == 0,
      "an end condition is only for contacts without adhesion: with adhesion the contact lets go where it tears");
  if constexpr (composable<Arguments...>) {
    validate(pair);
    auto elastic = detail::pick<role::elastic>(absent<role::elastic>{}, arguments...);
    auto adhesion = detail::pick<role::adhesion>(absent<role::adhesion>{}, arguments...);
    auto crack = detail::pick<role::crack>(absent<role::crack>{}, arguments...);
    auto damping = detail::pick<role::damping>(absent<role::damping>{}, arguments...);
    auto tangential = detail::pick<role::tangential>(absent<role::tangential>{}, arguments...);
    auto plasticity = detail::pick<role::plasticity>(absent<role::plasticity>{}, arguments...);
    // Pulled by a force without an edge, a contact lets go where its overlap vanishes.
    using end_by_default = std::conditional_t<n.attraction != 0, end_at_zero_overlap, end_at_zero_force>;
    const auto end = detail::pick<role::end>(end_by_default{}, arguments...);
    detail::admit(elastic);
    detail::admit(adhesion);
    detail::admit(crack);
    detail::admit(damping);
    detail::admit(tangential);
    detail::admit(plasticity);
    if constexpr (requires { adhesion.validate(pair); })
      adhesion.validate(pair);
    detail::admit_flow(pair, adhesion, plasticity);
    detail::admit_bodies(pair, tangential);
    constexpr requests asked{.ledger = detail::names<energy_ledger, Arguments...>,
                             .duration = detail::names<contact_duration, Arguments...>,
                             .extremes = detail::names<extremes, Arguments...>,
                             .trajectory = detail::names<trajectory, Arguments...>,
                             .warnings = detail::names<regime_warnings, Arguments...>};
    return contact_model<decltype(elastic), decltype(adhesion), decltype(crack), decltype(damping),
                         decltype(tangential), decltype(plasticity), std::remove_const_t<decltype(end)>, asked>{
        pair, elastic, adhesion, crack, damping, tangential, plasticity};
  }
}

} // namespace ricochet
