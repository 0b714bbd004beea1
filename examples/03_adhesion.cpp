// 03 Adhesion (builds on 01): below a certain speed the spheres stick.
//
// JKR without other losses has a closed form, so that the sticking speed can be compared with the one found by a root
// search on the ending.
//
// The last lines say how far the range of adhesion matters: JKR is the limit of soft, large spheres.
//
// Try next: add kuwabara_kono{...} and see the sticking speed rise; ask for extremes{} and compare the largest tension
// with the pull-off force, 1.5 pi w R.
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/regime.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const energy_per_area w = work_of_adhesion(grain.solid, grain.solid);
  const contact_pair pair = between(grain, grain);
  const auto model = compose(pair, hertz{}, jkr{.work_of_adhesion = w});

  for (const double v : {1.0, 1.5, 2.0, 4.0, 8.0}) {
    const auto out = collide(model, impact{.speed = v * metres_per_second});
    std::printf("%4g m/s  %-10s e = %.10f\n", v, name_of(out.ending), out.restitution.value_or(0));
  }
  const auto found = sticking_speed(model, 0.1 * metres_per_second, 100.0 * metres_per_second);
  const speed exact = closed_form::sticking_speed(pair, w);
  std::printf("sticks up to %.10f m/s (closed form %.10f)\n", in_si(found.value()), in_si(exact));

  // [range]
  for (const double z0 : {0.1, 1.0, 10.0}) {
    const maugis_dugdale adhesion{.work_of_adhesion = w, .interaction_range = z0 * nanometres};
    const auto out = collide(compose(pair, hertz{}, adhesion), impact{.speed = 2.0 * metres_per_second});
    std::printf("range %4g nm, Tabor number %5.2f: e = %.6f\n", z0,
                closed_form::tabor_number(pair, w, adhesion.interaction_range), out.restitution.value_or(0));
  }
  // [range]
  return std::abs(found.value() / exact - 1) < 1e-9 ? 0 : 1;
}
