// Impact with damping in proportion to the elastic force.
#pragma once
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/closed_form/restitution_tables.hpp>

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
};

inline double damping_group(inverse_speed c, speed v) {
  require("damping_coefficient", c, non_negative);
  require("speed", v, positive);
  require("damping_coefficient * speed", double(c * v), non_negative);
  return c * v;
}

} // namespace detail

/// Restitution with F = K delta^n (1 + c d(delta)/dt), whatever n > 0.
/// ln[(1 + c v)/(1 - c e v)] = c v (1 + e); polynomials in pieces of ln(1 + c v), solved beyond; error below 1e-15
/// c: damping_coefficient, s/m, >= 0; v: speed of approach at touch, m/s, > 0.
/// Valid for every c v; overlap and force vanish together, so there is one end only.
/// Source: Hunt & Crossley 1975, integrated; for c v -> 0 it is 1 - 2cv/3, for c v -> infinity 1/(c v).
inline double restitution(inverse_speed c, speed v) {
  const double cv = detail::damping_group(c, v);
  if (cv <= detail::hunt_crossley_restitution.last)
    return detail::hunt_crossley_restitution(cv);
  return detail::hunt_crossley_impact(cv).restitution();
}

} // namespace ricochet::closed_form
