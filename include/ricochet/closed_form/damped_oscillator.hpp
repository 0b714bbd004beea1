// The linear oscillator with linear damping, whose impacts several laws share.
#pragma once
#include <ricochet/body/validate.hpp>
#include <ricochet/number.hpp>

#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>

#include <optional>

namespace ricochet::closed_form {

namespace detail {

/// x'' + 2 zeta x' + x = 0 from x = 0, x' = 1 on: x = exp(-zeta theta) S(theta), S = sin(s theta)/s, s^2 = 1 - zeta^2,
/// sinh and zeta^2 - 1 beyond zeta = 1.
struct damped_oscillator {
  double zeta, s;

  explicit damped_oscillator(double damping_ratio)
      : zeta(damping_ratio), s(std::sqrt(std::abs(1 - zeta)) * std::sqrt(1 + zeta)) {}

  /// acos(zeta)/s, acosh(zeta)/s beyond 1: half the theta at which the force, x'', vanishes.
  double half_angle() const {
    if (s == 0)
      return 1;
    return (zeta < 1 ? std::atan2(s, zeta) : std::asinh(s)) / s;
  }

  double shape(double theta) const {
    return theta * (zeta < 1 ? boost::math::sinc_pi(s * theta) : boost::math::sinhc_pi(s * theta));
  }

  /// -x' where x'' vanishes; there cos(s theta) - zeta S = -1.
  double restitution_to_zero_force() const { return std::exp(-2 * zeta * half_angle()); }

  /// -x' where x vanishes; nothing if it never does.
  std::optional<double> restitution_to_zero_overlap() const {
    return zeta < 1 ? std::optional(std::exp(-pi<double>() * zeta / s)) : std::nullopt;
  }
};

} // namespace detail

/// Damping ratio that gives this restitution where the contact ends at zero overlap.
/// zeta = -ln e/sqrt(pi^2 + ln^2 e)
/// restitution: e, dimensionless, in (0, 1].
/// Valid for that end only: with the end at zero force the same zeta gives a larger restitution.
/// Source: restitution_to_zero_overlap() inverted.
inline double damping_ratio_for(double restitution) {
  require("restitution", restitution, range{.high = 1, .low_included = false, .high_included = true});
  const double fall = -std::log(restitution);
  return fall / std::hypot(pi<double>(), fall);
}

} // namespace ricochet::closed_form
