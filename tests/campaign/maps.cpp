// maps: error and cost of viscoelastic JKR, two spheres of ice, over impact speed and relaxation time. See --help.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/version.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace {
using namespace ricochet;
using namespace ricochet::units;

struct arguments {
  std::size_t points = 120;
  double tolerance = 1e-8;
  bool undamped = false;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string file = "out/maps/viscoelastic_jkr.csv", command = "tests/campaign/maps";
};

struct cell {
  double speed, relaxation_time;
  ending how;
  bool certain;
  double restitution, estimate, error, finer_estimate; ///< the latter NaN where the finer solution does not tell
  long evaluations;
  std::string reason;
};

double at(double low, double high, std::size_t place, std::size_t points) {
  return low * std::pow(high / low, double(place) / double(points - 1));
}

/// The ice case of Krijt 2013, section 3, with this relaxation time, and with bulk damping or without.
auto model_of(double relaxation_time, auto... damping) {
  static const std::shared_ptr<const greenwood_table> edge = std::make_shared<const greenwood_table>(0.02);
  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  return compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)},
                 greenwood{.relaxation_time = relaxation_time * seconds,
                           .modulus_ratio = 0.02,
                           .interaction_range = 0.3 * nanometres,
                           .table = edge},
                 damping...);
}
kuwabara_kono damping_at(double relaxation_time) {
  return {.bulk_time = bulk_time_of_krijt(relaxation_time * seconds, materials::water_ice.poissons_ratio)};
}

bool ended(ending e) { return e == ending::separated || e == ending::captured; }

cell look(const auto& model, double v, double relaxation_time, double tolerance) {
  const impact motion{.speed = v * metres_per_second};
  const auto out = collide(model, motion, {.tolerance = tolerance});
  cell here{v,
            relaxation_time,
            out.ending,
            out.ending_is_certain,
            out.restitution.value_or(0),
            out.error_estimate,
            std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::quiet_NaN(),
            out.evaluations,
            out.reason};
  if (ended(out.ending)) {
    const auto finer = collide(model, motion, {.tolerance = tolerance / 100});
    if (ended(finer.ending) && finer.ending_is_certain) {
      here.error = std::abs(here.restitution - finer.restitution.value_or(0));
      here.finer_estimate = finer.error_estimate;
    }
  }
  return here;
}

/// All cells, relaxation times one after the other; progress on standard error.
std::vector<cell> scan(const arguments& given) {
  const std::size_t n = given.points, all = n * n;
  std::vector<cell> cells(all);
  std::atomic<std::size_t> next = 0, done = 0;
  const auto begun = std::chrono::steady_clock::now();
  const auto work = [&] {
    // Cells that cost much lie together: a stride that shares no factor with n^2 spreads them over the run.
    std::size_t stride = n * n / 3 | 1;
    while (std::gcd(stride, all) != 1)
      stride += 2;
    for (std::size_t i = next++; i < all; i = next++) {
      const std::size_t here = i * stride % all;
      const double v = at(1e-1, 1e3, here % n, n), T = at(1e-18, 1, here / n, n);
      cells[here] = given.undamped ? look(model_of(T), v, T, given.tolerance)
                                   : look(model_of(T, damping_at(T)), v, T, given.tolerance);
      if (const std::size_t count = ++done; count % 1000 == 0 || count == all) {
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        fmt::print(stderr, "\r{} of {} collisions, {:.0f} s, {:.0f} s to go ", count, all, elapsed,
                   elapsed * double(all - count) / double(count));
      }
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < given.threads; ++i)
    workers.emplace_back(work);
  for (std::thread& worker : workers)
    worker.join();
  std::fputc('\n', stderr);
  return cells;
}

void write(const arguments& given, const std::vector<cell>& cells) {
  const std::filesystem::path file = given.file, part = file.string() + ".part";
  if (file.has_parent_path())
    std::filesystem::create_directories(file.parent_path());
  std::ofstream out(part);
  out << fmt::format(
      "# ricochet {}\n# command: {}\n"
      "# water-ice spheres, radius 2 um, k = 0.02, {}; tolerance {:g}\n"
      "# units: speed [m/s] relaxation_time [s] all others [1]; error: difference from e at a hundredth of the "
      "tolerance, finer_estimate: estimate of that one; both blank if not known\n"
      "speed,relaxation_time,ending,certain,restitution,error_estimate,error,finer_estimate,evaluations,reason\n",
      version, given.command,
      given.undamped ? "hertz+jkr+greenwood" : "hertz+jkr+greenwood+kuwabara_kono, A = T_vis/nu^2", given.tolerance);
  for (const cell& c : cells)
    out << fmt::format("{:.17g},{:.17g},{},{:d},{:.17g},{:.3g},{},{},{}\n", c.speed, c.relaxation_time, name_of(c.how),
                       c.certain, c.restitution, c.estimate,
                       std::isnan(c.error) ? "," : fmt::format("{:.3g},{:.3g}", c.error, c.finer_estimate),
                       c.evaluations, c.reason);
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + part.string());
  std::filesystem::rename(part, file);
}

void summarise(const std::vector<cell>& cells, double tolerance) {
  const auto count = [&](const auto& holds) { return std::count_if(cells.begin(), cells.end(), holds); };
  for (const ending how : {ending::separated, ending::captured, ending::unresolved, ending::failed})
    fmt::print("{:24} {}\n", name_of(how), count([&](const cell& c) { return c.how == how; }));
  fmt::print("{:24} {}\n", "ending not certain", count([](const cell& c) { return ended(c.how) && !c.certain; }));
  fmt::print("{:24} {}\n", "estimate > tolerance",
             count([&](const cell& c) { return ended(c.how) && !(c.estimate <= tolerance); }));
  double over_tolerance = 0, over_estimate = 0;
  std::vector<long> evaluations;
  for (const cell& c : cells) {
    evaluations.push_back(c.evaluations);
    if (!std::isnan(c.error) && c.certain) {
      over_tolerance = std::max(over_tolerance, c.error / tolerance);
      if (const double excess = c.error - c.finer_estimate - 1e-12; excess > 0) // as in the campaign
        over_estimate = std::max(over_estimate, excess / c.estimate);
    }
  }
  std::sort(evaluations.begin(), evaluations.end());
  fmt::print("largest error over tolerance {:.3g}, over estimate {:.3g}\n", over_tolerance, over_estimate);
  fmt::print("evaluations: median {}, 99 % below {}, most {}\n", evaluations[evaluations.size() / 2],
             evaluations[evaluations.size() * 99 / 100], evaluations.back());
}

} // namespace

int main(int argc, char** argv) {
  arguments given;
  CLI::App app("Error and cost of viscoelastic JKR, two spheres of ice, over speed and relaxation time, as CSV.");
  app.add_option("--points", given.points, "along each axis")->check(CLI::Range(2, 2000))->capture_default_str();
  app.add_option("--tolerance", given.tolerance, "of the restitution")
      ->check(CLI::Range(1e-10, 1e-1))
      ->capture_default_str();
  app.add_flag("--undamped", given.undamped, "without bulk damping");
  app.add_option("--threads", given.threads, "at once")->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--output", given.file, "CSV file")->capture_default_str();
  app.add_option("--command", given.command, "to name in the file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const std::vector<cell> cells = scan(given);
  write(given, cells);
  summarise(cells, given.tolerance);
}
