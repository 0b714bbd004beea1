#pragma once
#include <ricochet/law/adhesion/adhesion_law.hpp>

namespace ricochet {

/// Johnson, Kendall & Roberts: surface energy -pi a^2 w; the static edge lies where G = w.
/// delta = a^2/R - sqrt(2 pi w a/E*), F = 4E*a^3/3R - sqrt(8 pi w E* a^3)
/// work_of_adhesion: w of the pair, J/m^2, >= 0 (twice the surface free energy for like bodies).
/// Valid for Tabor numbers above 5. A free collision ends at the fold, where delta is least (displacement control).
/// Source: Krijt 2013 (6)-(10), with the fold a^3 = pi w R^2/8E* and the energy left there, 0.1 pi^{5/3}(w^5
/// R^4/E*^2)^{1/3}.
template <class S>
struct jkr_law {
  using role = role::adhesion;
  using number = typename S::number;
  static constexpr bool uses_root_radius = true;
  typename S::energy_per_area work_of_adhesion{};

  template <class Other>
  using in = jkr_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"work_of_adhesion", &jkr_law::work_of_adhesion, non_negative}};
  }

  typename S::energy surface_energy(typename S::length radius) const {
    return -pi<number>() * radius * radius * work_of_adhesion;
  }

  /// c in delta = a^2/R - c sqrt(a) [K (8)].
  typename S::root_length flattening(const basic_pair<S>& pair) const {
    return sqrt(number(2) * pi<number>() * work_of_adhesion / pair.reduced_modulus);
  }

  /// Radius to which a static contact jumps when the bodies touch, delta = 0.
  typename S::length touch_radius(const basic_pair<S>& pair) const {
    return cube_root(number(2) * pi<number>() * characteristic_volume(pair));
  }

  /// Radius at which delta is least: where a free static contact lets go.
  typename S::length fold_radius(const basic_pair<S>& pair) const {
    return cube_root(pi<number>() / number(8) * characteristic_volume(pair));
  }

  /// Radius at which the force vanishes [K (10)].
  typename S::length equilibrium_radius(const basic_pair<S>& pair) const {
    return cube_root(number(9) * pi<number>() / number(2) * characteristic_volume(pair));
  }

  /// Radius on the stable static branch at this approach (which is not below the fold's), by Newton's method from
  /// above, where delta(a) is convex.
  typename S::length contact_radius(const basic_pair<S>& pair, typename S::length approach) const {
    const typename S::root_length c = flattening(pair);
    if (c == typename S::root_length{})
      return approach > typename S::length{} ? sqrt(approach * pair.reduced_radius) : typename S::length{};
    typename S::length a = equilibrium_radius(pair);
    if (approach * pair.reduced_radius > a * a)
      a = sqrt(approach * pair.reduced_radius) + a;
    for (int i = 0; i < 60; ++i) {
      const typename S::length step = (a * a / pair.reduced_radius - c * sqrt(a) - approach) /
                                      (number(2) * a / pair.reduced_radius - c / (number(2) * sqrt(a)));
      a -= step;
      if (abs(step) <= number(4) * std::numeric_limits<number>::epsilon() * a)
        break;
    }
    return a;
  }

  /// Largest static tension, 1.5 pi w R [K after (10)].
  typename S::force pull_off_force(const basic_pair<S>& pair) const {
    return number(3) * pi<number>() * work_of_adhesion * pair.reduced_radius / number(2);
  }

  /// U_E + U_S at the fold: the least energy a static contact has where it lets go.
  typename S::energy exit_energy(const basic_pair<S>& pair) const {
    const typename S::length a = fold_radius(pair);
    // At the fold 4a^2/R = c sqrt(a): U = (16/5) E* a^5/R^2.
    return number(16) * pair.reduced_modulus * cube(a) * (a / pair.reduced_radius) * (a / pair.reduced_radius) /
           number(5);
  }

private:
  auto characteristic_volume(const basic_pair<S>& pair) const { // w R^2/E*
    return work_of_adhesion * pair.reduced_radius * pair.reduced_radius / pair.reduced_modulus;
  }
};
using jkr = jkr_law<dimensional>;

} // namespace ricochet
