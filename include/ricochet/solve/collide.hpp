#pragma once
#include <ricochet/closed_form/closed_outcome.hpp>
#include <ricochet/model/regime.hpp>
#include <ricochet/solve/accuracy.hpp>
#include <ricochet/solve/edge/fast_edge.hpp>
#include <ricochet/solve/stepper/automatic.hpp>
#include <ricochet/solve/yielding.hpp>

namespace ricochet {

/// An impact as the contact sees it. speed: of approach at first touch, > 0. slip: speed at which the contact point
/// slides then, >= 0; needs a tangential law. spin: of a sphere with a peeling moment, which alone makes it matter; > 0
/// where it would roll along the slip. oblique.hpp has impacts by angle, velocity and spin.
struct impact {
  ricochet::speed speed;
  ricochet::speed slip{};
  angular_speed spin{};
};

template <class Stepper = stepper::automatic, class Model>
auto integrate(const Model& model, const impact& impact, const collide_options& options = {}, Stepper = {});

namespace detail {

template <class Model>
outcome_of<Model> in_si_units(const reduced_outcome_of<double, Model>& numbers, const scales& unit) {
  outcome_of<Model> out;
  static_cast<ending_result<double>&>(out) = numbers;
  if constexpr (Model::asked.ledger)
    static_cast<ledger_result<double>&>(out) = numbers;
  if constexpr (Model::asked.duration)
    out.contact_duration = numbers.contact_duration * unit.duration * units::seconds;
  if constexpr (Model::asked.extremes) {
    const double newton = unit.factor(force{});
    out.max_approach = numbers.max_approach * unit.length * units::metres;
    out.max_contact_radius = numbers.max_contact_radius * unit.length * units::metres;
    out.max_tension = numbers.max_tension * newton * units::newtons;
    out.max_compression = numbers.max_compression * newton * units::newtons;
  }
  if constexpr (Model::flows) {
    out.plastic_loss = numbers.plastic_loss;
    out.residual_approach = numbers.residual_approach * unit.length * units::metres;
  }
  if constexpr (Model::has_friction) {
    const double metre_per_second = unit.length / unit.duration;
    out.slip = numbers.slip * metre_per_second * units::metres_per_second;
    out.slip_error_estimate = numbers.slip_error_estimate;
    out.sticks = numbers.sticks;
    out.slip_distance = numbers.slip_distance * unit.length * units::metres;
    out.elapsed_time = numbers.elapsed_time * unit.duration * units::seconds;
    out.approach_rate = numbers.approach_rate * metre_per_second * units::metres_per_second;
  }
  if constexpr (Model::peels) {
    out.spin = numbers.spin / unit.duration * units::radians_per_second;
    out.rotation = numbers.rotation;
    out.friction_loss = numbers.friction_loss;
    out.peeling_loss = numbers.peeling_loss;
  }
  if constexpr (Model::asked.trajectory) {
    out.trajectory = numbers.trajectory;
    const auto scale = [](std::vector<double>& column, double factor) {
      for (double& x : column)
        x *= factor;
    };
    const double newton = unit.factor(force{}), joule = unit.factor(energy{});
    auto& t = out.trajectory;
    scale(t.time, unit.duration);
    scale(t.mutual_approach, unit.length);
    scale(t.approach_rate, unit.length / unit.duration);
    scale(t.contact_radius, unit.length);
    scale(t.elastic_force, newton);
    scale(t.damping_force, newton);
    for (auto* column : {&t.kinetic_energy, &t.elastic_energy, &t.surface_energy, &t.crack_loss, &t.bulk_loss})
      scale(*column, joule);
    if constexpr (Model::flows)
      scale(t.plastic_loss, joule);
  }
  return out;
}

/// An edge of infinite speed, or of no energy, is a static one.
template <class Model>
bool edge_is_static(const Model& model) {
  if constexpr (requires { model.crack.relaxation_time; })
    if (in_si(model.crack.relaxation_time) == 0)
      return true;
  return in_si(model.adhesion.work_of_adhesion) == 0;
}

/// Energy, in units of the kinetic one, by which a free edge and a static one can differ in what they take at most. By
/// its law's range alone: of G over twice the area of the deepest contact, whatever the edge's speed.
struct loss_of_edge {
  double most = std::numeric_limits<double>::infinity();
  bool by_range_alone = false;
};
template <class Model>
loss_of_edge loss_of_free_edge(const Model& model, speed v) {
  const scales unit = scales_at(model, v);
  const reduced_model<double, Model> numbers(model, unit);
  const double kinetic = numbers.kinetic_energy(reduce<double>(v, unit));
  const fast_edge edge(numbers);
  if (edge.lag() < 1e-3)
    return {edge.loss(numbers) / kinetic, false};
  if constexpr (limited_crack_law<decltype(Model::crack)>) {
    const double radius = reduce<double>(closed_form::max_contact_radius(model.pair, v), unit) +
                          numbers.adhesion.equilibrium_radius(numbers.pair);
    return {2 * pi<double>() * square(radius) * numbers.adhesion.work_of_adhesion * numbers.crack.highest_ratio() /
                kinetic,
            true};
  }
  return {};
}

/// Outcome with the static edge where a free one differs from it by less than the tolerance: the closer it is, the
/// harder to integrate. None if that does not tell the outcome.
template <class Model, class Stepper>
std::optional<outcome_of<Model>> with_edge_as_static(const Model& model, const impact& impact,
                                                     const collide_options& options, Stepper stepper) {
  const loss_of_edge loss = loss_of_free_edge(model, impact.speed);
  if (!(loss.most < options.tolerance))
    return std::nullopt;
  const collide_options closer{.tolerance = std::max(options.tolerance / 2, tolerance_range.low),
                               .max_evaluations = options.max_evaluations};
  const auto held = model.with_static_edge();
  outcome_of<Model> out = integrate(held, impact, closer, stepper);
  if (out.restitution) {
    out.error_estimate += loss.most / *out.restitution;
    if constexpr (Model::damped && limited_crack_law<decltype(Model::crack)>)
      if (loss.by_range_alone) { // the bulk's loss goes with the radius, which is between those of held edges
        auto at_limit = held;
        for (const double ratio : {model.crack.lowest_ratio(), model.crack.highest_ratio()}) {
          at_limit.adhesion.work_of_adhesion = ratio * model.adhesion.work_of_adhesion;
          const outcome_of<Model> other = integrate(at_limit, impact, closer, stepper);
          out.error_estimate += std::abs(other.restitution.value_or(0) - *out.restitution);
          out.evaluations += other.evaluations;
        }
      }
  }
  const bool tells = out.ending_is_certain && out.error_estimate <= options.tolerance &&
                     !(out.restitution && *out.restitution < 2 * out.error_estimate);
  return tells ? std::optional(std::move(out)) : std::nullopt;
}

/// The outcome, with warnings where the model asks for them.
template <class Model>
outcome_of<Model> warned(const Model& model, speed v, outcome_of<Model> out) {
  if constexpr (Model::asked.warnings)
    out.warnings = regime_of(model, v).warnings();
  return out;
}

inline void admit(const collide_options& options) {
  require("tolerance", options.tolerance, tolerance_range);
  require("max_evaluations", double(options.max_evaluations), range{.low = 1});
}

template <class Model>
void admit(const impact& impact) {
  require("speed", impact.speed, positive);
  require("slip", impact.slip, non_negative);
  if (!Model::has_friction && in_si(impact.slip) != 0)
    throw bad_input("slip = " + shown(in_si(impact.slip)) + " m/s needs a tangential law in the model: add coulomb");
  require("spin", impact.spin, any_finite);
  if (!Model::peels && in_si(impact.spin) != 0)
    throw bad_input("spin = " + shown(in_si(impact.spin)) +
                    " rad/s needs a peeling moment in the model: without one, the slip says all");
}

} // namespace detail

/// What comes of this impact: ending, restitution and what compose() was asked for, by integration with the given
/// stepper (solve/stepper/stepper.hpp), stepper::automatic unless another is wanted.
/// \throws bad_input if speed is not positive and finite, the tolerance is outside [1e-12, 1e-1], or max_evaluations is
/// below 1.
template <class Stepper, class Model>
auto integrate(const Model& model, const impact& impact, const collide_options& options, Stepper) {
  detail::admit(options);
  detail::admit<Model>(impact);
  if constexpr (Model::yields)
    return detail::warned(model, impact.speed,
                          detail::with_plastic_loss(model, impact.speed, options, [&](const collide_options& how) {
                            return integrate(model.without_plasticity(), impact, how, Stepper{});
                          }));
  else {
    if constexpr (Model::has_crack_law)
      if (detail::edge_is_static(model))
        return detail::warned<Model>(model, impact.speed,
                                     integrate(model.with_static_edge(), impact, options, Stepper{}));
    if constexpr (requires { model.crack.relaxation_time; } && !Model::has_friction) // of the slip it tells no error
      if (auto out = detail::with_edge_as_static(model, impact, options, Stepper{}))
        return detail::warned<Model>(model, impact.speed, std::move(*out));
    const scales unit = scales_at(model, impact.speed);
    const reduced_model<double, Model> numbers(model, unit);
    const auto found = detail::solve_to_tolerance<Stepper>(numbers, reduce<double>(impact.speed, unit),
                                                           reduce<double>(impact.slip, unit),
                                                           reduce<double>(impact.spin, unit), options);
    return detail::warned(model, impact.speed, detail::in_si_units<Model>(found, unit));
  }
}

/// What comes of this impact: from the closed form where one gives all that is asked for, else by integrate().
/// \throws bad_input as integrate().
template <class Model>
auto collide(const Model& model, const impact& impact, const collide_options& options = {}) {
  if constexpr (Model::yields) {
    return detail::warned(model, impact.speed,
                          detail::with_plastic_loss(model, impact.speed, options, [&](const collide_options& how) {
                            return collide(model.without_plasticity(), impact, how);
                          }));
  } else if constexpr (closed_form::solved<Model>) {
    detail::admit(options);
    detail::admit<Model>(impact);
    if (auto out = closed_form::solve(model, impact.speed))
      return detail::warned(model, impact.speed, std::move(*out));
    return integrate(model, impact, options);
  } else {
    return integrate(model, impact, options);
  }
}

/// The same with a stepper of the caller's choice; always by integration.
template <class Model, class Stepper>
auto collide(const Model& model, const impact& impact, const collide_options& options, Stepper stepper) {
  return integrate(model, impact, options, stepper);
}

} // namespace ricochet
