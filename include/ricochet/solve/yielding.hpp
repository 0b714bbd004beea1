#pragma once
#include <ricochet/model/contact_model.hpp>
#include <ricochet/outcome/outcome.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::detail {

/// The outcome of the elastic motion, with the plastic loss added [Krijt 2013 (30)]: e^2 = e_A^2 - loss, captured where
/// nothing is left.
template <class Model>
outcome_of<Model> with_plastic_loss(const Model& model, speed v, const outcome_of<elastic_part<Model>>& elastic) {
  outcome_of<Model> out{elastic};
  out.plastic_loss = model.plasticity.loss(model.pair, v);
  if constexpr (Model::asked.ledger)
    out.remaining_energy -= out.plastic_loss;
  if (!elastic.restitution || out.plastic_loss == 0)
    return out;
  const double e = *elastic.restitution, left = e * e - out.plastic_loss;
  const double error = 2 * e * elastic.error_estimate + 4 * std::numeric_limits<double>::epsilon(); // of left
  out.ending_is_certain = elastic.ending_is_certain && std::abs(left) > 2 * error;
  if (left > 0) {
    out.restitution = std::sqrt(left);
    out.error_estimate = std::min(error / (2 * *out.restitution), std::sqrt(error));
  } else {
    out.restitution.reset();
    out.ending = ending::captured;
    out.error_estimate = -left < 2 * error ? std::sqrt(error) : 0;
  }
  return out;
}

} // namespace ricochet::detail
