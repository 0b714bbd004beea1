// 09 Many collisions (builds on 03): as a gas or a cloud of dust asks for them.
//
// collide() takes many impacts of one model, or many scenes in which bodies and parameters differ. They run side by
// side in SIMD lanes, each with a step and an end of its own, and on as many threads as the machine has; an outcome is
// the same to the last bit whatever company it is computed in. Here: how many grains stick, by size and speed.
//
// Try next: compile with -march=native; .threads = 1; .tolerance = 1e-10.
#include <ricochet/batch/batch.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const material& ice = materials::water_ice;
  std::mt19937 random(1);
  std::normal_distribution<> spread(0, 0.5);
  bool all_is_certain = true;
  std::printf("speed (m/s)   stuck   mean e of the others   time for each collision (us)\n");
  for (const double v : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    // [batch]
    const auto impact_of = [&](length radius) {
      const sphere grain{.solid = ice, .radius = radius};
      return scene{compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = work_of_adhesion(ice, ice)},
                           kuwabara_kono{.bulk_time = 2e-11 * seconds}),
                   impact{.speed = v * metres_per_second}};
    };
    std::vector<decltype(impact_of(length{}))> scenes;
    for (int i = 0; i < 20'000; ++i)
      scenes.push_back(impact_of(10 * std::exp(spread(random)) * micrometres));

    const auto outcomes = collide(scenes, {.tolerance = 1e-6, .progress = [](std::size_t done, std::size_t of) {
                                             std::fprintf(stderr, done < of ? "\r%zu of %zu" : "\r", done, of);
                                           }});
    // [batch]
    const auto start = std::chrono::steady_clock::now();
    collide(scenes, {.tolerance = 1e-6});
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;

    int stuck = 0;
    double sum = 0;
    for (const auto& out : outcomes) {
      stuck += out.ending == ending::captured;
      sum += out.restitution.value_or(0);
      all_is_certain &= out.error_estimate <= 1e-6;
    }
    const int count = int(outcomes.size());
    std::printf("%11.1f %6.1f%% %22.4f %30.2f\n", v, 100. * stuck / count, stuck < count ? sum / (count - stuck) : 0,
                time.count() / count);
  }
  return all_is_certain ? 0 : 1;
}
