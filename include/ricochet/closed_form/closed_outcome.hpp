#pragma once
#include <ricochet/closed_form/hunt_crossley.hpp>
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/linear.hpp>
#include <ricochet/closed_form/tsuji.hpp>
#include <ricochet/closed_form/viscoelastic_hertz.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/contact_model.hpp>
#include <ricochet/outcome/outcome.hpp>

namespace ricochet::closed_form {

namespace detail {
template <class Model>
struct is_solved : std::false_type {};
template <requests Asked>
inline constexpr bool asks_outcome_only = !Asked.ledger && !Asked.duration && !Asked.extremes && !Asked.trajectory;
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, absent<role::damping>,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<!Asked.ledger && !Asked.extremes && !Asked.trajectory> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, jkr, absent<role::crack>, absent<role::damping>, absent<role::tangential>,
                               absent<role::plasticity>, End, Asked>> : std::bool_constant<asks_outcome_only<Asked>> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, hunt_crossley,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<asks_outcome_only<Asked>> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, tsuji, absent<role::tangential>,
                               absent<role::plasticity>, End, Asked>> : std::bool_constant<asks_outcome_only<Asked>> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, kuwabara_kono,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<asks_outcome_only<Asked>> {};
template <class Damping, class End, requests Asked>
requires(!is_present<Damping> || std::same_as<Damping, linear_dashpot>) //
    struct is_solved<contact_model<linear, absent<role::adhesion>, absent<role::crack>, Damping,
                                   absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<!Asked.ledger && !Asked.extremes && !Asked.trajectory &&
                         (!Asked.duration || std::same_as<End, end_at_zero_force>)> {
};
} // namespace detail

/// A model whose outcome, as far as it is asked for, needs no integration.
template <class Model>
concept solved = detail::is_solved<Model>::value;

/// Outcome of an impact at speed v from the closed forms; its error is that of round-off. None where the damping number
/// of Kuwabara and Kono's damping is beyond its closed form.
template <solved Model>
std::optional<outcome_of<Model>> solve(const Model& model, speed v) {
  constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
  constexpr bool to_zero_overlap = std::same_as<typename Model::end_condition, end_at_zero_overlap>;
  outcome_of<Model> out;
  double conditioning = 1; // of e with respect to its arguments
  if constexpr (std::same_as<decltype(Model::elastic), linear>) {
    linear_dashpot dashpot{};
    if constexpr (Model::damped)
      dashpot = model.damping;
    const linear_impact impact(model.pair, model.elastic, dashpot);
    if constexpr (to_zero_overlap)
      out.restitution = impact.restitution_to_zero_overlap();
    else
      out.restitution = impact.restitution_to_zero_force();
    if constexpr (Model::asked.duration)
      out.contact_duration = impact.contact_duration_to_zero_force();
  } else if constexpr (Model::adhesive) {
    const energy_per_area w = model.adhesion.work_of_adhesion;
    const double ratio = sticking_speed(model.pair, w) / v;
    out.restitution = restitution(model.pair, w, v);
    conditioning = square(ratio) / std::max(out.restitution.value_or(1), std::sqrt(round_off));
    out.ending_is_certain = std::abs(ratio - 1) > round_off;
  } else if constexpr (!Model::damped) {
    out.restitution = 1;
    if constexpr (Model::asked.duration)
      out.contact_duration = contact_time(model.pair, v);
  } else if constexpr (std::same_as<decltype(Model::damping), kuwabara_kono>) {
    const double y = damping_number(model.pair, model.damping.bulk_time, v);
    if (y > (to_zero_overlap ? largest_damping_number_to_zero_overlap : largest_damping_number_to_zero_force))
      return std::nullopt;
    out.restitution =
        to_zero_overlap ? viscoelastic_restitution_to_zero_overlap(y) : viscoelastic_restitution_to_zero_force(y);
  } else if constexpr (std::same_as<decltype(Model::damping), hunt_crossley>) {
    out.restitution = restitution(model.damping.damping_coefficient, v);
  } else {
    const double alpha = model.damping.damping_coefficient;
    if constexpr (to_zero_overlap)
      out.restitution = restitution_to_zero_overlap(alpha);
    else
      out.restitution = restitution_to_zero_force(alpha);
  }
  out.ending = out.restitution ? ending::separated : ending::captured;
  out.error_estimate = out.restitution ? round_off * (1 + conditioning) : 0;
  return out;
}

} // namespace ricochet::closed_form
