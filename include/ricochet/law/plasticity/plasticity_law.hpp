#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Plasticity law: what plastic flow alone would take of an impact's energy. It is added to the other losses after the
/// motion, which stays elastic: 1 - e^2 = (1 - e_elastic^2) + loss. Axioms: 0 <= loss < 1; none at small speeds.
template <class L>
concept plasticity_law = any_law<L> && plays<L, role::plasticity> &&
    requires(const L law, const contact_pair& pair, speed v) {
  { law.loss(pair, v) } -> std::same_as<double>;
};

} // namespace ricochet
