// Impact with damping in proportion to the elastic force.
#pragma once
#include <ricochet/closed_form/hertz.hpp>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/roots.hpp>

namespace ricochet::closed_form {

namespace detail {

/// With L = ln(1 + c rate), energy and momentum make excess(L) = e^L - 1 - L the elastic energy missing from its
/// largest.
struct hunt_crossley_impact {
  double cv, at_touch, at_release, stored; ///< L at both ends, and excess there

  explicit hunt_crossley_impact(double x) : cv(x), at_touch(std::log1p(x)), stored(-boost::math::log1pmx(x)) {
    std::uintmax_t rounds = 200;
    at_release =
        -boost::math::tools::toms748_solve([&](double l) { return excess(-l) - stored; }, at_touch / 2,
                                           2 * at_touch + stored, boost::math::tools::eps_tolerance<double>(), rounds)
             .first;
  }

  static double excess(double l) {
    return std::abs(l) < 0.5 ? -boost::math::log1pmx(std::expm1(l)) : std::expm1(l) - l;
  }

  double restitution() const { return -std::expm1(at_release) / cv; }

  /// int dL/(1 - excess(L)/stored)^{3/5} from L = end to 0; with L = end (1 - q^{5/2}) the end is not singular.
  double leg(double end) const {
    return boost::math::quadrature::tanh_sinh<double>{}.integrate(
        [&](double q) {
          const double apart = end * square(q) * std::sqrt(q), l = end - apart;
          const double mean = apart == 0 ? 0 : excess(apart) / apart;
          return 2.5 * std::abs(end) * std::pow(stored / ((std::exp(l) * mean + std::expm1(l)) * end), 0.6);
        },
        0., 1.);
  }
};

inline double damping_group(inverse_speed c, speed v) {
  require("damping_coefficient", c, non_negative);
  require("speed", v, positive);
  return c * v;
}

} // namespace detail

/// Restitution with F = K delta^n (1 + c d(delta)/dt), whatever n > 0.
/// ln[(1 + c v)/(1 - c e v)] = c v (1 + e), solved for L = ln(1 - c e v), so without cancellation; error below 1e-14
/// c: damping_coefficient, s/m, >= 0; v: speed of approach at touch, m/s, > 0.
/// Valid for every c v; overlap and force vanish together, so there is one end only.
/// Source: Hunt & Crossley 1975, integrated; for c v -> 0 it is 1 - 2cv/3, for c v -> infinity 1/(c v).
inline double restitution(inverse_speed c, speed v) {
  const double cv = detail::damping_group(c, v);
  if (cv < std::numeric_limits<double>::epsilon())
    return 1 - 2 * cv / 3;
  return detail::hunt_crossley_impact(cv).restitution();
}

/// Time in contact with F = K delta^{3/2} (1 + c d(delta)/dt).
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
         (impact.leg(impact.at_touch) + impact.leg(impact.at_release));
}

} // namespace ricochet::closed_form
