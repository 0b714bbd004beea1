// Oblique impact of a spinning sphere on a fixed flat wall, by the impulses of a rigid body; first part: its motion.
// Brach & Dunn 1995, appendix A, with normal velocities > 0 while closing (the paper's -v_n); tangential and angular
// ones as there: the contact point moves at v_t - r omega. Impulses are > 0 away from the wall. The moment of adhesion
// is M_A = mu_m a_c P_n, on which the paper's results (A23), (A26), (A27) and (A29) rest. Its definition is another,
// (A15) and (A16), M_A = mu_m a_c P_D: multiply such a mu_m by (1 + R)/(1 + e).
#pragma once
#include <ricochet/body/sphere.hpp>

#include <optional>

namespace ricochet::closed_form::rigid_body {

/// Homogeneous: radius of gyration squared = 2/5 r^2. Both > 0.
struct solid_sphere {
  ricochet::mass mass;
  length radius;
};

/// Before or after the impact: normal > 0 closing, < 0 leaving.
struct velocities {
  speed normal, tangential;
  angular_speed angular;
};

struct coefficients {
  double restitution_without_adhesion = 1; ///< R in [0, 1], of the impulses of deformation (A11)
  double adhesion_coefficient = 0;         ///< rho in [0, 1], impulse of adhesion over that of deformation (A14)
  double impulse_ratio = 0;                ///< mu, signed: tangential over normal impulse (A20)
  double moment_coefficient = 0;           ///< mu_m, signed: > 0 raises the angular velocity
  length moment_arm{};                     ///< a_c >= 0; only mu_m a_c counts

  length moment_per_impulse() const { return moment_coefficient * moment_arm; }
};

/// Known impulses of other forces during the two phases (P_E), > 0 away from the wall.
struct external_impulses {
  momentum approach{}, rebound{};
};

/// Closed range of a ratio.
struct bounds {
  double lowest, highest;
};

namespace detail {

inline constexpr range finite{.low = -std::numeric_limits<double>::infinity(), .low_included = false};
inline constexpr range fraction{.high = 1, .high_included = true};

inline void validate(const solid_sphere& body, const velocities& before) {
  require("mass", body.mass, positive);
  require("radius", body.radius, positive);
  require("normal velocity before impact", before.normal, positive);
  require("tangential velocity before impact", before.tangential, finite);
  require("angular velocity before impact", before.angular, finite);
}

inline void validate(const coefficients& c) {
  require("restitution_without_adhesion", c.restitution_without_adhesion, fraction);
  require("adhesion_coefficient", c.adhesion_coefficient, fraction);
  require("impulse_ratio", c.impulse_ratio, finite);
  require("moment_coefficient", c.moment_coefficient, finite);
  require("moment_arm", c.moment_arm, non_negative);
}

/// The impact in units of mass, radius and speed of approach v: tau = v_t/v, spin = r omega/v, moment = mu_m a_c/r.
struct reduced_impact {
  double restitution, tangential, spin, moment;

  double slip() const { return tangential - spin; }
  double limiting_ratio() const { return 5 * moment / 7 - 2 * slip() / (7 * (1 + restitution)); }
  double initial_energy() const { return 1 + square(tangential) + 0.4 * square(spin); }
  /// 2 T_L/(m v^2)
  double loss(double ratio) const {
    const double n = 1 + restitution;
    return n * (1 - restitution - n * square(ratio) - 2 * ratio * slip() - 2.5 * n * square(ratio - moment) -
                2 * moment * spin);
  }
  /// The loss is a parabola about the limiting ratio: loss(mu) = loss(mu_0) - 7/2 (1 + e)^2 (mu - mu_0)^2.
  bounds ratios_that_lose() const {
    const double limit = limiting_ratio();
    const double half = std::sqrt(std::max(0., 2 * loss(limit) / 7)) / (1 + restitution);
    return {limit - half, limit + half};
  }
  /// Where loss(mu_0), a parabola in the moment, is not negative.
  bounds moments_that_lose() const {
    const double middle = -(tangential + 0.4 * spin);
    const double half = std::sqrt(square(middle) + 1.4 * (1 - square(restitution)) + 0.4 * square(slip()));
    return {(middle - half) / (1 + restitution), (middle + half) / (1 + restitution)};
  }
};

inline range closed(bounds b) { return {.low = b.lowest, .high = b.highest, .high_included = true}; }

inline void require_moment_that_loses(const reduced_impact& at, const solid_sphere& body, const coefficients& c) {
  if (c.moment_coefficient == 0 || c.moment_arm == length())
    return;
  const double arm = c.moment_arm / body.radius;
  const bounds allowed = at.moments_that_lose();
  require("moment_coefficient", c.moment_coefficient, closed({allowed.lowest / arm, allowed.highest / arm}));
}

/// Round-off may make an impact without losses gain this part of the initial energy.
inline constexpr double round_off = 1e-12;

} // namespace detail

/// Restitution with adhesion and external impulses, V_n/v.
/// e = R(1 - rho)(1 - P_E^A/(m v)) + P_E^R/(m v)
/// body: kg, m; before: m/s, 1/s; c: ratios; external: N s, on approach <= m v, on rebound too weak to hold the sphere.
/// Valid for external impulses that the impact does not change.
/// Source: Brach & Dunn 1995 (A5), (A8), (A11), (A14), solved with P_E, which print drops from (A21) on.
inline double restitution(const solid_sphere& body, const velocities& before, const coefficients& c,
                          const external_impulses& external = {}) {
  detail::validate(body, before);
  detail::validate(c);
  const momentum arriving = body.mass * before.normal;
  require("external impulse of approach", external.approach,
          {.low = detail::finite.low, .high = in_si(arriving), .low_included = false, .high_included = true});
  const momentum restored =
      (1 - c.adhesion_coefficient) * c.restitution_without_adhesion * (arriving - external.approach);
  require("external impulse of rebound", external.rebound, {.low = 0 - in_si(restored)});
  return (restored + external.rebound) / arriving;
}

namespace detail {
inline reduced_impact reduce(const solid_sphere& body, const velocities& before, const coefficients& c,
                             const external_impulses& external) {
  return {restitution(body, before, c, external), before.tangential / before.normal,
          body.radius * before.angular / before.normal, c.moment_per_impulse() / body.radius};
}
} // namespace detail

/// Velocity of the sphere's contact point along the wall; zero while it rolls.
/// V_C = v_t - r omega
/// body: kg, m; at: velocities before or after, m/s, 1/s.
/// Valid always.
/// Source: Brach & Dunn 1995, before (A26).
inline speed contact_point_velocity(const solid_sphere& body, const velocities& at) {
  return at.tangential - body.radius * at.angular;
}

/// Impulse ratio that just makes the sphere roll at the end; c.impulse_ratio is not used.
/// mu_0 = 5 mu_m a_c/(7 r) + 2 eta/(7 (1 + e)), eta = -(v_t - r omega)/v
/// Parameters as restitution().
/// Valid for e that friction and moment do not change.
/// Source: Brach & Dunn 1995 (A27), which prints 1 - e for 1 + e: against (A26) = 0 and its own (1).
inline double limiting_impulse_ratio(const solid_sphere& body, const velocities& before, const coefficients& c,
                                     const external_impulses& external = {}) {
  return detail::reduce(body, before, c, external).limiting_ratio();
}

/// Velocities after the impact.
/// V_n = -e v, V_t = v_t + mu (1 + e) v, Omega = omega - 5 (mu r - mu_m a_c)(1 + e) v/(2 r^2)
/// Parameters as restitution(). Without external impulses, coefficients with which energy is gained are refused.
/// Valid for contacts that are short, small against r and on a wall at rest.
/// Source: Brach & Dunn 1995 (A21)-(A23); P_n = m(V_n - v_n) for -m(1 + R(1 - rho)) v_n where P_E is not zero.
inline velocities after_impact(const solid_sphere& body, const velocities& before, const coefficients& c,
                               const external_impulses& external = {}) {
  const auto at = detail::reduce(body, before, c, external);
  if (external.approach == momentum() && external.rebound == momentum() &&
      !(at.loss(c.impulse_ratio) >= -detail::round_off * at.initial_energy())) {
    detail::require_moment_that_loses(at, body, c);
    require("impulse_ratio", c.impulse_ratio, detail::closed(at.ratios_that_lose()));
  }
  const speed change = (1 + at.restitution) * before.normal;
  return {.normal = -at.restitution * before.normal,
          .tangential = before.tangential + c.impulse_ratio * change,
          .angular = before.angular - 2.5 * (c.impulse_ratio - at.moment) * change / body.radius};
}

/// Normal impulse of an impact, all forces together.
/// P_n = m(V_n - v_n)
/// body: kg, m; before, after: m/s, 1/s.
/// Valid with and without external impulses.
/// Source: Brach & Dunn 1995 (A17); the tangential one is mu P_n, the moment mu_m a_c P_n.
inline momentum normal_impulse(const solid_sphere& body, const velocities& before, const velocities& after) {
  return body.mass * (before.normal - after.normal);
}

/// Direction of rebound from the normal, radians, with the sign of V_t; nothing where the sphere does not leave.
/// alpha = atan(V_t/V_n)
/// after: m/s, 1/s.
/// Valid always.
/// Source: Brach & Dunn 1995, table 1.
inline std::optional<double> rebound_angle(const velocities& after) {
  return after.normal < speed() ? std::optional(std::atan2(in_si(after.tangential), -in_si(after.normal)))
                                : std::nullopt;
}

/// Kinetic energy of translation and spin.
/// T = m (v^2 + v_t^2)/2 + m r^2 omega^2/5
/// body: kg, m; at: m/s, 1/s.
/// Valid for a homogeneous sphere.
/// Source: Brach & Dunn 1995, table 1 (T_i).
inline energy kinetic_energy(const solid_sphere& body, const velocities& at) {
  return 0.5 * body.mass * (square(at.normal) + square(at.tangential) + 0.4 * square(speed(body.radius * at.angular)));
}

/// Kinetic energy lost in the impact, negative where external impulses add some.
/// T_L = m v^2/2 ((1 - e^2) - mu^2 n^2 + 2 mu n eta - 5/2 (mu - M)^2 n^2 - 2 M n r omega/v), n = 1 + e, M = mu_m a_c/r
/// Parameters as restitution(); eta as in limiting_impulse_ratio().
/// Valid as after_impact(); the difference of kinetic energies.
/// Source: Brach & Dunn 1995 (A29), whose fourth term lacks 1/r^2.
inline energy energy_loss(const solid_sphere& body, const velocities& before, const coefficients& c,
                          const external_impulses& external = {}) {
  return 0.5 * body.mass * square(before.normal) * detail::reduce(body, before, c, external).loss(c.impulse_ratio);
}

} // namespace ricochet::closed_form::rigid_body
