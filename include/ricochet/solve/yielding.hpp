#pragma once
#include <ricochet/solve/accuracy.hpp>

namespace ricochet {

/// Adds the loss of plastic flow, in units of the initial kinetic energy, to the outcome of an elastic motion [Krijt
/// 2013 (30)]: e^2 = e_A^2 - loss, captured where nothing is left.
template <class Outcome>
void add_plastic_loss(Outcome& out, double loss) {
  if constexpr (requires { out.remaining_energy; })
    out.remaining_energy -= loss;
  if (!out.restitution || loss == 0)
    return;
  const double e = *out.restitution, left = e * e - loss;
  const double error = 2 * e * out.error_estimate + 4 * std::numeric_limits<double>::epsilon(); // of left
  out.ending_is_certain = out.ending_is_certain && std::abs(left) > 2 * error;
  if (left > 0) {
    out.restitution = std::sqrt(left);
    out.error_estimate = std::min(error / (2 * *out.restitution), std::sqrt(error));
  } else {
    out.restitution.reset();
    out.ending = ending::captured;
    out.error_estimate = -left < 2 * error ? std::sqrt(error) : 0;
  }
}

namespace detail {
template <class Model>
outcome_of<Model> with_plastic_loss(const Model& model, speed v, const outcome_of<elastic_part<Model>>& elastic) {
  outcome_of<Model> out{elastic};
  out.plastic_loss = model.plasticity.loss(model.pair, v);
  add_plastic_loss(out, out.plastic_loss);
  return out;
}

/// Is the motion known to the tolerance, but not what the loss leaves of it?
template <class Motion, class Outcome>
bool loses_accuracy(const Motion& elastic, const Outcome& out, double tolerance) {
  return elastic.error_estimate <= tolerance && out.error_estimate > tolerance;
}

/// The same of the motion that motion(options) gives; solved again, more closely, where little is left of it.
template <class Model, class Motion>
outcome_of<Model> with_plastic_loss(const Model& model, speed v, const collide_options& options,
                                    const Motion& motion) {
  const auto elastic = motion(options);
  auto out = with_plastic_loss(model, v, elastic);
  if (!loses_accuracy(elastic, out, options.tolerance))
    return out;
  const double part = options.tolerance / out.error_estimate;
  collide_options closer = options;
  closer.tolerance =
      std::max(elastic.error_estimate * part / 2 * (out.ending_is_certain ? 1 : part), tolerance_range.low);
  auto again = with_plastic_loss(model, v, motion(closer));
  again.evaluations += out.evaluations;
  again.rejected_steps += out.rejected_steps;
  return again;
}
} // namespace detail

} // namespace ricochet
