// Times in contact that need a quadrature.
#pragma once
#include <ricochet/closed_form/hunt_crossley.hpp>
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/tsuji.hpp>

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace ricochet::closed_form {

namespace detail {

/// 4 int (s^3 - 1) ds sqrt(sticking_energy/energy left), from touch to the turning point and back to the fold.
inline double duration(const jkr_impact& impact) {
  const double turning = impact.turning, excess = impact.excess;
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double precision = 1e-12; // the default, 1e-8, is too coarse for the kink that forms at the fold as v -> v_c
  const auto about_turning = [&](double q) { // q = sqrt(turning - s)
    return 2 * (cube(turning - q * q) - 1) / std::sqrt(impact.divided(turning - q * q, turning));
  };
  const auto to_turning = [&](double from) {
    return quadrature.integrate(about_turning, 0., std::sqrt(turning - from), precision);
  };
  const auto to_fold = [&](double x) { // x = s - 1
    return x * (x * x + 3 * x + 3) / std::sqrt(excess + x * x * impact.curvature_at_fold(1 + x));
  };
  return 4 * std::sqrt(impact.sticking_energy) *
         (to_turning(impact.touch) + to_turning(impact.rest) +
          quadrature.integrate(to_fold, 0., impact.rest - 1, precision));
}

/// int dL/(1 - excess(L)/stored)^{3/5} from L = end to 0; with L = end (1 - q^{5/2}) the end is not singular.
inline double leg(const hunt_crossley_impact& impact, double end) {
  return boost::math::quadrature::tanh_sinh<double>{}.integrate(
      [&](double q) {
        const double apart = end * square(q) * std::sqrt(q), l = end - apart;
        const double mean = apart == 0 ? 0 : impact.excess(apart) / apart;
        return 2.5 * std::abs(end) * std::pow(impact.stored / ((std::exp(l) * mean + std::expm1(l)) * end), 0.6);
      },
      0., 1.);
}

/// int dt of the elastic scale 0.8 delta_max/v, that is int (exp(-zeta theta) S)^{-1/5} d theta of Tsuji's law, in two
/// halves, each from its own end: S(end - phi) = S(end) cos(s phi) - S'(end) S(phi).
inline double duration(const damped_oscillator& impact, double end, double shape_at_end, double slope_at_end) {
  const double zeta = impact.zeta, s = impact.s;
  const double growth = std::exp(zeta * end / 5);
  if (std::isinf(growth))
    return growth;
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double first = quadrature.integrate(
      [&](double theta) { return std::exp(zeta * theta / 5) / std::pow(impact.shape(theta), 0.2); }, 0., end / 2);
  const double second = quadrature.integrate(
      [&](double phi) {
        const double there = zeta < 0.5 || shape_at_end == 0
                                 ? shape_at_end * std::cos(s * phi) - slope_at_end * impact.shape(phi)
                                 : impact.shape(end - phi);
        return std::exp(-zeta * phi / 5) / std::pow(there, 0.2);
      },
      0., end / 2);
  return first + growth * second;
}

} // namespace detail

/// JKR: time from touch to separation, or nothing if the bodies stay together (v <= v_c).
/// t = int d delta/|rate| over both legs, in s = sqrt(a/a_c), where neither the turning point nor the fold is singular
/// pair, w: as in sticking_speed(); v: speed of approach at touch, m/s, > 0.
/// Valid as sticking_speed(); tends to a finite time at v_c.
/// Source: energy balance with Krijt 2013 (2), (8); w = 0 is Hertz.
inline std::optional<duration> contact_duration(const contact_pair& pair, energy_per_area w, speed v) {
  require("speed", v, positive);
  const double ratio = sticking_speed(pair, w) / v;
  if (ratio == 0)
    return contact_time(pair, v);
  if (ratio >= 1)
    return std::nullopt;
  const length fold = jkr{w}.fold_radius(pair);
  return fold * (fold / pair.reduced_radius) / (ratio * v) * detail::duration(detail::jkr_impact(ratio));
}

/// Hunt-Crossley: time in contact with F = K delta^{3/2} (1 + c d(delta)/dt).
/// t = (m*/cK) int dL/delta^{3/2} over ln(1 + c v) > L > ln(1 - c e v), (2/5) K delta^{5/2} = stored energy at L
/// pair: E* (Pa), R (m), m* (kg), all > 0; c: damping_coefficient, s/m, >= 0; v: speed at touch, m/s, > 0.
/// Valid for every c v.
/// Source: Hunt & Crossley 1975, integrated; for c v -> 0 it is contact_time(pair, v).
inline duration contact_duration(const contact_pair& pair, inverse_speed c, speed v) {
  const double cv = detail::damping_group(c, v);
  const duration elastic = contact_time(pair, v);
  if (cv < std::numeric_limits<double>::epsilon())
    return elastic;
  const detail::hunt_crossley_impact impact(cv);
  const double shallower = std::pow(cv * cv / (2 * impact.stored), 0.6); // (delta_Hertz/delta_max)^{3/2}
  return 0.8 * max_approach(pair, v) / v * shallower / cv *
         (detail::leg(impact, impact.at_touch) + detail::leg(impact, impact.at_release));
}

/// Tsuji: time in contact until the force vanishes.
/// t = (4/5)(delta_Hertz/v) int (exp(-zeta theta) S(theta))^{-1/5} d theta, S = sin(s theta)/s, s^2 = 1 - zeta^2
/// pair: E* (Pa), R (m), m* (kg), all > 0; damping_coefficient: alpha, >= 0; v: speed at touch, m/s, > 0.
/// Valid for every alpha.
/// Source: Tsuji et al. 1992, integrated; alpha = 0 is contact_time(pair, v).
inline duration contact_duration_to_zero_force(const contact_pair& pair, double damping_coefficient, speed v) {
  const auto impact = detail::tsuji_at(damping_coefficient);
  const double zeta = impact.zeta;
  return 0.8 * max_approach(pair, v) / v *
         detail::duration(impact, 2 * impact.half_angle(), 2 * zeta, 2 * zeta * zeta - 1);
}

/// Tsuji: time in contact until the overlap vanishes; nothing if it never does (alpha >= sqrt 5).
/// As contact_duration_to_zero_force(), up to theta = pi/s; it grows as exp(pi zeta/5s) and overflows to infinity
/// pair: E* (Pa), R (m), m* (kg), all > 0; damping_coefficient: alpha, >= 0; v: speed at touch, m/s, > 0.
/// Valid for every alpha.
/// Source: Tsuji et al. 1992, integrated; alpha = 0 is contact_time(pair, v).
inline std::optional<duration> contact_duration_to_zero_overlap(const contact_pair& pair, double damping_coefficient,
                                                                speed v) {
  const auto impact = detail::tsuji_at(damping_coefficient);
  const length depth = max_approach(pair, v);
  if (impact.zeta >= 1)
    return std::nullopt;
  return 0.8 * depth / v * detail::duration(impact, pi<double>() / impact.s, 0, -1);
}

} // namespace ricochet::closed_form
