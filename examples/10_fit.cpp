// 10 Fit (builds on 04): from measured restitutions to the material, and which measurements tell what.
//
// Twenty speeds are "measured" with an error of 0.01; the three parameters that Krijt et al. 2013 seek, w, T_vis and Y,
// come back with their intervals. Then the derivatives say at which speed a measurement determines which of them.
//
// Try next: leave out the fastest speeds and see what becomes of the yield strength; give the same parameters to
// another composition and compare chi_square.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/fit/fit.hpp>
#include <ricochet/study/sweep.hpp>

#include <cstdio>
#include <random>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  // [family]
  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const greenwood edge{.modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres};
  const auto table = std::make_shared<const greenwood_table>(edge.modulus_ratio); // made once, for all that follows

  const auto family = [&](const std::array<double, 3>& p) {
    greenwood moving = edge;
    moving.relaxation_time = p[1] * seconds;
    moving.table = table;
    return compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = p[0] * joules_per_square_metre}, moving,
                   kuwabara_kono{.bulk_time = bulk_time_of_krijt(moving.relaxation_time, 0.25)},
                   thornton_ning{.yield_strength = p[2] * pascals});
  };
  const std::array free{free_parameter{.name = "work_of_adhesion", .low = 0.05, .high = 2},
                        free_parameter{.name = "relaxation_time", .low = 1e-13, .high = 1e-9},
                        free_parameter{.name = "yield_strength", .low = 2e7, .high = 2e9}};
  // [family]

  const std::array<double, 3> truth{0.7, 1.2e-11, 2e8};
  std::mt19937_64 source(1);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<measurement> data;
  for (const speed& v : logarithmic_speeds(2.0 * metres_per_second, 60.0 * metres_per_second, 20)) {
    auto e = collide(family(truth), impact{.speed = v}).restitution;
    if (e)
      *e = std::max(0., *e + noise(source));
    // [data]
    data.push_back({.speed = v, .restitution = e, .error = 0.01});
    // [data]
  }

  // [fit]
  const fit_result found = fit(family, data, free);
  for (const fitted_parameter& p : found.parameters)
    std::printf("%-16s = %.4g, 95 %% between %.4g and %.4g\n", p.name.c_str(), p.value, p.low, p.high);
  std::printf("chi^2 = %.1f of %d degrees of freedom\n", found.chi_square, found.degrees_of_freedom);
  for (const std::string& warning : found.warnings)
    std::printf("%s\n", warning.c_str());
  // [fit]

  // [sensitivities]
  const auto model = family({found.parameters[0].value, found.parameters[1].value, found.parameters[2].value});
  for (const double v : {3.0, 6.0, 12.0, 40.0}) {
    const auto e = sensitivities(model, impact{.speed = v * metres_per_second});
    std::printf("%4g m/s: ", v);
    for (const sensitivity& by : e.by)
      if (by.quantity == "work_of_adhesion" || by.quantity == "relaxation_time" || by.quantity == "yield_strength")
        std::printf(" %+.4f by ln %s", by.relative(), by.quantity.c_str());
    std::printf("\n");
  }
  // [sensitivities]

  for (std::size_t k = 0; k < truth.size(); ++k)
    if (!(found.parameters[k].low < truth[k] && truth[k] < found.parameters[k].high)) {
      std::printf("%s is not in its interval\n", free[k].name.c_str()); // as one in twenty is not
      return 1;
    }
}
