// Time of what is made of many collisions: maps of e and of durations, fits and grids of chi^2.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/fit/chi_square_grid.hpp>
#include <ricochet/study/map/jkr_map.hpp>
#include <ricochet/study/map/restitution_map.hpp>
#include <ricochet/study/sweep.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>

namespace {
using namespace ricochet;
using namespace ricochet::units;

const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
const speed slowest = 0.01 * metres_per_second, fastest = 100.0 * metres_per_second;

/// w, T_vis and Y, as Krijt et al. 2013 seek them.
struct ice_family {
  std::shared_ptr<const greenwood_table> table = std::make_shared<const greenwood_table>(0.02);

  auto operator()(const std::array<double, 3>& p) const {
    const greenwood edge{.relaxation_time = p[1] * seconds,
                         .modulus_ratio = 0.02,
                         .interaction_range = 0.3 * nanometres,
                         .table = table};
    return compose(between(grain, grain), hertz{}, jkr{p[0] * joules_per_square_metre}, edge,
                   kuwabara_kono{bulk_time_of_krijt(edge.relaxation_time, 0.25)}, thornton_ning{p[2] * pascals});
  }
};
const ice_family family;
constexpr std::array truth{0.74, 1e-11, 3e8};

std::vector<measurement> measured(std::size_t n, double error) {
  std::mt19937_64 source(1);
  std::normal_distribution<double> noise(0, error);
  std::vector<measurement> data;
  for (const speed& v : logarithmic_speeds(1.0 * metres_per_second, 60.0 * metres_per_second, n)) {
    auto e = collide(family(truth), impact{v}).restitution;
    if (e)
      *e = std::max(0., *e + noise(source));
    data.push_back({v, e, error});
  }
  return data;
}

std::vector<double> even_in_logarithm(double from, double to) {
  std::mt19937_64 source(1);
  std::uniform_real_distribution<double> uniform(std::log(from), std::log(to));
  std::vector<double> numbers(4096);
  for (double& x : numbers)
    x = std::clamp(std::exp(uniform(source)), from, to);
  return numbers;
}

/// Times of one map: made, asked one by one, in packs, and through C.
template <class Make, class Many>
void of_map(const std::string& name, const Make& make, const Many& many) {
  benchmark::RegisterBenchmark(("map/make/" + name).c_str(),
                               [make](benchmark::State& state) {
                                 std::size_t pieces = 0;
                                 for (auto _ : state)
                                   pieces = make().pieces().size();
                                 state.counters["pieces"] = double(pieces);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  const auto speeds = even_in_logarithm(in_si(slowest), in_si(fastest));
  benchmark::RegisterBenchmark(("map/ask/" + name).c_str(), [make, speeds](benchmark::State& state) {
    const auto map = make();
    std::size_t i = 0;
    for (auto _ : state)
      benchmark::DoNotOptimize(map(speeds[i++ % speeds.size()]));
  });
  benchmark::RegisterBenchmark(("map/ask in packs/" + name).c_str(), [make, many, speeds](benchmark::State& state) {
    const auto map = make();
    std::vector<double> values(speeds.size());
    for (auto _ : state) {
      many(&map, speeds.data(), values.data(), speeds.size());
      benchmark::ClobberMemory();
    }
    state.counters["each"] = benchmark::Counter(double(speeds.size()), benchmark::Counter::kIsIterationInvariantRate |
                                                                           benchmark::Counter::kInvert);
  });
}

template <class Model>
void of_restitution(const std::string& name, const Model& model) {
  of_map(
      name, [model] { return make_restitution_map(model, slowest, fastest); }, &restitution_map::restitutions);
}
template <class Model>
void of_duration(const std::string& name, const Model& model) {
  of_map(
      "duration, " + name, [model] { return make_duration_map(model, slowest, fastest); },
      &duration_map::contact_durations);
}

constexpr family_map::interval dampings{1e-4, 0.4}, reduced_speeds{1, 1e4};

void of_all_pairs() {
  benchmark::RegisterBenchmark(
      "map/make/all pairs of jkr+kuwabara_kono",
      [](benchmark::State& state) {
        std::size_t patches = 0;
        for (auto _ : state)
          patches = make_jkr_map(dampings, reduced_speeds, {.max_error = 1 / double(state.range(0))}).patches();
        state.counters["patches"] = double(patches);
      })
      ->ArgName("1/error")
      ->Arg(10'000)
      ->Arg(1'000'000)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  benchmark::RegisterBenchmark("map/ask/all pairs of jkr+kuwabara_kono", [](benchmark::State& state) {
    const auto map = make_jkr_map(dampings, reduced_speeds);
    const auto speeds = even_in_logarithm(reduced_speeds.low, reduced_speeds.high);
    auto parameters = even_in_logarithm(dampings.low, dampings.high);
    std::shuffle(parameters.begin(), parameters.end(), std::mt19937_64(2));
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(map(speeds[i], parameters[i]));
      i = (i + 1) % speeds.size();
    }
  });
}
} // namespace

int main(int argc, char** argv) {
  const auto with_edge = family(truth);
  const auto slaved = with_edge.without_plasticity().with_static_edge();
  of_restitution("jkr+kuwabara_kono", slaved);
  of_restitution("jkr+greenwood+kuwabara_kono", with_edge.without_plasticity());
  of_restitution("jkr+greenwood+kuwabara_kono+thornton_ning", with_edge);
  for (const double T : {1e-12, 1e-13, 1e-14, 1e-15})
    of_restitution("jkr+greenwood+kuwabara_kono, T_vis = " + detail::exact(T) + " s",
                   family({truth[0], T, truth[2]}).without_plasticity());
  of_duration("jkr+kuwabara_kono", compose(slaved.pair, hertz{}, slaved.adhesion, slaved.damping, contact_duration{}));
  of_duration("jkr+greenwood+kuwabara_kono",
              compose(slaved.pair, hertz{}, slaved.adhesion, with_edge.crack, slaved.damping, contact_duration{}));
  of_all_pairs();

  benchmark::RegisterBenchmark("fit/50 speeds, 3 parameters",
                               [](benchmark::State& state) {
                                 const auto data = measured(50, 0.01);
                                 std::size_t collisions = 0;
                                 for (auto _ : state)
                                   collisions = fit(family, data,
                                                    std::array{free_parameter{"work_of_adhesion", 0.05, 5},
                                                               free_parameter{"relaxation_time", 1e-13, 1e-9},
                                                               free_parameter{"yield_strength", 3e7, 3e9}},
                                                    {.tolerance = 1e-6, .confidence = double(state.range(0)) / 100})
                                                    .collisions;
                                 state.counters["collisions"] = double(collisions);
                               })
      ->ArgName("confidence")
      ->Arg(0)
      ->Arg(95)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();

  benchmark::RegisterBenchmark("grid/50 speeds",
                               [](benchmark::State& state) {
                                 const auto data = measured(50, 0.01);
                                 const auto n = std::size_t(state.range(0));
                                 const std::array axes{logarithmic_axis("work_of_adhesion", 0.2, 2, n),
                                                       logarithmic_axis("relaxation_time", 1e-12, 1e-10, n),
                                                       logarithmic_axis("yield_strength", 1e8, 1e9, n)};
                                 std::size_t collisions = 0;
                                 for (auto _ : state)
                                   collisions = scan_chi_square(family, data, axes, {.tolerance = 1e-6}).collisions;
                                 state.counters["collisions"] = double(collisions);
                               })
      ->ArgName("values each")
      ->Arg(20)
      ->Arg(100)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
