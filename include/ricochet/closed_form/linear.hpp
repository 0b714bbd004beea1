// Impact of a linear spring with a linear dashpot.
#pragma once
#include <ricochet/closed_form/damped_oscillator.hpp>
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/linear.hpp>

namespace ricochet::closed_form {

/// An impact of this spring and this dashpot on this pair, and what comes of it, in the manner of a free function each.
/// m* delta'' + c delta' + k delta = 0, zeta = c/(2 sqrt(m* k)), s^2 = 1 - zeta^2
/// pair: m* (kg), > 0; spring: k, N/m, > 0; dashpot: c, N s/m, >= 0.
/// Valid for every zeta; the same at every speed.
/// Source: the damped oscillator, with the end of Schwager & Poeschel 2007.
class linear_impact {
public:
  linear_impact(const contact_pair& pair, const linear& spring, const linear_dashpot& dashpot)
      : motion_(ratio(pair, spring, dashpot)), time_(unit(pair, spring)) {}

  double damping_ratio() const { return motion_.zeta; }

  /// e = exp(-2 zeta acos(zeta)/s), acosh(zeta) and sqrt(zeta^2 - 1) beyond 1, e^-2 at 1.
  double restitution_to_zero_force() const { return motion_.restitution_to_zero_force(); }

  /// e = exp(-pi zeta/s); nothing for zeta >= 1.
  std::optional<double> restitution_to_zero_overlap() const { return motion_.restitution_to_zero_overlap(); }

  /// t = sqrt(m*/k) 2 acos(zeta)/s
  duration contact_duration_to_zero_force() const { return 2 * motion_.half_angle() * time_; }

  /// t = sqrt(m*/k) pi/s; nothing for zeta >= 1.
  std::optional<duration> contact_duration_to_zero_overlap() const {
    return motion_.zeta < 1 ? std::optional<duration>(pi<double>() / motion_.s * time_) : std::nullopt;
  }

private:
  static duration unit(const contact_pair& pair, const linear& spring) {
    require("reduced_mass", pair.reduced_mass, positive);
    require("stiffness", spring.stiffness, positive);
    return boost::units::root<2>(pair.reduced_mass / spring.stiffness);
  }
  static double ratio(const contact_pair& pair, const linear& spring, const linear_dashpot& dashpot) {
    require("damping_coefficient", dashpot.damping_coefficient, non_negative);
    return dashpot.damping_coefficient * unit(pair, spring) / (2.0 * pair.reduced_mass);
  }

  detail::damped_oscillator motion_;
  duration time_;
};

/// c of a damping ratio zeta: c = 2 zeta sqrt(m* k); zeta = 1 is critical, damping_ratio_for(e) gives the one of a
/// wanted restitution with end_at_zero_overlap.
/// \throws bad_input unless damping_ratio >= 0, m* > 0 and k > 0.
inline damping damping_coefficient_of(double damping_ratio, const contact_pair& pair, const linear& spring) {
  require("damping_ratio", damping_ratio, non_negative);
  require("reduced_mass", pair.reduced_mass, positive);
  require("stiffness", spring.stiffness, positive);
  const damping c = 2 * damping_ratio * boost::units::root<2>(pair.reduced_mass * spring.stiffness);
  return required("damping_coefficient", c, non_negative);
}

} // namespace ricochet::closed_form
