#pragma once
#include <ricochet/law/adhesion/cohesive_law.hpp>
#include <ricochet/law/adhesion/dugdale_branch.hpp>

namespace ricochet {

/// Maugis & Dugdale: adhesion of any range. The surfaces pull with the stress s = w/z0 wherever their gap is below z0.
/// F = 2E*a(delta - a^2/3R) - s c^2 (2t - sin 2t), cos t = a/c
/// work_of_adhesion: w of the pair, J/m^2, > 0; interaction_range: z0, m, > 0.
/// Valid for every Tabor number; its transition parameter, 1.157 times that, must be from 1e-6 to 1e6. Tends to JKR for
/// large and to DMT for small ones. The bodies jump together at delta = -z0, where the speed of an impact is taken.
/// Source: Maugis 1992, J. Colloid Interface Sci. 150 243; before touch: Johnson & Greenwood 1997, 192 326.
template <class S>
struct maugis_dugdale_law {
  using role = role::adhesion;
  using number = typename S::number;
  typename S::energy_per_area work_of_adhesion{};
  typename S::length interaction_range{};

  template <class Other>
  using in = maugis_dugdale_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"work_of_adhesion", &maugis_dugdale_law::work_of_adhesion, positive},
                      parameter{"interaction_range", &maugis_dugdale_law::interaction_range, positive}};
  }
  static constexpr range transition_range{.low = 1e-6, .high = 1e6, .high_included = true};

  /// \throws bad_input where the transition parameter is out of its range.
  void validate(const basic_pair<S>& pair) const {
    require("transition_parameter", transition_parameter(pair), transition_range);
  }

  /// lambda = (2w/z0)(R/(pi w K^2))^{1/3}, K = 4E*/3
  number transition_parameter(const basic_pair<S>& pair) const {
    const typename S::modulus K = number(4) / number(3) * pair.reduced_modulus;
    return number(2) * natural_gap(pair, K) / (cube_root(pi<number>()) * interaction_range);
  }

  typename S::modulus stress() const { return work_of_adhesion / interaction_range; }

  typename S::force attraction(const basic_pair<S>&, const cohesive_configuration<S>& c) const {
    return stress() * c.cohesive_radius * c.cohesive_radius *
           excess_over_sine(number(number(2) * c.angle), number(sin(number(2) * c.angle)));
  }

  /// Energy of the pull and of what it does to the surfaces' shape, beyond that stored by a contact of this approach
  /// and radius; relative to bodies far apart.
  typename S::energy potential_energy(const basic_pair<S>& pair, const cohesive_configuration<S>& c) const {
    const number sine_of_half = sin(c.angle / number(2)), cosine = cos(c.angle);
    const number shape = excess_over_sine(number(number(4) * c.angle), number(sin(number(4) * c.angle))) / number(8);
    const number bending =
        number(4) / number(3) * sine_of_half * sine_of_half * (number(1) - number(2) * cosine * (number(1) + cosine));
    return stress() * c.cohesive_radius * c.cohesive_radius * c.cohesive_radius *
           (strain(pair) * bending - c.cohesive_radius / pair.reduced_radius * shape);
  }

  /// That which gives the impact the energy of the pull over its range, where that is more than JKR's.
  typename S::energy_per_area equivalent_work_of_adhesion(const basic_pair<S>& pair) const {
    const number long_range = pi<number>() * interaction_range / natural_gap(pair, pair.reduced_modulus);
    return work_of_adhesion * max(number(1), number(pow(long_range, number(0.6))));
  }

  dugdale_branch<S> branch(const basic_pair<S>& pair, const typename S::length& typical_radius) const {
    return {pair, strain(pair), interaction_range, typical_radius};
  }

private:
  number strain(const basic_pair<S>& pair) const { return number(2) * stress() / pair.reduced_modulus; }

  /// (R w^2/E^2)^{1/3}
  typename S::length natural_gap(const basic_pair<S>& pair, const typename S::modulus& E) const {
    const typename S::length strained = work_of_adhesion / E;
    return cube_root(pair.reduced_radius * strained * strained);
  }
};
using maugis_dugdale = maugis_dugdale_law<dimensional>;

} // namespace ricochet
