#pragma once
#include <ricochet/model/contact_model.hpp>
#include <ricochet/outcome/outcome.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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
} // namespace detail

} // namespace ricochet
