#pragma once
#include <ricochet/law/damping/bulk_damping_law.hpp>

namespace ricochet {

/// Tsuji, Tanaka & Ishida: damping that gives the same restitution at every speed.
/// F_D = alpha sqrt(m* K) delta^{1/4} d(delta)/dt = alpha sqrt(4 m* E*/3) sqrt(a) d(delta)/dt, K = (4/3) E* sqrt(R)
/// damping_coefficient: alpha, dimensionless, >= 0; overdamped from alpha = sqrt(5) on.
/// Valid wherever a constant restitution is wanted; the form in delta is written in a (delta -> a^2/R) for tension.
/// Source: Tsuji et al. 1992; closed form of e: closed_form/tsuji.hpp.
template <class S>
struct tsuji_law {
  using role = role::damping;
  using number = typename S::number;
  static constexpr bool uses_root_radius = true;
  static constexpr double coefficient_power = 0.25; ///< F_D/rate ~ delta^{1/4} at the Hertzian radius
  number damping_coefficient{};

  template <class Other>
  using in = tsuji_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"damping_coefficient", &tsuji_law::damping_coefficient, non_negative}};
  }

  typename S::damping coefficient(const basic_pair<S>& pair, const configuration<S>& c) const {
    return damping_coefficient * sqrt(number(4) * pair.reduced_mass * pair.reduced_modulus / number(3)) * c.root_radius;
  }
};
using tsuji = tsuji_law<dimensional>;

} // namespace ricochet
