#pragma once
#include <ricochet/law/damping/bulk_damping_law.hpp>

namespace ricochet {

/// Linear dashpot, the damping of discrete-element codes with linear springs.
/// F_D = c d(delta)/dt
/// damping_coefficient: c, N s/m, >= 0; closed_form/linear.hpp has it from the damping ratio c/2 sqrt(m* k) of a
/// spring, or from the restitution wanted. Valid as a stand-in only: the force jumps at touch. With a linear spring, e
/// is the same at every speed. Source: Cundall & Strack 1979; closed form of e: closed_form/linear.hpp.
template <class S>
struct linear_dashpot_law {
  using role = role::damping;
  static constexpr double coefficient_power = 0; ///< F_D/rate ~ delta^0
  typename S::damping damping_coefficient{};

  template <class Other>
  using in = linear_dashpot_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"damping_coefficient", &linear_dashpot_law::damping_coefficient, non_negative}};
  }

  typename S::damping coefficient(const basic_pair<S>&, const configuration<S>&) const { return damping_coefficient; }
};
using linear_dashpot = linear_dashpot_law<dimensional>;

} // namespace ricochet
