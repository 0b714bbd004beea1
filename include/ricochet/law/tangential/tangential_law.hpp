#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Tangential law of a contact that slides or rolls as a whole: the force that opposes its sliding.
/// Axiom: 0 <= sliding_force, so that sliding only dissipates.
template <class L>
concept sliding_law = any_law<L> && plays<L, role::tangential> &&
    requires(const typename L::template in<reduced<double>> law, double elastic_force) {
  { law.sliding_force(elastic_force) } -> std::same_as<double>;
};

/// A sliding law whose contact also resists the turning of a sphere on a wall: so slip and spin are two unknowns.
/// Axiom: edge_resistance * surface_speed >= 0, and in proportion to surface_speed.
template <class L>
concept peeling_law = sliding_law<L> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             double rebound_coefficient, double surface_speed) {
  { law.edge_resistance(pair, rebound_coefficient, surface_speed) } -> std::same_as<double>;
};

/// Tangential law of a contact that may stick at one place while it slips at another: a bed of springs, each of which
/// sticks until it is stretched as far as friction holds it there (solve/oblique/stick_slip.hpp).
/// Axiom: 0 <= largest_stretch, in proportion to the press, and 0 < stiffness.
template <class L>
concept stick_slip_law = any_law<L> && plays<L, role::tangential> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             double press) {
  { law.stiffness(pair) } -> std::same_as<double>;
  { law.largest_stretch(press) } -> std::same_as<double>;
};

/// What either does to the bodies' motion along the surface never feeds back into the normal motion.
template <class L>
concept tangential_law = sliding_law<L> || stick_slip_law<L>;

} // namespace ricochet
