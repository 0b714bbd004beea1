#pragma once
#include <ricochet/law/adhesion/attraction_law.hpp>

namespace ricochet {

/// Brach & Dunn: a ring force along the edge of a Hertzian contact, stronger on the rebound.
/// F_A = -2 pi a f_0 [1 - c_A d(delta)/dt H(-d(delta)/dt)], U_A = -(4/3) pi f_0 a^3/R
/// force_per_length: f_0, N/m, >= 0. rebound_coefficient: c_A, s/m, >= 0; closed_form/brach_dunn.hpp has it from
/// zeta_A. Valid for a << R; the bodies rest at delta = 2 pi f_0/K, K = (4/3)E*. The damping acts at the edge: it
/// counts as crack loss. Source: Brach & Dunn 1995 (B1), where the sign printed for the rebound would feed energy in.
template <class S>
struct line_force_law {
  using role = role::adhesion;
  using number = typename S::number;
  typename S::energy_per_area force_per_length{};
  typename S::inverse_speed rebound_coefficient{};

  template <class Other>
  using in = line_force_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"force_per_length", &line_force_law::force_per_length, non_negative},
                      parameter{"rebound_coefficient", &line_force_law::rebound_coefficient, non_negative}};
  }

  typename S::force attraction(const basic_pair<S>&, const configuration<S>& c) const {
    return number(2) * pi<number>() * c.radius * force_per_length;
  }

  typename S::energy potential_energy(const basic_pair<S>& pair, const configuration<S>& c) const {
    return -number(4) / number(3) * pi<number>() * force_per_length * cube(c.radius) / pair.reduced_radius;
  }

  typename S::damping rebound_damping(const basic_pair<S>& pair, const configuration<S>& c) const {
    using result = typename S::damping;
    return select<result>(
        c.rate < typename S::speed{}, [&] { return result(attraction(pair, c) * rebound_coefficient); },
        [] { return result{}; });
  }

  /// The work of adhesion with which a JKR contact would have as much energy at rest, as far as powers go.
  typename S::energy_per_area equivalent_work_of_adhesion(const basic_pair<S>& pair) const {
    return force_per_length * sqrt(force_per_length / (pair.reduced_modulus * pair.reduced_radius));
  }
};
using line_force = line_force_law<dimensional>;

} // namespace ricochet
