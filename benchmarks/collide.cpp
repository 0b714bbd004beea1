// Time of one collision by integration, for compositions of laws and tolerances.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace {
using namespace ricochet;
using namespace ricochet::units;

template <class Model>
void time_of(const std::string& name, const Model& model) {
  for (const int digits : {4, 6, 8, 10}) {
    const auto run = [model, digits](benchmark::State& state) {
      const collide_options options{.tolerance = std::pow(10., -digits)};
      const impact at{8.0 * metres_per_second};
      double evaluations = 0;
      for (auto _ : state) {
        const auto out = integrate(model, at, options);
        benchmark::DoNotOptimize(out.restitution);
        evaluations = double(out.evaluations);
      }
      state.counters["evaluations"] = evaluations;
    };
    benchmark::RegisterBenchmark((name + "/1e-" + std::to_string(digits)).c_str(), run)->Unit(benchmark::kMicrosecond);
  }
}
} // namespace

int main(int argc, char** argv) {
  const material ice{
      .youngs_modulus = 7.0 * gigapascals, .poissons_ratio = 0.25, .mass_density = 1000.0 * kilograms_per_cubic_metre};
  const sphere grain{ice, 2.0 * micrometres};
  const contact_pair pair = between(grain, grain);
  const duration relaxation_time = 1e-11 * seconds;
  const jkr adhesion{.work_of_adhesion = 0.74 * joules_per_square_metre};
  const kuwabara_kono bulk{.bulk_time = bulk_time_of_krijt(relaxation_time, ice.poissons_ratio)};
  const greenwood edge{
      .relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres};
  const greenwood_fit fit{
      .relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres};

  time_of("hertz+kuwabara_kono", compose(pair, hertz{}, bulk));
  time_of("hertz+hunt_crossley",
          compose(pair, hertz{}, hunt_crossley{.damping_coefficient = 0.05 * seconds_per_metre}));
  time_of("hertz+jkr", compose(pair, hertz{}, adhesion));
  time_of("hertz+jkr+kuwabara_kono", compose(pair, hertz{}, adhesion, bulk));
  time_of("hertz+jkr+greenwood", compose(pair, hertz{}, adhesion, edge));
  time_of("hertz+jkr+greenwood+kuwabara_kono", compose(pair, hertz{}, adhesion, edge, bulk));
  time_of("hertz+jkr+greenwood_fit", compose(pair, hertz{}, adhesion, fit));

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
