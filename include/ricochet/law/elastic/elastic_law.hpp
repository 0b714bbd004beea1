#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Elastic law: force, stored energy and energy release rate of a contact of radius a at approach delta, and the
/// approach at which the edge of a contact of that radius is free of load, with its derivative in a.
/// A law whose impacts are not on Hertz's scales says theirs on plain numbers in SI: scales_of_impact(pair, speed, w).
/// Axioms (tests/axioms): F = dU/d(delta); G = (1/2 pi a) dU/da; G = 0 at the load-free approach.
template <class L>
concept elastic_law = any_law<L> && plays<L, role::elastic> &&
    requires(const L law, const basic_pair<reduced<double>>& pair, const configuration<reduced<double>>& c) {
  typename L::template in<reduced<double>>;
  requires requires(typename L::template in<reduced<double>> numbers) {
    { numbers.force(pair, c) } -> std::same_as<double>;
    { numbers.stored_energy(pair, c) } -> std::same_as<double>;
    { numbers.energy_release_rate(pair, c) } -> std::same_as<double>;
    { numbers.load_free_approach(pair, c.radius) } -> std::same_as<double>;
    { numbers.load_free_slope(pair, c.radius) } -> std::same_as<double>;
  };
};

/// A law whose energy does not depend on the contact radius says `has_edge = false`: no adhesion can work at its edge.
template <class L>
inline constexpr bool is_edgeless = requires {
  requires !L::has_edge;
};

} // namespace ricochet
