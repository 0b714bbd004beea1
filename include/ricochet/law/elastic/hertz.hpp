#pragma once
#include <ricochet/law/elastic/elastic_law.hpp>

namespace ricochet {

/// Hertzian spheres whose contact radius need not be the Hertzian one.
/// F = (2E*/3R)(3 a delta R - a^3), U = E*(delta^2 a - 2 delta a^3/3R + a^5/5R^2), G = E*(a^2 - delta R)^2/(2 pi a R^2)
/// No parameters of its own. Valid for a << R and speeds well below that of sound.
/// Source: Muller, Yushchenko & Derjaguin 1980 as Krijt 2013 (2), (3), (14); with a^2 = R delta, Hertz's F = 4E*a^3/3R
/// (5).
template <class S>
struct hertz_law {
  using role = role::elastic;
  using number = typename S::number;
  static constexpr double force_power = 1.5; ///< F ~ delta^{3/2} at the Hertzian radius
  template <class Other>
  using in = hertz_law<Other>;
  static constexpr auto parameters() { return std::tuple{}; }

  static typename S::force force(const basic_pair<S>& pair, const configuration<S>& c) {
    const typename S::length flat = c.radius * c.radius / pair.reduced_radius; // a^2/R
    return number(2) * pair.reduced_modulus * c.radius * (c.approach - number(1) / number(3) * flat);
  }

  static typename S::energy stored_energy(const basic_pair<S>& pair, const configuration<S>& c) {
    const typename S::length flat = c.radius * c.radius / pair.reduced_radius; // a^2/R
    return pair.reduced_modulus * c.radius *
           (c.approach * c.approach - number(2) / number(3) * c.approach * flat + number(1) / number(5) * flat * flat);
  }

  static typename S::energy_per_area energy_release_rate(const basic_pair<S>& pair, const configuration<S>& c) {
    const typename S::length gap = c.radius * c.radius / pair.reduced_radius - c.approach;
    return pair.reduced_modulus * gap * gap / (number(2) * pi<number>() * c.radius);
  }

  static typename S::length load_free_approach(const basic_pair<S>& pair, typename S::length radius) {
    return radius * radius / pair.reduced_radius;
  }

  static typename S::number load_free_slope(const basic_pair<S>& pair, typename S::length radius) {
    return number(2) * radius / pair.reduced_radius;
  }
};
using hertz = hertz_law<dimensional>;

} // namespace ricochet
