#pragma once
#include <ricochet/law/damping/bulk_damping_law.hpp>

namespace ricochet {

/// Hunt & Crossley: damping in proportion to the Hertzian force.
/// F_D = c (4E*a^3/3R) d(delta)/dt, that is F = K delta^{3/2}(1 + c d(delta)/dt) without adhesion
/// damping_coefficient: c, s/m, >= 0.
/// Valid for c v up to order one; the published form in delta is written in a (delta -> a^2/R) for contacts in tension.
/// Source: Hunt & Crossley 1975; closed form of e: closed_form/hunt_crossley.hpp.
template <class S>
struct hunt_crossley_law {
  using role = role::damping;
  using number = typename S::number;
  typename S::inverse_speed damping_coefficient{};

  template <class Other>
  using in = hunt_crossley_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"damping_coefficient", &hunt_crossley_law::damping_coefficient, non_negative}};
  }

  typename S::damping coefficient(const basic_pair<S>& pair, const configuration<S>& c) const {
    return number(4) / number(3) * damping_coefficient * pair.reduced_modulus * c.radius * c.radius *
           (c.radius / pair.reduced_radius);
  }
};
using hunt_crossley = hunt_crossley_law<dimensional>;

} // namespace ricochet
