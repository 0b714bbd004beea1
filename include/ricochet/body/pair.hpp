#pragma once
#include <ricochet/body/sphere.hpp>

namespace ricochet {

/// The two spheres themselves, for motion along the surface and spin; of a wall, radius and mass are infinite.
struct two_bodies {
  length radius_1, radius_2;
  mass mass_1, mass_2;
};

/// All that a normal collision needs to know of its two bodies [Krijt 2013, after (1) and (20)]:
/// 1/E* = sum (1-nu_i^2)/E_i, 1/R = sum 1/R_i, 1/m* = sum 1/m_i.
template <class S>
struct basic_pair {
  constant<typename S::modulus> reduced_modulus; ///< E*; the relaxed (slow) one where a crack law is present
  constant<typename S::length> reduced_radius;   ///< R
  constant<typename S::mass> reduced_mass;       ///< m*
  /// Not in the loop: spin and motion along the surface follow from the sliding of the contact point.
  struct nothing {};
  [[no_unique_address]] std::conditional_t<std::same_as<S, dimensional>, two_bodies, nothing> bodies{};
};
using contact_pair = basic_pair<dimensional>;

namespace detail {
inline auto compliance(const material& solid) { return (1 - square(solid.poissons_ratio)) / solid.youngs_modulus; }
} // namespace detail

/// \throws bad_input naming quantity, value and range.
inline void validate(const contact_pair& pair) {
  require("reduced_modulus", pair.reduced_modulus, positive);
  require("reduced_radius", pair.reduced_radius, positive);
  require("reduced_mass", pair.reduced_mass, positive);
}

/// \throws bad_input naming quantity, value and range; `whose` goes before its name.
inline void validate(const sphere& body, const std::string& whose = "") {
  validate(body.solid, whose);
  require(whose + "radius", body.radius, positive);
  require(whose + "mass", body.mass(), positive); // its density and radius may be within their ranges all the same
}

/// \throws bad_input naming quantity, value and range.
inline contact_pair between(const sphere& one, const sphere& other) {
  validate(one, "first sphere: ");
  validate(other, "second sphere: ");
  const contact_pair pair{.reduced_modulus = 1.0 / (detail::compliance(one.solid) + detail::compliance(other.solid)),
                          .reduced_radius = 1.0 / (1.0 / one.radius + 1.0 / other.radius),
                          .reduced_mass = 1.0 / (1.0 / one.mass() + 1.0 / other.mass()),
                          .bodies = {one.radius, other.radius, one.mass(), other.mass()}};
  validate(pair);
  return pair;
}

/// \throws bad_input naming quantity, value and range.
inline contact_pair between(const sphere& body, const flat_wall& wall) {
  validate(body, "sphere: ");
  validate(wall.solid, "wall: ");
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const contact_pair pair{.reduced_modulus = 1.0 / (detail::compliance(body.solid) + detail::compliance(wall.solid)),
                          .reduced_radius = body.radius,
                          .reduced_mass = body.mass(),
                          .bodies = {body.radius, infinite * units::metres, body.mass(), infinite * units::kilograms}};
  validate(pair);
  return pair;
}

} // namespace ricochet
