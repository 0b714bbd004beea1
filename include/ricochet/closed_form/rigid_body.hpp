// Rigid-body impact of a spinning sphere [Brach & Dunn 1995, app. A], second part: where the coefficients come from -
// speed, friction, energy, attachment, measured velocities - and what they say of adhesion.
#pragma once
#include <ricochet/closed_form/rigid_body_motion.hpp>

namespace ricochet::closed_form::rigid_body {

struct tangential_outcome {
  double impulse_ratio;
  bool rolls; ///< at the end; else it slides
};

/// The two "works of adhesion", as energies >= 0 that the sphere loses.
struct adhesion_works {
  energy of_impulse;         ///< what the impulse of adhesion takes
  energy by_restitution;     ///< what the energy of restitution falls short of that without adhesion, (A33)
  energy restoring_withheld; ///< their difference: work that the impulse of deformation no longer does
};

/// Restitution of a material without adhesion, falling with speed.
/// R = k/(k + |v_n|)
/// reference_speed: k, m/s, > 0 (about 130 for silver-coated glass on steel); v: speed of approach, m/s, >= 0.
/// Valid as a fit to rebounds so fast that adhesion hardly counts.
/// Source: Brach & Dunn 1995, 'Example Application', after (1).
inline double restitution_without_adhesion(speed reference_speed, speed v) {
  require("reference_speed", reference_speed, positive);
  require("speed", v, non_negative);
  return reference_speed / (reference_speed + v);
}

/// Impulse ratio by Coulomb friction, without moment, and how the contact ends; c.impulse_ratio is not used.
/// mu = sgn(mu_0) min(f, |mu_0|)
/// Parameters as restitution(), c.moment_coefficient = 0; friction_coefficient: f >= 0.
/// Valid for one coefficient of sliding and sticking; with a moment see impulse_ratio_bounds().
/// Source: Brach & Dunn 1995, text after (1) and after (A28); the sign, that of mu_0, is left open there.
inline tangential_outcome coulomb_impulse_ratio(const solid_sphere& body, const velocities& before,
                                                const coefficients& c, double friction_coefficient,
                                                const external_impulses& external = {}) {
  require("friction_coefficient", friction_coefficient, non_negative);
  require("moment_coefficient", c.moment_coefficient, range{.high = 0, .high_included = true});
  const double limit = limiting_impulse_ratio(body, before, c, external);
  const bool rolls = friction_coefficient >= std::abs(limit);
  return {rolls ? limit : std::copysign(friction_coefficient, limit), rolls};
}

/// Impulse ratios with which the impact gains no energy; c.impulse_ratio is not used.
/// |mu - mu_0| <= sqrt(2 b/7)/(1 + e), b = 2 T_L(mu_0)/(m v^2)
/// Parameters as restitution(); mu_m opposes omega (mu_m omega <= 0) and is not so large that no ratio loses energy.
/// Valid without external impulses, whose work is unknown; without moment friction's own |mu| <= |mu_0| is narrower.
/// Source: Brach & Dunn 1995, after (A28), asks for such a bound without giving it; T_L(mu) >= 0 solved for mu.
inline bounds impulse_ratio_bounds(const solid_sphere& body, const velocities& before, const coefficients& c) {
  const auto at = detail::reduce(body, before, c, {});
  if (at.spin != 0)
    require("moment_coefficient", c.moment_coefficient,
            at.spin > 0 ? range{.low = detail::finite.low, .high = 0, .low_included = false, .high_included = true}
                        : non_negative);
  detail::require_moment_that_loses(at, body, c);
  return at.ratios_that_lose();
}

/// Both energies that the paper calls work of adhesion.
/// of_impulse = R^2 rho (1 - rho) T, by_restitution = (R^2 - e^2) T, restoring_withheld = R^2 rho T; T = m v^2/2
/// Parameters as restitution().
/// Valid for the normal motion without external impulses.
/// Source: Brach & Dunn 1995, after (A31), there negative as work done on the sphere; (A33), (A34), the latter in table
/// 1 with the energy of spin counted to T.
inline adhesion_works works_of_adhesion(const solid_sphere& body, const velocities& before, const coefficients& c) {
  detail::validate(body, before);
  detail::validate(c);
  const double rho = c.adhesion_coefficient;
  const energy restored = 0.5 * body.mass * square(before.normal) * square(c.restitution_without_adhesion);
  return {.of_impulse = rho * (1 - rho) * restored,
          .by_restitution = rho * (2 - rho) * restored,
          .restoring_withheld = rho * restored};
}

/// Coefficients with which the sphere comes to rest altogether.
/// rho = 1, mu = -v_t/v, mu_m a_c = r (mu - 2 r omega/(5 v))
/// body: kg, m; before: m/s, 1/s; restitution_without_adhesion: R in [0, 1]; moment_arm: a_c, m, > 0.
/// Valid without external impulses; for v_t omega < -2/5 r omega^2 (backspin) the moment cannot oppose omega.
/// Source: Brach & Dunn 1995, 'Attachment', 1.-3.; print has mu smaller by 1 + R and another factor of the moment, with
/// which (A22), (A23) leave motion.
inline coefficients attachment(const solid_sphere& body, const velocities& before, double restitution_without_adhesion,
                               length moment_arm) {
  detail::validate(body, before);
  require("restitution_without_adhesion", restitution_without_adhesion, detail::fraction);
  require("moment_arm", moment_arm, positive);
  const double ratio = -before.tangential / before.normal;
  return {restitution_without_adhesion, 1, ratio,
          (ratio - 0.4 * double(body.radius * before.angular / before.normal)) * (body.radius / moment_arm),
          moment_arm};
}

/// Coefficients of a measured impact; velocities tell e = R(1 - rho) and mu_m a_c only, so R and a_c must be known.
/// rho = 1 - e/R, mu = (V_t - v_t)/((1 + e) v), mu_m a_c = mu r - 2 r^2 (omega - Omega)/(5 (1 + e) v)
/// body: kg, m; before, after: m/s, 1/s; restitution_without_adhesion: R in (0, 1], >= e; moment_arm: a_c, m, > 0.
/// Valid without external impulses; says nothing of friction or energy: after_impact() refuses what gains energy.
/// Source: Brach & Dunn 1995 (A21)-(A23) solved for the coefficients.
inline coefficients from_velocities(const solid_sphere& body, const velocities& before, const velocities& after,
                                    double restitution_without_adhesion, length moment_arm) {
  detail::validate(body, before);
  require("normal velocity after impact", after.normal,
          range{.low = detail::finite.low, .high = 0, .low_included = false, .high_included = true});
  require("tangential velocity after impact", after.tangential, detail::finite);
  require("angular velocity after impact", after.angular, detail::finite);
  require("restitution_without_adhesion", restitution_without_adhesion,
          range{.high = 1, .low_included = false, .high_included = true});
  require("moment_arm", moment_arm, positive);
  const speed change = before.normal - after.normal;
  const double e = -after.normal / before.normal, ratio = (after.tangential - before.tangential) / change;
  double adhesion = 1 - e / restitution_without_adhesion;
  if (std::abs(adhesion) <= 4 * std::numeric_limits<double>::epsilon()) // round-off of e = R
    adhesion = 0;
  require("adhesion_coefficient", adhesion, detail::fraction);
  const double moment = ratio - 0.4 * double(body.radius * (before.angular - after.angular) / change);
  return {restitution_without_adhesion, adhesion, ratio, moment * (body.radius / moment_arm), moment_arm};
}

} // namespace ricochet::closed_form::rigid_body
