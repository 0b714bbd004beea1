// The equations that the peers solve, as one writes them down: mutual approach, its rate and, with a crack law, the
// contact radius over time. Each says where it starts and where it ends; T is a number or a SIMD pack of them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace peer {
using std::max;
using std::min;
using std::sqrt;
inline bool all(bool x) { return x; } // packs have theirs

/// Numbers of a pair in units in which mass, speed and force are of order one, so that a tolerance means the same for
/// approach and rate.
template <class T>
struct pair {
  T modulus, radius, mass;
};

/// What contacts without an unknown radius share.
template <class T>
struct slaved_radius {
  using number = T;
  using state = std::array<T, 2>; ///< approach, rate
  static constexpr bool in_packs = true;
  state start(const T& speed) const { return {T(0), speed}; }
  auto may_end(const state& x) const { return x[1] < T(0); }
};

/// Hertz with the damping of Kuwabara and Kono; it ends where the force vanishes.
template <class T>
struct kuwabara_kono : slaved_radius<T> {
  using typename slaved_radius<T>::state;
  pair<T> p;
  T bulk_time;
  kuwabara_kono() = default;
  kuwabara_kono(const pair<T>& numbers, const T& A) : p(numbers), bulk_time(A) {}

  T force(const state& x) const {
    return T(2) * p.modulus * sqrt(max(T(0), x[0]) * p.radius) * (T(2. / 3) * x[0] + bulk_time * x[1]);
  }
  void operator()(const state& x, state& dx, const T&) const { dx = {x[1], -force(x) / p.mass}; }
  T event(const state& x) const { return T(2. / 3) * x[0] + bulk_time * x[1]; } ///< without the vanishing factor
};

/// Hertz with the damping of Hunt and Crossley; it ends where the overlap vanishes.
template <class T>
struct hunt_crossley : slaved_radius<T> {
  using typename slaved_radius<T>::state;
  pair<T> p;
  T damping_coefficient;
  hunt_crossley() = default;
  hunt_crossley(const pair<T>& numbers, const T& c) : p(numbers), damping_coefficient(c) {}

  T force(const state& x) const {
    const T d = max(T(0), x[0]);
    return T(4. / 3) * p.modulus * sqrt(p.radius * d) * d * (T(1) + damping_coefficient * x[1]);
  }
  void operator()(const state& x, state& dx, const T&) const { dx = {x[1], -force(x) / p.mass}; }
  T event(const state& x) const { return x[0]; }
};

/// Hertz with the damping of Tsuji; it ends where the force vanishes.
template <class T>
struct tsuji : slaved_radius<T> {
  using typename slaved_radius<T>::state;
  pair<T> p;
  T damping_coefficient;
  tsuji() = default;
  tsuji(const pair<T>& numbers, const T& alpha) : p(numbers), damping_coefficient(alpha) {}

  T stiffness() const { return T(4. / 3) * p.modulus * sqrt(p.radius); }
  T force(const state& x) const {
    const T d = max(T(0), x[0]), root = sqrt(d), k = stiffness();
    return k * d * root + damping_coefficient * sqrt(p.mass * k * root) * x[1];
  }
  void operator()(const state& x, state& dx, const T&) const { dx = {x[1], -force(x) / p.mass}; }
  T event(const state& x) const { // over delta^{1/4}, which vanishes at touch
    const T d = max(T(0), x[0]), k = stiffness();
    return k * d * sqrt(sqrt(d)) + damping_coefficient * sqrt(p.mass * k) * x[1];
  }
};

/// JKR with the damping of Kuwabara and Kono, which may be zero; the radius is found from the approach by Newton's
/// method, from where it was last. It ends at the fold.
template <class T>
struct jkr_kuwabara_kono : slaved_radius<T> {
  using typename slaved_radius<T>::state;
  pair<T> p;
  T work_of_adhesion, bulk_time;
  T flattening, least_root, fold; ///< of the radius
  mutable T last;
  jkr_kuwabara_kono() = default;
  jkr_kuwabara_kono(const pair<T>& numbers, const T& w, const T& A)
      : p(numbers), work_of_adhesion(w), bulk_time(A), flattening(sqrt(2 * std::numbers::pi * w / p.modulus)) {
    const T a = std::cbrt(std::numbers::pi * w * p.radius * p.radius / (8 * p.modulus));
    least_root = sqrt(a);
    fold = a * a / p.radius - flattening * least_root;
    last = 2 * least_root;
  }

  state start(const T& speed) const {
    last = T(2) * least_root;
    return {T(0), speed};
  }
  T root_radius(const T& approach) const {
    // Near the fold, where the root is double, the parabola through it is the better start, and above the root.
    const T parabola = least_root + sqrt((approach - fold) * p.radius / T(6)) / least_root;
    T r = min(parabola, max(last, T(1.01) * least_root));
    for (int i = 0; i < 50; ++i) {
      const T cubed = r * r * r / p.radius, f = cubed * r - flattening * r - approach;
      const T step = f / max(T(4) * cubed - flattening, T(1e-6) * flattening);
      r = max(least_root, r - step);
      if (all(max(step, -step) < T(1e-10) * r)) // the next one would be its square
        break;
    }
    last = r;
    return r;
  }
  T force(const state& x) const {
    const T r = root_radius(max(x[0], fold)), a = r * r;
    return T(4. / 3) * p.modulus * a * a * a / p.radius -
           sqrt(T(8 * std::numbers::pi) * work_of_adhesion * p.modulus) * a * r +
           T(2) * bulk_time * p.modulus * a * x[1];
  }
  void operator()(const state& x, state& dx, const T&) const { dx = {x[1], -force(x) / p.mass}; }
  T event(const state& x) const { return x[0] - fold; }
};

/// Brach and Dunn's ring of adhesion, stronger on the rebound, with the damping of Hunt and Crossley; it ends where the
/// overlap vanishes.
template <class T>
struct line_force : slaved_radius<T> {
  using typename slaved_radius<T>::state;
  pair<T> p;
  T force_per_length, rebound_coefficient, damping_coefficient;
  line_force() = default;
  line_force(const pair<T>& numbers, const T& f0, const T& c_A, const T& c)
      : p(numbers), force_per_length(f0), rebound_coefficient(c_A), damping_coefficient(c) {}

  T force(const state& x) const {
    const T d = max(T(0), x[0]), a = sqrt(p.radius * d), leaving = max(T(0), -x[1]);
    return T(4. / 3) * p.modulus * a * d * (T(1) + damping_coefficient * x[1]) -
           T(2 * std::numbers::pi) * a * force_per_length * (T(1) + rebound_coefficient * leaving);
  }
  void operator()(const state& x, state& dx, const T&) const { dx = {x[1], -force(x) / p.mass}; }
  T event(const state& x) const { return x[0]; }
};

/// Greenwood's published fits of the edge's speed, as a fraction: (16) and (17) of Krijt 2013, k = 0.02.
struct published_fit {
  static constexpr double modulus_ratio = 0.02;
  struct fraction {
    double advance, slowness;
  };
  fraction rate(double ratio) const {
    constexpr double k = modulus_ratio;
    if (ratio < 0.29)
      return {0.15, ratio * std::log((1 - k) / (1 - ratio))};
    if (const double x = 1 / ratio - 1; ratio < 1)
      return {(0.1035 * x + 0.3421) * std::pow(x, 1.116), 1};
    if (const double x = ratio - 1; ratio <= 3.7)
      return {-(0.2112 * x + 0.3939) * std::pow(x, 1.1403), 1};
    return {-0.24 * ratio, std::log((1 - k) / (1 - 1 / ratio))};
  }
};

/// JKR with a crack law and the damping of Kuwabara and Kono in approach, rate and contact radius. Time is slowed where
/// the edge is fast, by sqrt(1 + (da/dt)^2/reference^2), or nobody gets through both ends of the contact.
template <class T, class Edge>
struct viscoelastic_jkr {
  using number = T;
  using state = std::array<T, 3>; ///< approach, rate, contact radius
  static constexpr bool in_packs = false;
  pair<T> p;
  T work_of_adhesion, bulk_time, speed_scale, touch_radius, modulus_ratio;
  Edge edge;

  state start(T speed) const { return {0, speed, touch_radius}; }
  T ratio(const state& x) const { // G/w, zero where the contact would be pressed together
    const T gap = std::max(T(0), x[2] * x[2] / p.radius - x[0]);
    return p.modulus * gap * gap / (2 * std::numbers::pi * std::max(x[2], T(1e-12)) * work_of_adhesion);
  }
  void operator()(const state& x, state& dx, T) const {
    const T a = x[2], reference = sqrt(p.radius);
    const auto fraction = edge.rate(std::max(ratio(x), 1.0000001 * modulus_ratio));
    const T growth = speed_scale * fraction.advance / reference;
    const T norm = 1 / std::hypot(growth, fraction.slowness), clock = fraction.slowness * norm;
    const T force = 2 * p.modulus * a * (x[0] - a * a / (3 * p.radius)) + 2 * bulk_time * p.modulus * a * x[1];
    dx = {x[1] * clock, -force / p.mass * clock, reference * growth * norm};
  }
  T event(const state& x) const { return 1 - modulus_ratio * ratio(x); }
  bool may_end(const state& x) const { return x[0] < -3 * x[2] * x[2] / p.radius; } ///< past the fold
};

/// The same equations of many collisions in the lanes of packs; objects made of numbers only.
template <template <class> class Equations, class Pack>
Equations<Pack> side_by_side(const Equations<double>* each) {
  constexpr std::size_t numbers = sizeof(Equations<double>) / sizeof(double), width = sizeof(Pack) / sizeof(double);
  static_assert(sizeof(Equations<Pack>) == numbers * sizeof(Pack));
  Equations<Pack> all;
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t i = 0; i < numbers; ++i)
      std::memcpy(reinterpret_cast<char*>(&all) + (i * width + lane) * sizeof(double),
                  reinterpret_cast<const char*>(each + lane) + i * sizeof(double), sizeof(double));
  return all;
}

} // namespace peer
