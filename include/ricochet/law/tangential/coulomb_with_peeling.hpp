#pragma once
#include <ricochet/law/tangential/coulomb.hpp>

namespace ricochet {

/// Coulomb friction of a sphere whose contact resists its turning: adhesion peels off at the trailing edge.
/// F_t as coulomb's while it slides; g = -lambda c_A a d(theta)/dt, c_A the adhesion law's rebound coefficient
/// friction_coefficient: f, >= 0. peeling_moment: lambda, N m, >= 0; at zero it is coulomb's law.
/// Valid for a sphere on a flat wall that moves in a plane; the moment acts while the contact slides too.
/// Source: Brach & Dunn 1995 (B9), (B10), where the sign printed would spin the sphere up; lambda = 0 in their results.
template <class S>
struct coulomb_with_peeling_law {
  using role = role::tangential;
  using number = typename S::number;
  number friction_coefficient{};
  typename S::energy peeling_moment{};

  template <class Other>
  using in = coulomb_with_peeling_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"friction_coefficient", &coulomb_with_peeling_law::friction_coefficient, non_negative},
                      parameter{"peeling_moment", &coulomb_with_peeling_law::peeling_moment, non_negative}};
  }

  typename S::force sliding_force(typename S::force elastic_force) const {
    return coulomb_law<S>{friction_coefficient}.sliding_force(elastic_force);
  }

  /// Force at the edge, with the contact radius for its arm; surface_speed: that of turning, r d(theta)/dt.
  typename S::force edge_resistance(const basic_pair<S>& pair, typename S::inverse_speed rebound_coefficient,
                                    typename S::speed surface_speed) const {
    return rebound_coefficient * surface_speed * peeling_moment / pair.reduced_radius;
  }
};
using coulomb_with_peeling = coulomb_with_peeling_law<dimensional>;

} // namespace ricochet
