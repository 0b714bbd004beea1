#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// What a cohesive law sees besides: the surfaces pull within cohesive_radius c, and touch within a = c cos(angle).
template <class S>
struct cohesive_configuration : configuration<S> {
  typename S::length cohesive_radius;
  typename S::number angle; ///< pi/2 where the surfaces do not touch yet
};

/// Adhesion of a range of its own: a force beside the elastic one, of a contact that is not Hertzian but led along a
/// branch of static equilibria. It begins before the surfaces touch, at branch.first(), and lets go at branch.fold(),
/// where approach is least; branch.at(y, touching) is the equilibrium at a coordinate y, < 0 before they touch.
/// Axioms: attraction >= 0; the static force, elastic - attraction, is the derivative of stored energy +
/// potential_energy in the approach, along the branch and across it; both radii grow along the branch.
template <class L>
concept cohesive_law = any_law<L> && plays<L, role::adhesion> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair,
             const cohesive_configuration<reduced<double>>& c, double x) {
  { law.attraction(pair, c) } -> std::same_as<double>;
  { law.potential_energy(pair, c) } -> std::same_as<double>;
  { law.equivalent_work_of_adhesion(pair) } -> std::same_as<double>; // for the scales of a collision
  { law.branch(pair, x).first() } -> std::convertible_to<double>;
  { law.branch(pair, x).fold() } -> std::convertible_to<double>;
  { law.branch(pair, x).at(x, true).slope } -> std::convertible_to<double>;
};

namespace detail {
template <class Law, class T>
struct branch_type {
  struct type {};
};
template <cohesive_law Law, class T>
struct branch_type<Law, T> {
  using S = reduced<T>;
  using law = typename Law::template in<S>;
  using type = decltype(std::declval<law>().branch(std::declval<basic_pair<S>>(), T()));
};
} // namespace detail

/// A cohesive law's branch on plain numbers T; of other laws an empty type.
template <class Law, class T>
using branch_of = typename detail::branch_type<Law, T>::type;

} // namespace ricochet
