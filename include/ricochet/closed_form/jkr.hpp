// Impact of adhesive elastic spheres whose contact edge is static.
#pragma once
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/law/adhesion/jkr.hpp>

#include <boost/math/tools/roots.hpp>

namespace ricochet::closed_form {

namespace detail {
/// The static branch in units of the fold's radius: s = sqrt(a/a_c), delta = (a_c^2/R)(s^4 - 4s),
/// U_E + U_S = (E* a_c^5/R^2) u(s), u = 8s^10/15 - 16s^7/3 + 8s^4. Touch s^3 = 4, no force s^3 = 6, fold s = 1.
struct jkr_impact {
  static constexpr double touch = 1.5874010519681994748, rest = 1.8171205928321396589;    // cube roots of 4 and 6
  static constexpr double sticking_energy = 3.2 + 4.8 * touch * 4;                        ///< u(1) - u(touch)
  static constexpr double coefficient[] = {0, 0, 0, 0, 8, 0, 0, -16. / 3, 0, 0, 8. / 15}; ///< of s^n in u
  double excess, turning; ///< energy left at the fold, largest s

  /// r = v_c/v
  explicit jkr_impact(double r) : excess(sticking_energy * (1 - r) * (1 + r) / (r * r)) {
    const double total = potential(1) + excess, far = 1.01 * std::max(3., std::pow(4 * total + 400, 0.1));
    const auto lacking = [&](double s) { return potential(s) - total; };
    const boost::math::tools::eps_tolerance<double> close_enough;
    std::uintmax_t rounds = 200;
    turning = boost::math::tools::toms748_solve(lacking, rest, far, close_enough, rounds).second;
  }
  static double potential(double s) { return divided(s, 0) * s; }
  /// (u(x) - u(s))/(x - s) without cancellation, by Horner's division.
  static double divided(double s, double x) {
    double quotient = 0, value = 0;
    for (int n = 10; n > 0; --n)
      value = value * s + (quotient = quotient * x + coefficient[n]);
    return value;
  }
  /// (u(1) - u(s))/(s - 1)^2, likewise: u has a double root there.
  static double curvature_at_fold(double s) {
    double quotient = 0, second = 0, value = 0;
    for (int n = 10; n > 1; --n)
      value = value * s + (second += quotient += coefficient[n]);
    return -value;
  }
};
} // namespace detail

/// Largest speed of impact at which the bodies stay together.
/// v_c = (14.184391943728/m*)^{1/2} (w^5 R^4/E*^2)^{1/6}, the number being 2 pi^{5/3} (3/5 4^{1/3} + 1/10)
/// pair: E* (Pa), R (m), m* (kg), all > 0; w: work of adhesion of the pair, J/m^2, >= 0.
/// Valid for Tabor numbers above 5 and no other loss; the contact ends at the fold, 9.5 % of the loss being its.
/// Source: Krijt 2013 (25), which prints 14.18.
inline speed sticking_speed(const contact_pair& pair, energy_per_area w) {
  using boost::units::pow;
  validate(pair);
  require("work_of_adhesion", w, non_negative);
  const double factor = 2 * std::pow(pi<double>(), 5. / 3) * (0.6 * std::cbrt(4.) + 0.1);
  const double sixth_power = pow<3>(factor / pair.reduced_mass) * pow<5>(w) *
                             pow<2>(pair.reduced_radius * pair.reduced_radius / pair.reduced_modulus) /
                             pow<6>(units::metres_per_second);
  return std::sqrt(std::cbrt(sixth_power)) * units::metres_per_second; // 1/6 is no binary number
}

/// Restitution, or nothing if the bodies stay together (v <= v_c).
/// e = sqrt(1 - (v_c/v)^2)
/// pair, w: as in sticking_speed(); v: speed of approach at touch, m/s, > 0.
/// Valid as sticking_speed().
/// Source: Krijt 2013 (24).
inline std::optional<double> restitution(const contact_pair& pair, energy_per_area w, speed v) {
  require("speed", v, positive);
  const double ratio = sticking_speed(pair, w) / v;
  return ratio < 1 ? std::optional(std::sqrt((1 - ratio) * (1 + ratio))) : std::nullopt;
}

/// Largest approach, that of the first turning point, of bodies that separate as of ones that stay together.
/// delta = (a_c^2/R)(s^4 - 4s), where m* v^2/2 = (E* a_c^5/R^2)(u(s) - u(4^{1/3})), u = 8s^10/15 - 16s^7/3 + 8s^4
/// pair, w: as in sticking_speed(); v: speed of approach at touch, m/s, > 0.
/// Valid as sticking_speed().
/// Source: energy balance with Krijt 2013 (2), (8); w = 0 is Hertz.
inline length max_approach(const contact_pair& pair, energy_per_area w, speed v) {
  require("speed", v, positive);
  const double ratio = sticking_speed(pair, w) / v;
  if (ratio == 0)
    return max_approach(pair, v);
  const length fold = jkr{w}.fold_radius(pair);
  const double s = detail::jkr_impact(ratio).turning;
  return fold * (fold / pair.reduced_radius) * (s * (cube(s) - 4));
}

} // namespace ricochet::closed_form
