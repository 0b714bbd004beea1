#pragma once
#include <ricochet/model/reduced_model.hpp>

namespace ricochet {

/// How far an edge much faster than the bodies lags behind the static one, at unit speed of the bodies, to lowest
/// order.
template <class Reduced>
class fast_edge {
  using T = typename Reduced::number;
  using real = real_of<T>;

public:
  explicit fast_edge(const Reduced& model) {
    const real a = value_of(T(model.adhesion.fold_radius(model.pair))), R = value_of(T(model.pair.reduced_radius));
    const real scale = value_of(T(model.crack.speed_scale(model.pair, model.adhesion.work_of_adhesion)));
    const real half_size = sqrt(sqrt(R)) / 2;
    excess_ = settled([&](const real& slope) { return excess_at(slope, model); }, model);
    // Past the fold a = a_c(1 + xi), delta = delta_c - 2a_c^2/R tau: d(xi)/d(tau) = -K (beta - 1), beta - 1 = 3 xi^2/4
    // + tau, of the size of the tau at which 3/4 K tau^2 is 1/(K tau).
    const auto stiffness = [&](const real& slope) { return 2 * a / R * scale * slope; };
    lag_ = settled([&](const real& slope) { return cbrt(4 / (3 * square(stiffness(slope)))); }, model);
    const real width = stiffness(mean_slope(model, lag_)) * square(lag_); // of xi
    least_clock_ = 6 * a * sqrt(a) / R * width * half_size;               // d(delta)/dy = 6 a_c^{3/2} xi/R
  }

  /// Is excess() less than this? Without all the rest.
  static bool excess_below(const real& bound, const Reduced& model) {
    return excess_at(mean_slope(model, bound), model) < bound;
  }

  /// |beta - 1| of an edge that moves as the bodies make it do.
  const real& excess() const { return excess_; }
  /// beta - 1 where JKR's edge lets go.
  const real& lag() const { return lag_; }
  /// dt/d(sigma) there.
  const real& least_clock() const { return least_clock_; }

  /// Energy that the edge takes beyond a static one, at most; w: work of adhesion. Where it lets go 6 pi a_c^2 w lag,
  /// of which it takes three fifths in tests/solve/edge/fast_edge.cpp, and on the way over the radii of a collision.
  real loss(const Reduced& model) const {
    const real w = value_of(T(model.adhesion.work_of_adhesion)), R = value_of(T(model.pair.reduced_radius));
    const real a = value_of(T(model.adhesion.fold_radius(model.pair)));
    return pi<real>() * w * (6 * a * a * lag_ + 8 * R * excess_);
  }

private:
  static real excess_at(const real& mean_slope, const Reduced& model) {
    const real scale = value_of(T(model.crack.speed_scale(model.pair, model.adhesion.work_of_adhesion)));
    const real y = sqrt(value_of(T(model.adhesion.equilibrium_radius(model.pair))));
    return y * sqrt(sqrt(value_of(T(model.pair.reduced_radius)))) / (scale * mean_slope);
  }

  /// Speed over beta - 1, in units of the law's scale.
  static real mean_slope(const Reduced& model, const real& excess) {
    const real x = min<real>(excess, real(0.01f));
    const auto edge = rate_anywhere<T>(model.crack, T(sqrt(1 + x)));
    return -value_of(T(edge.advance / edge.slowness)) / x;
  }

  /// beta - 1 of which f(mean slope up to there) is what one began with.
  template <class Function>
  static real settled(const Function& f, const Reduced& model) {
    real x = real(0.001f);
    for (int i = 0; i < 40; ++i)
      x = sqrt(x * f(mean_slope(model, x)));
    return x;
  }

  real excess_ = 0, lag_ = 0, least_clock_ = 0;
};

} // namespace ricochet
