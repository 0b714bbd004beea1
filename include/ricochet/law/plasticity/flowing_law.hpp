#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// What plastic flow has made of a contact: an elastic one of another radius, with its load-free approach shifted. Both
/// depend on the largest contact radius reached only, whose derivatives they come with.
template <class S>
struct contact_shape {
  typename S::length radius;            ///< R_p, takes the place of R
  typename S::length residual_approach; ///< delta_p, at which the flattened bodies touch
  typename S::number radius_slope;      ///< dR_p/da
  typename S::number approach_slope;    ///< d(delta_p)/da
};

/// A configuration of a contact with a shape: the pair has the shape's radius, and of the mutual approach it has what
/// exceeds the residual one.
template <class S>
struct flattened_configuration : configuration<S> {
  basic_pair<S> pair;
  contact_shape<S> shape;

  void take(const basic_pair<S>& round, const contact_shape<S>& its_shape) {
    pair = round;
    pair.reduced_radius = its_shape.radius;
    shape = its_shape;
  }
};

/// Flowing law: plastic flow within the motion. While the contact radius grows beyond the largest one so far, the shape
/// follows it; else the contact is elastic. `flattening` is the adhesion's, c in delta = a^2/R - c sqrt(a).
/// Axioms: at the yield radius the shape is that of the round bodies, from there on R_p and delta_p never fall;
/// approach and force of a contact at its largest radius are continuous; lost_force >= 0.
template <class L>
concept flowing_law = any_law<L> && plays<L, role::plasticity> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             const flattened_configuration<reduced<double>>& c, double x) {
  { law.yield_radius(pair, x) } -> std::same_as<double>;
  { law.shape(pair, x, x, x) } -> std::same_as<contact_shape<reduced<double>>>;
  { law.lost_force(c) } -> std::same_as<double>;
  { law.least_strength(pair, x) } -> std::same_as<double>;
  { law.yield_strength } -> std::convertible_to<double>;
};

} // namespace ricochet
