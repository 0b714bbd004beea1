// Impact of elastic-plastic spheres without adhesion: the pressure in the contact cannot exceed that at first yield.
#pragma once
#include <ricochet/closed_form/hertz.hpp>

namespace ricochet::closed_form {

namespace detail {

/// Thornton and Ning's factor in x = v_y/v, with s^2 = (6 - x^2)/5. The published product of roots is the fourth root
/// of 3 x s^4/(x + 2s), and 1 - e_P^4 has the factor (1 - x)^2, here divided out: nothing cancels at the yield speed.
template <class T>
struct thornton_ning_impact {
  T x, excess, s; ///< excess: 1 - x

  /// v > v_y
  thornton_ning_impact(const T& v_y, const T& v) : x(v_y / v), excess((v - v_y) / v), s(sqrt((6 - x * x) / 5)) {}

  T restitution() const { return s * sqrt(sqrt(3 * x / (x + 2 * s))); }

  T loss() const {
    const T slope = (1 + x) / 5;          // (s^2 - 1)/(1 - x)
    const T root_slope = slope / (1 + s); // (s - 1)/(1 - x)
    const T numerator = 1 + 6 * slope - square(root_slope) - 3 * x * square(slope);
    return square(excess) * numerator / ((x + 2 * s) * (1 + square(restitution())));
  }
};

inline void validate_yield(const speed& v_y, const speed& v) {
  require("yield_speed", v_y, positive);
  require("speed", v, positive);
}

} // namespace detail

/// Pressure at the centre of the contact at which the material below begins to yield.
/// p_y = 1.6 Y
/// yield_strength: Y, of the weaker body in simple tension, Pa, > 0.
/// Valid for Poisson's ratios near 0.3, by Tresca's criterion as by von Mises'.
/// Source: Krijt 2013 after (28), from Johnson, Contact Mechanics.
inline modulus contact_yield_pressure(modulus yield_strength) {
  require("yield_strength", yield_strength, positive);
  return 1.6 * yield_strength;
}

/// The factor in v_y^2, pi^5/30 = 10.2006561595...: the energy (8/15) E* a^5/R^2 where 2 E* a/(pi R) = p_y.
inline double yield_speed_factor() { return square(square(pi<double>())) * pi<double>() / 30; }

/// Largest speed of impact without plastic flow.
/// v_y^2 = 10.2006561595... R^3 p_y^5/(m* E*^4), p_y = contact_yield_pressure(Y)
/// pair: E* (Pa), R (m), m* (kg), all > 0; yield_strength: Y, of the weaker body in simple tension, Pa, > 0.
/// Valid without adhesion and other losses; independent of size for like spheres with the same Y.
/// Source: Krijt 2013 (28), which prints 10.2; Thornton & Ning 1998.
inline speed yield_speed(const contact_pair& pair, modulus yield_strength) {
  using boost::units::pow;
  validate(pair);
  const modulus pressure = contact_yield_pressure(yield_strength);
  return square(double(pressure / pair.reduced_modulus)) *
         sqrt(yield_speed_factor() * pow<3>(pair.reduced_radius) * pressure / pair.reduced_mass);
}

/// Restitution where plastic flow is the only loss; 1 up to the yield speed.
/// e_P = s (3x/(x + 2s))^{1/4}, x = v_y/v, s^2 = (6 - x^2)/5; 1.18499 x^{1/4} for x << 1
/// v_y: yield_speed(), m/s, > 0; v: speed of approach at touch, m/s, > 0.
/// Valid while the plastic zone is enclosed by elastic material, that is to pressures of about 3 Y on average.
/// Source: Krijt 2013 (29) from Thornton & Ning 1998; the same function, its three roots drawn together.
inline double plastic_restitution(speed v_y, speed v) {
  detail::validate_yield(v_y, v);
  return v > v_y ? std::min(1., detail::thornton_ning_impact(in_si(v_y), in_si(v)).restitution()) : 1;
}

/// Part of the kinetic energy that plastic flow takes; 0 up to the yield speed.
/// 1 - e_P^2 = (1 - x)^2 (1 + 6g - g^2/(1 + s)^2 - 3xg^2)/((x + 2s)(1 + e_P^2)), g = (1 + x)/5; (12/25)(1 - x)^2 at
/// yield v_y, v: as in plastic_restitution(). Valid as plastic_restitution(). Source: Krijt 2013 (29), with the factor
/// that vanishes at yield divided out.
inline double plastic_loss(speed v_y, speed v) {
  detail::validate_yield(v_y, v);
  return v > v_y ? detail::thornton_ning_impact(in_si(v_y), in_si(v)).loss() : 0;
}

/// How the yield strength grows in small volumes. The k of the published law, in Pa m^n, has a unit that depends on n;
/// what it adds at some length has not: gain = k/reference_length^n, at 1 m the number of k.
struct size_strengthening {
  modulus macroscopic_strength{}; ///< Y_0, >= 0; none unless given
  modulus gain;                   ///< what is added at reference_length, >= 0
  length reference_length;        ///< any, > 0
  double exponent = 0.5;          ///< n, 0.5 to 1; 0.5 is Hall and Petch's
};

/// Yield strength in a volume of this size.
/// Y = Y_0 + k l^-n = Y_0 + gain (reference_length/l)^n
/// law: Y_0 (Pa), gain (Pa), reference_length (m), n; l: m, > 0, in a collision max_contact_radius(pair, v).
/// Valid for metals, as an empirical law, and up to the theoretical strength of about 0.2 E, which it does not know.
/// Source: Krijt 2013 (32), (33); the text has 0.5 > n > 1, meant are the values from 0.5 to 1.
inline modulus yield_strength(const size_strengthening& law, length l) {
  require("macroscopic_strength", law.macroscopic_strength, non_negative);
  require("gain", law.gain, non_negative);
  require("reference_length", law.reference_length, positive);
  require("exponent", law.exponent, range{.low = 0.5, .high = 1, .high_included = true});
  require("length", l, positive);
  return law.macroscopic_strength + law.gain * std::pow(double(law.reference_length / l), law.exponent);
}

} // namespace ricochet::closed_form
