// The equations of composed models written out by hand, in the same coordinates and the same slowed time, without
// anything that the model has not: what a scene should cost.
#pragma once
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace by_hand {

/// What a method of integration asks of a system, around equations `derivative(x, dx)`.
template <class Equations, std::size_t size>
struct motion {
  using state_type = std::array<double, size>;
  using number = double;
  using real = double;
  const Equations& equations;
  bool outside = false;
  void operator()(const state_type& x, state_type& dx, double) { outside |= !equations.derivative(x, dx); }
};

/// Hertz in y = a, dt = (2y/R) d(sigma); the constants as the reduced model has them.
struct hertz {
  static constexpr std::size_t size = 2;
  double modulus, per_radius, per_mass;
  template <class Numbers>
  explicit hertz(const Numbers& n)
      : modulus(n.pair.reduced_modulus), per_radius(1 / double(n.pair.reduced_radius)),
        per_mass(1 / double(n.pair.reduced_mass)) {}
};

struct hertz_kuwabara_kono : hertz {
  double bulk_time;
  template <class Numbers>
  explicit hertz_kuwabara_kono(const Numbers& n) : hertz(n), bulk_time(n.damping.bulk_time) {}
  bool derivative(const std::array<double, 2>& x, std::array<double, 2>& dx) const {
    const double y = x[0], rate = x[1];
    const double force = 4. / 3 * modulus * y * y * y * per_radius + 2 * bulk_time * modulus * y * rate;
    dx = {rate, -force * (2 * y * per_radius) * per_mass};
    return true;
  }
};

struct hertz_hunt_crossley : hertz {
  double coefficient;
  template <class Numbers>
  explicit hertz_hunt_crossley(const Numbers& n) : hertz(n), coefficient(n.damping.damping_coefficient) {}
  bool derivative(const std::array<double, 2>& x, std::array<double, 2>& dx) const {
    const double y = x[0], rate = x[1];
    const double force = 4. / 3 * modulus * y * y * y * per_radius * (1 + coefficient * rate);
    dx = {rate, -force * (2 * y * per_radius) * per_mass};
    return true;
  }
};

/// JKR in y = sqrt(a), dt = (4y^3/R - c) d(sigma).
struct jkr : hertz {
  double flattening, pull; ///< pull: sqrt(8 pi w E*)
  template <class Numbers>
  explicit jkr(const Numbers& n)
      : hertz(n), flattening(std::sqrt(2 * std::numbers::pi * n.adhesion.work_of_adhesion / modulus)),
        pull(std::sqrt(8 * std::numbers::pi * n.adhesion.work_of_adhesion * modulus)) {}
  bool derivative(const std::array<double, 2>& x, std::array<double, 2>& dx) const {
    const double y = x[0], a = y * y;
    const double force = 4. / 3 * modulus * a * a * a * per_radius - pull * a * y;
    dx = {x[1], -force * (4 * a * y * per_radius - flattening) * per_mass};
    return true;
  }
};

struct jkr_kuwabara_kono : jkr {
  double bulk_time;
  template <class Numbers>
  explicit jkr_kuwabara_kono(const Numbers& n) : jkr(n), bulk_time(n.damping.bulk_time) {}
  bool derivative(const std::array<double, 2>& x, std::array<double, 2>& dx) const {
    const double y = x[0], rate = x[1], a = y * y;
    const double force = 4. / 3 * modulus * a * a * a * per_radius - pull * a * y + 2 * bulk_time * modulus * a * rate;
    dx = {rate, -force * (4 * a * y * per_radius - flattening) * per_mass};
    return true;
  }
};

/// A free edge, opening, in y = sqrt(a), rate and approach; dt = d(sigma)/sqrt(1 + (dy/dt)^2/reference^2).
struct opening_edge : jkr_kuwabara_kono {
  static constexpr std::size_t size = 3;
  double per_flattening, reference, edge_speed;
  ricochet::greenwood_law<ricochet::reduced<double>> edge;
  template <class Numbers>
  explicit opening_edge(const Numbers& n)
      : jkr_kuwabara_kono(n), per_flattening(1 / flattening),
        reference(std::sqrt(std::sqrt(double(n.pair.reduced_radius))) / 2),
        edge_speed(n.crack.speed_scale(n.pair, n.adhesion.work_of_adhesion) / (2 * reference)), edge(n.crack) {}
  bool derivative(const std::array<double, 3>& x, std::array<double, 3>& dx) const {
    const double y = x[0], rate = x[1], approach = x[2], a = y * y, flat = a * a * per_radius;
    const double root_ratio = (flat - approach) * per_flattening / y;
    if (!(y > 0 && root_ratio > 0))
      return false;
    const auto speed = edge.rate(root_ratio, 1);
    const double advance = edge_speed * speed.advance, delay = speed.slowness * y;
    const double norm = 1 / std::sqrt(delay * delay + advance * advance), clock = delay * norm;
    const double force = 2 * modulus * a * (approach - 1. / 3 * flat) + 2 * bulk_time * modulus * a * rate;
    dx = {reference * advance * norm, -force * clock * per_mass, rate * clock};
    return speed.slowness >= 0 || approach < -3 * flat;
  }
};

} // namespace by_hand
