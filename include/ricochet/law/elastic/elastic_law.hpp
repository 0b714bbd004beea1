#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Elastic law: force, stored energy and energy release rate of a contact of radius a at approach delta, and the
/// approach at which the edge of a contact of that radius is free of load, with its derivative in a.
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

} // namespace ricochet
