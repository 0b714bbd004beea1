// What a collision with a free edge costs from an edge as slow as the collision down to one infinitely fast, and how e
// tends to JKR's: two water-ice grains at 8 m/s, the exact crack law alone. Then the other end: edges slower than the
// collision, which once rang for long before they were certain to be captured.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/solve/edge/fast_edge.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace {
using namespace ricochet;
using namespace ricochet::units;

const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
const contact_pair pair = between(grain, grain);

auto scene(double relaxation_time) {
  return compose(pair, hertz{}, jkr{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)},
                 greenwood{.relaxation_time = relaxation_time * seconds,
                           .modulus_ratio = 0.02,
                           .interaction_range = 0.3 * nanometres});
}

template <class Model>
double microseconds(const Model& model, const impact& at, double tolerance) {
  double best = 1e300;
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    (void)collide(model, at, {.tolerance = tolerance});
    best = std::min(best, 1e6 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// How far beyond JKR's fold the edge lets go, in units of a constant length.
double lag(double relaxation_time, const impact& at) {
  const auto model = scene(relaxation_time);
  const reduced_model<double, decltype(scene(0))> numbers(model, scales_at(model, at.speed));
  return fast_edge(numbers).lag();
}

void fast_end(double tolerance) {
  const impact at{8.0 * metres_per_second};
  const double limit = *collide(scene(0), at, {.tolerance = 1e-12}).restitution;
  std::printf(
      "tolerance %.0e; e of JKR %.12f\n   T_vis, s  evaluations        us  e               e_JKR - e  exponent  "
      "of the lag at the fold\n",
      tolerance, limit);
  double last = 0;
  for (int decade = -11; decade >= -23; --decade) {
    const double T = std::pow(10, decade);
    const auto model = scene(T);
    const auto out = collide(model, at, {.tolerance = tolerance});
    const double e = out.restitution.value_or(0), deficit = limit - e;
    std::printf("%11.0e %12ld %9.0f  %.12f  %.3e", T, out.evaluations, microseconds(model, at, tolerance), e, deficit);
    if (last > 0)
      std::printf("  %8.3f  %8.3f", std::log10(last / deficit), std::log10(lag(10 * T, at) / lag(T, at)));
    std::printf("\n");
    last = deficit;
  }
  const auto out = collide(scene(0), at, {.tolerance = tolerance});
  std::printf("%11d %12ld %9.0f  %.12f\n", 0, out.evaluations, microseconds(scene(0), at, tolerance), *out.restitution);
}

void slow_end(double tolerance) {
  std::printf("tolerance %.0e; evaluations until separated (s), captured (c) or the budget spent (u)\n   T_vis, s",
              tolerance);
  const double speeds[] = {1, 2, 4, 8, 16, 32, 64};
  for (const double v : speeds)
    std::printf("   %3.0f m/s", v);
  for (int decade = -9; decade <= 0; ++decade) {
    std::printf("\n%11.0e", std::pow(10, decade));
    for (const double v : speeds) {
      const auto out = collide(scene(std::pow(10, decade)), impact{v * metres_per_second},
                               {.tolerance = tolerance, .max_evaluations = 300'000});
      std::printf(" %8ld%c", out.evaluations, name_of(out.ending)[0]);
    }
    std::fflush(stdout);
  }
  std::printf("\n");
}
} // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  for (const double tolerance : {1e-6, 1e-10})
    fast_end(tolerance);
  for (const double tolerance : {1e-6, 1e-10})
    slow_end(tolerance);
}
