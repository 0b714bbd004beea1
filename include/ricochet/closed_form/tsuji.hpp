// Impact with damping that gives the same restitution at every speed.
#pragma once
#include <ricochet/closed_form/damped_oscillator.hpp>
#include <ricochet/closed_form/hertz.hpp>

namespace ricochet::closed_form {

namespace detail {

/// delta^{5/4} is a damped linear oscillator in slowed time, d theta ~ delta^{1/4} dt, of ratio alpha/sqrt 5.
inline damped_oscillator tsuji_at(double damping_coefficient) {
  require("damping_coefficient", damping_coefficient, non_negative);
  return damped_oscillator(damping_coefficient / std::sqrt(5.));
}

} // namespace detail

/// Restitution of a contact that ends where the force vanishes.
/// e = exp(-zeta acos(2 zeta^2 - 1)/sqrt(1 - zeta^2)), acosh and sqrt(zeta^2 - 1) for zeta > 1, e^-2 at 1; zeta =
/// alpha/sqrt 5 damping_coefficient: alpha, dimensionless, >= 0. Valid for every alpha; the same at every speed.
/// Source: Tsuji et al. 1992 with the end of Schwager & Poeschel 2007; written as 2 acos(zeta), stable through zeta
/// = 1.
inline double restitution_to_zero_force(double damping_coefficient) {
  return detail::tsuji_at(damping_coefficient).restitution_to_zero_force();
}

/// Restitution of a contact that pulls until the overlap vanishes; nothing if it never does (alpha >= sqrt 5).
/// e = exp(-pi zeta/sqrt(1 - zeta^2)), zeta = alpha/sqrt 5
/// damping_coefficient: alpha, dimensionless, >= 0.
/// Valid for every alpha; the same at every speed.
/// Source: Tsuji et al. 1992; Antypov & Elliott 2011.
inline std::optional<double> restitution_to_zero_overlap(double damping_coefficient) {
  return detail::tsuji_at(damping_coefficient).restitution_to_zero_overlap();
}

/// alpha that gives this restitution where the contact ends at zero overlap.
/// alpha = -sqrt 5 ln e/sqrt(pi^2 + ln^2 e)
/// restitution: e, dimensionless, in (0, 1].
/// Valid for that end only: with the end at zero force the same alpha gives a larger restitution.
/// Source: Antypov & Elliott 2011.
inline double damping_coefficient_for(double restitution) { return std::sqrt(5.) * damping_ratio_for(restitution); }

} // namespace ricochet::closed_form
