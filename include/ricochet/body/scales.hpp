#pragma once
#include <ricochet/body/pair.hpp>

namespace ricochet {

/// Units of length, time and mass in which a collision is computed, in SI. Chosen so that mass, speed, approach and
/// force are of order one whatever the scene.
struct scales {
  double length = 1;
  double duration = 1;
  double mass = 1;

  /// SI value of one reduced unit of the quantity's dimension.
  template <class Quantity>
  double factor(const Quantity& quantity) const {
    const exponents e = exponents_of(quantity);
    const auto power = [](double x, double p) { return p == 0 ? 1. : p == 1 ? x : p == 2 ? x * x : std::pow(x, p); };
    return power(length, e.length) * power(mass, e.mass) * power(duration, e.time);
  }
};

/// Scales of an impact at speed v under work of adhesion w (zero where there is none): the larger of v and the speed
/// that adhesion gives, (w^5 R^4/E*^2)^{1/6} m*^{-1/2}, and the Hertzian approach belonging to it.
inline scales scales_of(const contact_pair& pair, speed v, energy_per_area w) {
  const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), m = in_si(pair.reduced_mass);
  const double adhesive = std::pow(in_si(w), 5. / 6) * std::pow(R, 4. / 6) / std::cbrt(E) / std::sqrt(m);
  const double fastest = std::max(in_si(v), adhesive);
  const double approach = std::pow(m * fastest * fastest / (E * std::sqrt(R)), 0.4);
  return {.length = approach, .duration = approach / fastest, .mass = m};
}

template <class T, class Quantity>
T reduce(const Quantity& quantity, const scales& unit) {
  return T(in_si(quantity)) / T(unit.factor(quantity));
}

} // namespace ricochet
