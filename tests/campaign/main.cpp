// campaign: random collisions of every composition, over all that physics and carelessness can produce; each is to be
// certified, or to say by itself why it is not. See --help.
#include "adversaries.hpp"
#include "tally.hpp"

#include <ricochet/body/validate.hpp>
#include <ricochet/version.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

namespace {
using namespace campaign;

struct arguments {
  std::uint64_t seed = 1, count = 100'000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  long compare_every = 20, reference_every = 2000;
  std::string only;
  std::optional<std::uint64_t> scene;
  std::optional<extent> from; ///< else of all, see extent_of()
  long search = 0, max_evaluations = ricochet::collide_options{}.max_evaluations;
  std::string adversaries;
};

constexpr std::array extents{extent::documented, extent::wide, extent::bad};

/// Unless one is given: of twenty scenes nine are in the documented range, ten in the wide one, and one is bad.
extent extent_of(std::uint64_t index, const std::optional<extent>& given) {
  if (given)
    return *given;
  const std::uint64_t place = index % 20;
  return place < 9 ? extent::documented : place < 19 ? extent::wide : extent::bad;
}

struct examination {
  finding found;
  verdict is;
  std::optional<double> error_over_estimate; ///< where there is a better solution to compare with
};

examination examine(const instance& of, const scene& s, extent from, long max_evaluations, bool compare, bool refer) {
  examination result{};
  finding& f = result.found;
  try {
    f = of.solve(s, {.tolerance = s.tolerance, .max_evaluations = max_evaluations});
  } catch (const ricochet::bad_input& refused) {
    f.reason = refused.what();
    result.is = verdict::refused;
    return result;
  }
  f.expect(from != extent::bad, "bad input went through");
  const bool told = f.ended() && f.certain;
  if (compare && told && s.tolerance >= 1e-10) {
    const finding finer = of.solve(s, {.tolerance = s.tolerance / 100, .max_evaluations = max_evaluations});
    if (finer.ended() && finer.certain) {
      result.error_over_estimate = over_estimate(f, difference(f, finer) - finer.error_estimate);
      f.expect(*result.error_over_estimate <= 1,
               fmt::format("differs from a finer solution by {:.3g} where the estimate is {:.3g}", difference(f, finer),
                           f.error_estimate));
    }
  }
  if (refer && of.reference && told)
    if (const std::optional<double> reference = of.reference(s)) {
      const double error = std::abs(e_of(f) - *reference);
      result.error_over_estimate = over_estimate(f, error);
      f.expect(*result.error_over_estimate <= 1,
               fmt::format("errs by {:.3g} where the estimate is {:.3g}: {:.17g} is right", error, f.error_estimate,
                           *reference));
    }
  result.is = !f.wrong.empty()                           ? verdict::wrong
              : f.ending == ricochet::ending::unresolved ? verdict::unresolved
              : f.ending == ricochet::ending::failed     ? verdict::failed
              : !f.certain                               ? verdict::near
              : !(f.error_estimate <= s.tolerance)       ? verdict::unmet
                                                         : verdict::certified;
  return result;
}

class run {
public:
  run(const arguments& given, const std::vector<instance>& instances)
      : given_(given), instances_(instances), tallies_(instances.size() * extents.size()) {}

  /// All scenes, on all threads.
  void all() {
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < given_.threads; ++i)
      workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers)
      worker.join();
    std::fputc('\n', stderr);
  }

  /// One scene, with all that is known of it.
  void one(std::uint64_t index) const {
    const extent from = extent_of(index, given_.from);
    const scene s = draw(given_.seed, index, from);
    const instance& of = instance_of(index);
    fmt::print("scene {} of seed {}: {}, range {}\n{}", index, given_.seed, of.name, name_of(from), s.text());
    std::fflush(stdout);
    const examination result = examine(of, s, from, given_.max_evaluations, true, true);
    const finding& f = result.found;
    fmt::print("{}: {}{}\n", verdict_names[std::size_t(result.is)],
               result.is == verdict::refused ? f.reason : ricochet::name_of(f.ending),
               f.wrong.empty() ? "" : ": " + f.wrong);
    if (result.is != verdict::refused)
      fmt::print("  restitution {:.17g} +- {:.3g}, ledger residual {:.3g}, {} evaluations{}\n", e_of(f),
                 f.error_estimate, f.ledger_residual, f.evaluations, f.reason.empty() ? "" : "; " + f.reason);
  }

  /// Prints what was found; true if nothing is wrong.
  bool report() const {
    bool right = true;
    for (const extent from : extents) {
      tally sum, by_default;
      for (std::size_t i = 0; i < instances_.size(); ++i) {
        sum.merge(of(i, from));
        if (instances_[i].by_default_stepper())
          by_default.merge(of(i, from));
      }
      if (sum.total() == 0)
        continue;
      fmt::print("\nrange {}: {} scenes, {:.3g} evaluations each; by the default stepper {} scenes\n", name_of(from),
                 sum.total(), double(sum.evaluations) / double(sum.total()), by_default.total());
      for (std::size_t v = 0; v < sum.count.size(); ++v)
        if (sum.count[v] > 0)
          fmt::print("  {:20} {:10} {:8.3f} %   by the default {:10} {:8.3f} %\n", verdict_names[v], sum.count[v],
                     percent(sum.count[v], sum.total()), by_default.count[v],
                     percent(by_default.count[v], by_default.total()));
      print_largest("evaluations", sum.most_evaluations);
      print_largest("ledger residual", sum.largest_residual);
      print_largest(fmt::format("error over estimate, {} comparisons", sum.compared), sum.largest_error);
      for (std::size_t i = 0; i < instances_.size(); ++i)
        print_trouble(instances_[i], of(i, from));
      right = right && sum.count[std::size_t(verdict::wrong)] == 0;
    }
    return right;
  }

private:
  static double percent(long part, long whole) { return whole > 0 ? 100 * double(part) / double(whole) : 0; }

  const instance& instance_of(std::uint64_t index) const {
    return instances_[index / 20 % instances_.size()]; // so that each has all extents
  }
  const tally& of(std::size_t instance, extent from) const {
    return tallies_[instance * extents.size() + std::size_t(from)];
  }

  static void print_largest(const std::string& what, const record& largest) {
    if (largest.value > 0)
      fmt::print("  largest {}: {:.3g} (scene {})\n", what, largest.value, largest.index);
  }

  void print_trouble(const instance& of, const tally& here) const {
    if (!here.reasons.empty())
      fmt::print("  {}, of {}:\n", of.name, here.total());
    for (const auto& [kind, seen] : here.reasons)
      fmt::print("    {:6} {}: campaign --seed {}{}{}{} --scene {}\n", seen.first, kind, given_.seed,
                 given_.max_evaluations == ricochet::collide_options{}.max_evaluations
                     ? ""
                     : fmt::format(" --max-evaluations {}", given_.max_evaluations),
                 given_.only.empty() ? "" : fmt::format(" --only '{}'", given_.only),
                 given_.from ? fmt::format(" --range {}", name_of(*given_.from)) : "", seen.second);
  }

  void work() {
    constexpr std::uint64_t chunk = 500;
    std::vector<tally> mine(tallies_.size());
    for (std::uint64_t first = next_.fetch_add(chunk); first < given_.count; first = next_.fetch_add(chunk)) {
      const std::uint64_t last = std::min(first + chunk, given_.count);
      for (std::uint64_t i = first; i < last; ++i) {
        const extent from = extent_of(i, given_.from);
        const auto often = [&](long n) { // of every instance and range alike
          return n > 0 && (i * 0x9e3779b97f4a7c15u >> 32) % std::uint64_t(n) == 0;
        };
        const examination result = examine(instance_of(i), draw(given_.seed, i, from), from, given_.max_evaluations,
                                           often(given_.compare_every), often(given_.reference_every));
        tally& to = mine[i / 20 % instances_.size() * extents.size() + std::size_t(from)];
        to.add(i, result.is, result.found);
        if (result.error_over_estimate) {
          ++to.compared;
          keep_larger(to.largest_error, {i, *result.error_over_estimate});
        }
      }
      progress(last - first);
    }
    const std::lock_guard lock(guard_);
    for (std::size_t i = 0; i < mine.size(); ++i)
      tallies_[i].merge(mine[i]);
  }

  void progress(std::uint64_t scenes) {
    const std::lock_guard lock(guard_);
    done_ += scenes;
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < std::chrono::seconds(2) && done_ < given_.count)
      return;
    told_ = now;
    const double elapsed = std::chrono::duration<double>(now - begun_).count();
    fmt::print(stderr, "\r{} of {} scenes, {:.0f} s, {:.0f} s to go ", done_, given_.count, elapsed,
               elapsed * double(given_.count - done_) / double(done_));
  }

  const arguments& given_;
  const std::vector<instance>& instances_;
  std::vector<tally> tallies_; ///< by instance and extent
  std::atomic<std::uint64_t> next_ = 0;
  std::uint64_t done_ = 0;
  std::mutex guard_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now(), told_ = begun_;
};

} // namespace

int main(int argc, char** argv) {
  arguments given;
  CLI::App app(
      "Random collisions of every composition: each is to be certified, or to say why it is not. Exit status 1 "
      "if any is wrong.");
  app.add_option("--scenes", given.count, "how many")->capture_default_str();
  app.add_option("--seed", given.seed, "of the random numbers")->capture_default_str();
  app.add_option("--threads", given.threads, "at once")->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--only", given.only, "the instance of this name, or all whose names begin so");
  app.add_option("--range", given.from, "draw from this range alone: documented, wide or bad")
      ->transform(CLI::CheckedTransformer(std::map<std::string, extent>{
          {"documented", extent::documented}, {"wide", extent::wide}, {"bad", extent::bad}}));
  app.add_option("--compare-every", given.compare_every,
                 "solve one scene in so many again at a hundredth of the tolerance; 0: none")
      ->capture_default_str();
  app.add_option("--reference-every", given.reference_every, "solve one in so many in long double; 0: none")
      ->capture_default_str();
  app.add_option("--max-evaluations", given.max_evaluations, "of the equations of motion, for each of two solutions")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--scene", given.scene, "show this scene alone");
  app.add_option("--search", given.search,
                 "so many trials of each instance for scenes with the largest errors, residuals and efforts, which are "
                 "written to the file of --adversaries");
  app.add_option("--adversaries", given.adversaries, "solve the scenes of this file again, and compare");
  CLI11_PARSE(app, argc, argv);

  std::vector<instance> instances = all_instances();
  const bool exists =
      std::any_of(instances.begin(), instances.end(), [&](const instance& i) { return i.name == given.only; });
  std::erase_if(instances,
                [&](const instance& i) { return exists ? i.name != given.only : !i.name.starts_with(given.only); });
  if (instances.empty()) {
    fmt::print(stderr, "campaign: no instance is named {}; there are:\n", given.only);
    for (const instance& i : all_instances())
      fmt::print(stderr, "  {}\n", i.name);
    return 2;
  }
  if (given.search > 0) {
    write_adversaries(search_adversaries(instances, given.seed, given.search, given.threads), given.adversaries,
                      fmt::format("campaign --search {} --seed {}{}", given.search, given.seed,
                                  given.only.empty() ? "" : fmt::format(" --only '{}'", given.only)));
    return 0;
  }
  if (!given.adversaries.empty())
    return check_adversaries(given.adversaries, instances) ? 0 : 1;
  run campaign(given, instances);
  if (given.scene) {
    campaign.one(*given.scene);
    return 0;
  }
  campaign.all();
  fmt::print("ricochet {} campaign: {} scenes of seed {} over {} instances\n", ricochet::version, given.count,
             given.seed, instances.size());
  const bool right = campaign.report();
  fmt::print("\n{}\n", right ? "Nothing is wrong." : "Something is wrong.");
  return right ? 0 : 1;
}
