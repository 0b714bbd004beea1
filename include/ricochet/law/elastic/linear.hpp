#pragma once
#include <ricochet/body/scales.hpp>
#include <ricochet/law/elastic/elastic_law.hpp>

namespace ricochet {

/// Linear spring, to compare with the practice of discrete-element codes.
/// F = k delta, U = k delta^2/2, G = 0, a^2 = R delta
/// stiffness: k, N/m, > 0.
/// Valid as a stand-in only: k belongs to one size and speed of impact, the contact time is the same at every speed and
/// the radius says nothing but where the overlap of two spheres is, for laws written in it.
/// Source: Cundall & Strack 1979.
template <class S>
struct linear_law {
  using role = role::elastic;
  using number = typename S::number;
  static constexpr bool has_edge = false;  ///< the energy does not depend on the contact radius
  static constexpr double force_power = 1; ///< F ~ delta
  typename S::energy_per_area stiffness{};

  template <class Other>
  using in = linear_law<Other>;
  static constexpr auto parameters() { return std::tuple{parameter{"stiffness", &linear_law::stiffness, positive}}; }

  typename S::force force(const basic_pair<S>&, const configuration<S>& c) const { return stiffness * c.approach; }

  typename S::energy stored_energy(const basic_pair<S>&, const configuration<S>& c) const {
    return stiffness * c.approach * c.approach / number(2);
  }

  typename S::energy_per_area energy_release_rate(const basic_pair<S>&, const configuration<S>&) const {
    return number(0) * stiffness;
  }

  static typename S::length load_free_approach(const basic_pair<S>& pair, typename S::length radius) {
    return radius * radius / pair.reduced_radius;
  }

  static typename S::number load_free_slope(const basic_pair<S>& pair, typename S::length radius) {
    return number(2) * radius / pair.reduced_radius;
  }

  /// Those of the spring, in SI, at the larger of v and the speed that a pull of w R gives it.
  basic_scales<number> scales_of_impact(const basic_pair<S>& pair, const number& v, const number& w) const {
    const number m = pair.reduced_mass, time = sqrt(m / stiffness);
    const number fastest = max(v, number(w * pair.reduced_radius * time / m));
    return {.length = fastest * time, .duration = time, .mass = m};
  }

  /// Largest approach of an impact without losses, v sqrt(m*/k).
  length max_approach(const contact_pair& pair, speed v) const requires std::same_as<S, dimensional> {
    return v * boost::units::root<2>(pair.reduced_mass / stiffness);
  }
};
using linear = linear_law<dimensional>;

} // namespace ricochet
