#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Adhesion without an edge of its own: a force that pulls the bodies together wherever they touch, while the contact
/// keeps its Hertzian radius a^2 = R delta and lets go at a = 0.
/// Axioms: attraction >= 0; potential_energy <= 0, zero at a = 0, its derivative in delta is -attraction.
template <class L>
concept attraction_law = any_law<L> && plays<L, role::adhesion> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             const configuration<reduced<double>>& c) {
  { law.attraction(pair, c) } -> std::same_as<double>;
  { law.potential_energy(pair, c) } -> std::same_as<double>;
  { law.equivalent_work_of_adhesion(pair) } -> std::same_as<double>; // for the scales of a collision
};

/// One that opposes a rebound: F = rebound_damping * rate.
/// Axioms: rebound_damping >= 0, and zero while closing.
template <class L>
concept rebound_opposing_law = attraction_law<L> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             const configuration<reduced<double>>& c) {
  { law.rebound_damping(pair, c) } -> std::same_as<double>;
};

/// One that peels: c_A, s/m, by which it is stronger at an edge that opens; a rolling contact opens at its trailing
/// one.
template <class L>
concept rebounding_law = rebound_opposing_law<L> && requires(const typename L::template in<reduced<double>> law) {
  { law.rebound_coefficient } -> std::convertible_to<double>;
};

} // namespace ricochet
