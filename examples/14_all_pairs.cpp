// 14 All pairs in one map (builds on 11): the restitution of any two sticky, viscous spheres in 70 nanoseconds.
//
// With Hertz, JKR and the bulk damping of Kuwabara & Kono, e depends on two numbers only: the speed and the damping,
// each in the units of the adhesion. One map over both serves grains of every size, solid and stickiness; here it is
// asked for a powder of three sizes of ice and quartz, and compared with collisions. A map of the contact duration
// tells how long one of the pairs stays together.
//
// Try next: load the map in another program, and give it a pair of your own.
#include <ricochet/collide.hpp>
#include <ricochet/study/map/jkr_map.hpp>
#include <ricochet/study/map/restitution_map.hpp>

#include <cstdio>
#include <utility>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  // [family]
  const auto map = make_jkr_map({.low = 1e-4, .high = 0.25}, {.low = 1, .high = 1e4}, {.max_error = 1e-6});
  map.save("all_pairs.map.txt");
  std::printf("%zu patches, largest error found %.1e\n", map.patches(), map.largest_error());
  // [family]

  double largest = 0;
  for (const auto& [name, solid] : {std::pair{"ice", materials::water_ice}, {"quartz", materials::quartz}})
    for (const length& radius : {0.2 * micrometres, 2.0 * micrometres, 50.0 * micrometres})
      for (const speed& v : {0.5 * metres_per_second, 5.0 * metres_per_second}) {
        // [pair]
        const contact_pair pair = between(sphere{solid, radius}, sphere{solid, radius});
        const jkr adhesive{work_of_adhesion(solid, solid)};
        const kuwabara_kono viscous{1e-10 * seconds};
        const double e = restitution_by(map, pair, adhesive, viscous, v);
        // [pair]
        const auto out = collide(compose(pair, hertz{}, adhesive, viscous), impact{v});
        const jkr_groups at = groups_of(pair, adhesive, viscous, v);
        std::printf("%6s, radius %5.1f um, at %3.1f m/s: speed %8.3f, damping %.5f, ", name, 1e6 * in_si(radius),
                    in_si(v), at.speed, at.damping);
        if (e == e) // else outside the map
          largest = std::max(largest, std::abs(e - out.restitution.value_or(0)));
        std::printf(e == e ? "e = %.6f\n" : "outside the map\n", e);
      }

  // [duration]
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  const auto model = compose(between(grain, grain), hertz{}, jkr{work_of_adhesion(grain.solid, grain.solid)},
                             kuwabara_kono{1e-10 * seconds}, contact_duration{});
  const auto time = make_duration_map(model, 0.1 * metres_per_second, 100.0 * metres_per_second, {.max_error = 1e-8});
  std::printf("at 5 m/s in contact for %.6g ns\n", 1e9 * time(5.0 * metres_per_second));
  // [duration]

  const double duration = in_si(collide(model, impact{5.0 * metres_per_second}).contact_duration);
  return largest < 1e-6 && std::abs(time(5.) / duration - 1) < 2e-8 ? 0 : 1;
}
