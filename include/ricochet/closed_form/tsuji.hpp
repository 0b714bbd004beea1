// Impact with damping that gives the same restitution at every speed.
#pragma once
#include <ricochet/closed_form/hertz.hpp>

#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>

#include <optional>

namespace ricochet::closed_form {

namespace detail {

/// delta^{5/4} is a damped linear oscillator in slowed time, d theta ~ delta^{1/4} dt:
/// delta^{5/4} ~ exp(-zeta theta) S(theta), S = sin(s theta)/s, s^2 = 1 - zeta^2, sinh and zeta^2 - 1 beyond zeta = 1.
struct tsuji_impact {
  double zeta, s;

  explicit tsuji_impact(double damping_coefficient)
      : zeta(damping_coefficient / std::sqrt(5.)), s(std::sqrt(std::abs(1 - zeta)) * std::sqrt(1 + zeta)) {}

  /// acos(zeta)/s, acosh(zeta)/s beyond 1.
  double half_angle() const {
    if (s == 0)
      return 1;
    return (zeta < 1 ? std::atan2(s, zeta) : std::asinh(s)) / s;
  }

  double shape(double theta) const {
    return theta * (zeta < 1 ? boost::math::sinc_pi(s * theta) : boost::math::sinhc_pi(s * theta));
  }
};

inline tsuji_impact tsuji_at(double damping_coefficient) {
  require("damping_coefficient", damping_coefficient, non_negative);
  return tsuji_impact(damping_coefficient);
}

} // namespace detail

/// Restitution of a contact that ends where the force vanishes.
/// e = exp(-zeta acos(2 zeta^2 - 1)/sqrt(1 - zeta^2)), acosh and sqrt(zeta^2 - 1) for zeta > 1, e^-2 at 1; zeta =
/// alpha/sqrt 5 damping_coefficient: alpha, dimensionless, >= 0. Valid for every alpha; the same at every speed.
/// Source: Tsuji et al. 1992 with the end of Schwager & Poeschel 2007; written as 2 acos(zeta), stable through zeta
/// = 1.
inline double restitution_to_zero_force(double damping_coefficient) {
  const auto impact = detail::tsuji_at(damping_coefficient);
  return std::exp(-2 * impact.zeta * impact.half_angle());
}

/// Restitution of a contact that pulls until the overlap vanishes; nothing if it never does (alpha >= sqrt 5).
/// e = exp(-pi zeta/sqrt(1 - zeta^2)), zeta = alpha/sqrt 5
/// damping_coefficient: alpha, dimensionless, >= 0.
/// Valid for every alpha; the same at every speed.
/// Source: Tsuji et al. 1992; Antypov & Elliott 2011.
inline std::optional<double> restitution_to_zero_overlap(double damping_coefficient) {
  const auto impact = detail::tsuji_at(damping_coefficient);
  return impact.zeta < 1 ? std::optional(std::exp(-pi<double>() * impact.zeta / impact.s)) : std::nullopt;
}

/// alpha that gives this restitution where the contact ends at zero overlap.
/// alpha = -sqrt 5 ln e/sqrt(pi^2 + ln^2 e)
/// restitution: e, dimensionless, in (0, 1].
/// Valid for that end only: with the end at zero force the same alpha gives a larger restitution.
/// Source: Antypov & Elliott 2011.
inline double damping_coefficient_for(double restitution) {
  require("restitution", restitution, range{.high = 1, .low_included = false, .high_included = true});
  const double fall = -std::log(restitution);
  return std::sqrt(5.) * fall / std::hypot(pi<double>(), fall);
}

} // namespace ricochet::closed_form
