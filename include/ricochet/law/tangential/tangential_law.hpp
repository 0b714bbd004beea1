#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Tangential law: the force that opposes a sliding contact. What it does to the bodies' motion along the surface never
/// feeds back into the normal motion. Axiom: 0 <= sliding_force, so that sliding only dissipates.
template <class L>
concept tangential_law = any_law<L> && plays<L, role::tangential> &&
    requires(const typename L::template in<reduced<double>> law, double elastic_force) {
  { law.sliding_force(elastic_force) } -> std::same_as<double>;
};

} // namespace ricochet
