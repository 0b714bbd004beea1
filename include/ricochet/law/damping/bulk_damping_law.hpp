#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Bulk damping law: F_D = coefficient * rate, written in the contact radius so that it is defined in tension too.
/// A law with a power of delta at the Hertzian radius may say it (`coefficient_power`): then overdamped contacts that
/// are pulled to zero overlap are certified as captured. Axiom: coefficient >= 0, so that the power F_D * rate never is
/// negative.
template <class L>
concept bulk_damping_law = any_law<L> && plays<L, role::damping> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             const configuration<reduced<double>>& c) {
  { law.coefficient(pair, c) } -> std::same_as<double>;
};

} // namespace ricochet
