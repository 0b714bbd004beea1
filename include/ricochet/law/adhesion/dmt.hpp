#pragma once
#include <ricochet/law/adhesion/attraction_law.hpp>

namespace ricochet {

/// Derjaguin, Muller & Toporov: the attraction acts outside a contact that stays Hertzian.
/// F = 4E*a^3/3R - 2 pi w R, a^2 = R delta
/// work_of_adhesion: w of the pair, J/m^2, >= 0.
/// Valid for Tabor numbers below 0.1. The attraction ends with the contact, at delta = 0: what the surfaces do apart is
/// left out, and an undamped impact loses nothing.
/// Source: Derjaguin, Muller & Toporov 1975, in Maugis' form of 1992.
template <class S>
struct dmt_law {
  using role = role::adhesion;
  using number = typename S::number;
  typename S::energy_per_area work_of_adhesion{};

  template <class Other>
  using in = dmt_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"work_of_adhesion", &dmt_law::work_of_adhesion, non_negative}};
  }

  typename S::force attraction(const basic_pair<S>& pair, const configuration<S>&) const {
    return pull_off_force(pair);
  }

  typename S::energy potential_energy(const basic_pair<S>& pair, const configuration<S>& c) const {
    return -pull_off_force(pair) * c.radius * (c.radius / pair.reduced_radius);
  }

  typename S::energy_per_area equivalent_work_of_adhesion(const basic_pair<S>&) const { return work_of_adhesion; }

  /// Largest tension, 2 pi w R.
  typename S::force pull_off_force(const basic_pair<S>& pair) const {
    return number(2) * pi<number>() * work_of_adhesion * pair.reduced_radius;
  }
};
using dmt = dmt_law<dimensional>;

} // namespace ricochet
