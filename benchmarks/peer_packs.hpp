// Collisions in the lanes of SIMD packs as one writes them by hand: odeint's dopri5 with packs for numbers, all lanes
// in step; and velocity Verlet with a fixed step, as discrete-element codes have it. The lanes of a pack wait for the
// slowest.
#pragma once
#include "peer_odeint.hpp"

#include <algorithm>

#include <xsimd/xsimd.hpp>

namespace peer {

using pack = xsimd::batch<double>;

inline double largest_of(const pack& x) {
  alignas(pack) std::array<double, pack::size> lanes;
  x.store_aligned(lanes.data());
  return *std::max_element(lanes.begin(), lanes.end());
}

/// Notes the restitution of lanes as they end.
struct ended_lanes {
  xsimd::batch_bool<double> mask = xsimd::batch_bool<double>(false);
  pack restitution = pack(0.);

  void note(const xsimd::batch_bool<double>& now, const pack& e) {
    restitution = xsimd::select(now & ~mask, e, restitution);
    mask = mask | now;
  }
};

/// dopri5 with the error of the worst lane; the end of a lane by Newton's method for the length of its last step.
template <class System>
pack dopri5_in_packs(const System& system, double speed, double tolerance, double longest) {
  using state = typename System::state;
  odeint::runge_kutta_dopri5<state, double, state, pack, odeint::array_algebra, odeint::default_operations,
                             odeint::never_resizer>
      stepper;
  state x = system.start(pack(speed)), slope, next, next_slope, error;
  system(x, slope, pack(0.));
  ended_lanes ended;
  double t = 0, h = 1e-2;
  while (t < longest && !all(ended.mask)) {
    stepper.do_step(std::cref(system), x, slope, pack(0.), next, next_slope, pack(h), error);
    pack relative = pack(0.);
    for (std::size_t i = 0; i < x.size(); ++i)
      relative = max(relative, abs(error[i]) / (pack(1.) + abs(x[i]) + pack(h) * abs(slope[i])));
    const double worst = largest_of(xsimd::select(ended.mask, pack(0.), relative)) / tolerance;
    if (!(worst <= 1)) {
      h *= std::max(0.9 * std::pow(worst, -1. / 3), 0.2);
      continue;
    }
    const auto ending = system.may_end(next) & (system.event(next) <= pack(0.)) & ~ended.mask;
    if (xsimd::any(ending)) {
      pack part = pack(h);
      state end, end_slope, beside;
      for (int i = 0; i < 8; ++i) {
        stepper.do_step(std::cref(system), x, slope, pack(0.), end, end_slope, part);
        for (std::size_t j = 0; j < x.size(); ++j)
          beside[j] = end[j] + pack(1e-7) * end_slope[j];
        const pack change = system.event(end) * pack(1e-7) / (system.event(beside) - system.event(end));
        part = xsimd::select(ending, part - change, part);
        if (all((abs(change) < pack(1e-13)) | ~ending))
          break;
      }
      ended.note(ending, -end[1] / pack(speed));
    }
    x = next;
    slope = next_slope;
    t += h;
    if (worst < 0.5)
      h *= std::min(0.9 * std::pow(std::max(worst, 1e-5), -1. / 5), 5.);
  }
  return ended.restitution;
}

/// Velocity Verlet in steps of `step` contact times, the damping force taken at the last half step's rate; the end by
/// linear interpolation within the last step.
template <class System>
pack verlet_in_packs(const System& system, double speed, double step, double longest) {
  using state = typename System::state;
  state x = system.start(pack(speed)), slope;
  system(x, slope, pack(0.));
  const double h = 2.87 * step; // these scenes' Hertzian contact times are near 2.87
  ended_lanes ended;
  for (double t = 0; t < longest && !all(ended.mask); t += h) {
    const state before = x;
    x[1] += pack(h / 2) * slope[1];
    x[0] += pack(h) * x[1];
    system(x, slope, pack(0.));
    x[1] += pack(h / 2) * slope[1];
    const auto ending = system.may_end(x) & (system.event(x) <= pack(0.));
    const pack high = system.event(before), part = high / (high - system.event(x));
    ended.note(ending, -(before[1] + part * (x[1] - before[1])) / pack(speed));
  }
  return ended.restitution;
}

} // namespace peer
