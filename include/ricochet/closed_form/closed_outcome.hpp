#pragma once
#include <ricochet/closed_form/hunt_crossley.hpp>
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/linear.hpp>
#include <ricochet/closed_form/tsuji.hpp>
#include <ricochet/closed_form/viscoelastic_hertz.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/reduced_laws.hpp>
#include <ricochet/outcome/outcome.hpp>

namespace ricochet::closed_form {

namespace detail {
template <class Model>
struct is_solved : std::false_type {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, absent<role::damping>,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<!Asked.ledger && !Asked.extremes && !Asked.trajectory> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, dmt, absent<role::crack>, absent<role::damping>, absent<role::tangential>,
                               absent<role::plasticity>, End, Asked>> : std::bool_constant<Asked.outcome_only()> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, jkr, absent<role::crack>, absent<role::damping>, absent<role::tangential>,
                               absent<role::plasticity>, End, Asked>> : std::bool_constant<Asked.outcome_only()> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, hunt_crossley,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<Asked.outcome_only()> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, tsuji, absent<role::tangential>,
                               absent<role::plasticity>, End, Asked>> : std::bool_constant<Asked.outcome_only()> {};
template <class End, requests Asked>
struct is_solved<contact_model<hertz, absent<role::adhesion>, absent<role::crack>, kuwabara_kono,
                               absent<role::tangential>, absent<role::plasticity>, End, Asked>>
    : std::bool_constant<Asked.outcome_only()> {};
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

/// One of which a table of one number tells the outcome.
template <class Model>
concept tabulated = solved<Model> &&
    (std::same_as<decltype(Model::damping), kuwabara_kono> || std::same_as<decltype(Model::damping), hunt_crossley>);

namespace detail {
constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();

template <tabulated Model>
constexpr const restitution_table& table_of() {
  if constexpr (std::same_as<decltype(Model::damping), hunt_crossley>)
    return hunt_crossley_restitution;
  else if constexpr (std::same_as<typename Model::end_condition, end_at_zero_overlap>)
    return viscoelastic_hertz_to_zero_overlap;
  else
    return viscoelastic_hertz_to_zero_force;
}

/// The number, of laws and a speed in SI.
template <class T, tabulated Model>
T table_argument(const reduced_laws<T, Model>& laws, const T& v) {
  if constexpr (std::same_as<decltype(Model::damping), hunt_crossley>)
    return laws.damping.damping_coefficient * v;
  else
    return damping_number(laws.pair, T(laws.damping.bulk_time), v);
}

/// Outcome of a closed form whose restitution's relative error is `conditioning` times that of its arguments.
template <class Model>
outcome_of<Model> closed_outcome(std::optional<double> restitution, double conditioning) {
  outcome_of<Model> out;
  out.restitution = restitution;
  out.ending = restitution ? ending::separated : ending::captured;
  out.error_estimate = restitution ? round_off * (1 + conditioning) : 0;
  return out;
}
} // namespace detail

/// Outcome of an impact at speed v from the closed forms; its error is that of round-off. None where the damping number
/// of Kuwabara and Kono's damping is beyond its closed form.
template <solved Model>
std::optional<outcome_of<Model>> solve(const Model& model, speed v) {
  using detail::closed_outcome;
  constexpr bool to_zero_overlap = std::same_as<typename Model::end_condition, end_at_zero_overlap>;
  if constexpr (tabulated<Model>) {
    constexpr const auto& table = detail::table_of<Model>();
    const double x = detail::table_argument(laws_in_si<double>(model), in_si(v));
    if (x <= table.last)
      return closed_outcome<Model>(table(x), 1);
    if constexpr (std::same_as<decltype(Model::damping), hunt_crossley>)
      return closed_outcome<Model>(restitution(model.damping.damping_coefficient, v), 1);
    else
      return std::nullopt;
  } else if constexpr (std::same_as<decltype(Model::elastic), linear>) {
    linear_dashpot dashpot{};
    if constexpr (Model::damped)
      dashpot = model.damping;
    const linear_impact impact(model.pair, model.elastic, dashpot);
    auto out = closed_outcome<Model>(
        to_zero_overlap ? impact.restitution_to_zero_overlap() : impact.restitution_to_zero_force(), 1);
    if constexpr (Model::asked.duration)
      out.contact_duration = impact.contact_duration_to_zero_force();
    return out;
  } else if constexpr (Model::adhesive) {
    const energy_per_area w = model.adhesion.work_of_adhesion;
    const double ratio = sticking_speed(model.pair, w) / v;
    const auto e = restitution(model.pair, w, v);
    auto out = closed_outcome<Model>(e, square(ratio) / std::max(e.value_or(1), std::sqrt(detail::round_off)));
    out.ending_is_certain = std::abs(ratio - 1) > detail::round_off;
    return out;
  } else if constexpr (!Model::damped) {
    auto out = closed_outcome<Model>(1, 1);
    if constexpr (Model::asked.duration)
      out.contact_duration = contact_time(model.pair, v);
    return out;
  } else {
    const double alpha = model.damping.damping_coefficient;
    return closed_outcome<Model>(
        to_zero_overlap ? restitution_to_zero_overlap(alpha) : restitution_to_zero_force(alpha), 1);
  }
}

} // namespace ricochet::closed_form
