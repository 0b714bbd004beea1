// The main job of examples/run: e(v) of two water-ice spheres from 0.1 to 100 m/s under every instance, the sticking
// speeds, and the CSV files behind the figure (restitution_curves.gp draws it, after Krijt 2013, figure 4).
//
// usage: restitution_curves [output directory]
#include <ricochet/closed_form/independent_losses.hpp>
#include <ricochet/ricochet.hpp>
#include <ricochet/study/sweep.hpp>
#include <ricochet/study/table.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

using namespace ricochet;
using namespace ricochet::units;

// Krijt 2013, section 3 and table 2; radius and z0 are not printed there, these reproduce its numbers.
const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
const contact_pair pair = between(grain, grain);
const jkr adhesive{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)};
const duration relaxation_time = 1e-11 * seconds;
const kuwabara_kono viscous{.bulk_time = bulk_time_of_krijt(relaxation_time, grain.solid.poissons_ratio)};
const length interaction_range = 0.3 * nanometres;

const speed slowest = 0.1 * metres_per_second, fastest = 100.0 * metres_per_second;
constexpr std::size_t speeds_per_instance = 401;
const std::string about =
    "two water-ice spheres: radius 2e-6 m, E 7e9 Pa, nu 0.25, density 1000 kg/m^3, work of adhesion "
    "0.74 J/m^2, T_vis 1e-11 s, k 0.02, z0 3e-10 m, A = T_vis/nu^2; tolerance 1e-8; 0 = captured";

struct curve {
  std::string name;
  std::vector<double> restitution; // 0 where captured
  double sticking_speed;           // 0 where nothing sticks
};

template <class Model>
curve draw(const char* name, const Model& model, const std::vector<speed>& speeds) {
  const auto begin = std::chrono::steady_clock::now();
  curve result{name, {}, 0};
  for (const auto& out : sweep(model, speeds, {.tolerance = 1e-8})) {
    const bool ended = out.ending == ending::separated || out.ending == ending::captured;
    result.restitution.push_back(ended ? out.restitution.value_or(0) : std::numeric_limits<double>::quiet_NaN());
  }
  if (result.restitution.front() == 0)
    result.sticking_speed = in_si(sticking_speed(model, slowest, fastest).value());
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  std::printf("  %-38s %4zu speeds, %6.1f ms", name, speeds.size(), taken.count());
  std::printf(result.sticking_speed > 0 ? ", sticks up to %.9f m/s\n" : ", never sticks\n", result.sticking_speed);
  std::fflush(stdout);
  return result;
}

std::vector<curve> draw_all(const std::vector<speed>& speeds) {
  const greenwood exact{
      .relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = interaction_range};
  const greenwood_fit fitted{.relaxation_time = relaxation_time, .interaction_range = interaction_range};
  std::vector<curve> curves;
  curves.push_back(draw("hertz", compose(pair, hertz{}), speeds));
  curves.push_back(draw("hertz+kuwabara_kono", compose(pair, hertz{}, viscous), speeds));
  curves.push_back(draw("hertz+jkr", compose(pair, hertz{}, adhesive), speeds));
  curves.push_back(draw("hertz+jkr+kuwabara_kono", compose(pair, hertz{}, adhesive, viscous), speeds));
  curves.push_back(draw("hertz+jkr+greenwood+kuwabara_kono", compose(pair, hertz{}, adhesive, exact, viscous), speeds));
  curves.push_back(
      draw("hertz+jkr+greenwood_fit+kuwabara_kono", compose(pair, hertz{}, adhesive, fitted, viscous), speeds));
  curve independent{"independent_losses", {}, 0}; // [K (27)]: adhesion and viscosity each for itself
  for (const speed& v : speeds)
    independent.restitution.push_back(
        closed_form::independent_losses(pair, adhesive.work_of_adhesion, viscous.bulk_time, v).value_or(0));
  curves.push_back(independent);
  return curves;
}

void print(const std::vector<speed>& speeds, const std::vector<curve>& curves) {
  std::printf("\nrestitution e(v); 0 = captured\n%9s", "v (m/s)");
  for (const char* short_name : {"Hertz", "viscous", "JKR", "JKR+visc.", "exact edge", "fitted edge", "losses added"})
    std::printf(" %12s", short_name);
  for (std::size_t i = 0; i < speeds.size(); i += 25) {
    std::printf("\n%9.3f", in_si(speeds[i]));
    for (const curve& each : curves)
      std::printf(" %12.8f", each.restitution[i]);
  }
  std::printf("\n");
}

void write(const std::string& directory, const std::vector<speed>& speeds, const std::vector<curve>& curves) {
  std::vector<column> columns{{"speed", "m/s"}};
  for (const curve& each : curves)
    columns.push_back({each.name, "1"});
  table restitution(directory + "/restitution_curves.csv", "restitution_curves " + directory, about, columns);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    std::vector<double> row{in_si(speeds[i])};
    for (const curve& each : curves)
      row.push_back(each.restitution[i]);
    restitution.row(row);
  }
  restitution.finish();

  columns.clear();
  std::vector<double> row;
  for (const curve& each : curves)
    if (each.sticking_speed > 0) {
      columns.push_back({each.name, "m/s"});
      row.push_back(each.sticking_speed);
    }
  table sticking(directory + "/sticking_speeds.csv", "restitution_curves " + directory, about, columns);
  sticking.row(row);
  sticking.finish();
}

} // namespace

int main(int count, char** arguments) {
  const std::string directory = count > 1 ? arguments[1] : "out";
  if (count > 2 || directory.starts_with("-")) {
    std::fprintf(stderr, "usage: restitution_curves [output directory]\n");
    return 2;
  }
  try {
    const auto begin = std::chrono::steady_clock::now();
    std::printf("%s\n", about.c_str());
    const std::vector<speed> speeds = logarithmic_speeds(slowest, fastest, speeds_per_instance);
    const std::vector<curve> curves = draw_all(speeds);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    print(speeds, curves);
    write(directory, speeds, curves);
    std::printf("\ncomputed in %.2f s; written to %s/restitution_curves.csv and sticking_speeds.csv\n", taken.count(),
                directory.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "restitution_curves: %s\n", error.what());
    return 1;
  }
}
