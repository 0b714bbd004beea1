#include "adversaries.hpp"

#include <ricochet/body/validate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <random>
#include <thread>

namespace campaign {

namespace {

constexpr long most_kept = 1'000'000; ///< evaluations: what is kept can be solved again in a fraction of a second

struct candidate {
  std::vector<double> choices;
  finding found, finer;
  std::array<double, 3> values{}; ///< by aim; 0 where the library says by itself that it does not know
};

candidate tried(const instance& of, std::vector<double> choices) {
  candidate c{std::move(choices), {}, {}, {}};
  const scene s = drawn_by(c.choices, extent::documented);
  try {
    c.found = of.solve(s, {.tolerance = s.tolerance});
    if (!c.found.ended() || !c.found.certain)
      return c;
    c.values[std::size_t(aim::evaluations)] = c.found.evaluations < most_kept ? double(c.found.evaluations) : 0;
    if (c.found.error_estimate <= s.tolerance)
      c.values[std::size_t(aim::residual)] = std::abs(c.found.ledger_residual) / s.tolerance;
    if (c.found.evaluations > most_kept / 3) // lest the search take hours
      return c;
    c.finer = of.solve(s, {.tolerance = std::max(s.tolerance / 100, 1e-12)});
    if (c.finer.ended() && c.finer.certain)
      c.values[std::size_t(aim::error)] = over_estimate(c.found, difference(c.found, c.finer) - c.finer.error_estimate);
  } catch (const ricochet::bad_input&) { // a law refuses some scenes, such as a strength below what adhesion bears
  }
  return c;
}

/// Some of the choices moved, by far or by little.
std::vector<double> moved(std::vector<double> choices, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double step = 0.3 * std::pow(10, -6 * std::generate_canonical<double, 53>(random));
  for (auto count = 1 + random() % 4; count > 0; --count) {
    double& one = choices[random() % choices.size()];
    one = std::clamp(one + step * normal(random), 0., 1 - 1e-9);
  }
  return choices;
}

/// The worst found for each aim.
std::array<candidate, 3> worst_of(const instance& of, std::size_t place, std::uint64_t seed, long trials) {
  std::array<candidate, 3> worst;
  const auto keep = [&](const candidate& c) {
    for (std::size_t a = 0; a < worst.size(); ++a)
      if (c.values[a] > worst[a].values[a])
        worst[a] = c;
  };
  for (long i = 0; i < trials / 2; ++i)
    keep(tried(of, choices_of(seed, place * 1'000'000 + std::uint64_t(i), extent::documented)));
  std::seed_seq all{seed, seed >> 32, std::uint64_t(place)};
  std::mt19937_64 random(all);
  for (long i = 0; i < trials - trials / 2; ++i)
    if (const candidate& near = worst[std::size_t(i) % 3]; !near.choices.empty())
      keep(tried(of, moved(near.choices, random)));
  return worst;
}

} // namespace

std::vector<adversary> search_adversaries(const std::vector<instance>& instances, std::uint64_t seed, long trials,
                                          unsigned threads) {
  std::vector<adversary> all;
  std::mutex guard;
  std::atomic<std::size_t> next = 0, done = 0;
  const auto begun = std::chrono::steady_clock::now();
  const auto work = [&] {
    for (std::size_t i = next++; i < instances.size(); i = next++) {
      const instance& of = instances[i];
      const auto worst = worst_of(of, i, seed, trials);
      const std::lock_guard lock(guard);
      for (std::size_t a = 0; a < worst.size(); ++a)
        if (worst[a].values[a] > 0)
          all.push_back({of.name, aim(a), drawn_by(worst[a].choices, extent::documented), worst[a].found,
                         worst[a].finer, worst[a].values[a], std::nullopt});
      const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      fmt::print(stderr, "{} of {} instances, {:.0f} s: {}\n", ++done, instances.size(), elapsed, of.name);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < threads; ++i)
    workers.emplace_back(work);
  for (std::thread& worker : workers)
    worker.join();
  // A third of the hundred for each aim, the worst of it first.
  std::sort(all.begin(), all.end(), [](const adversary& one, const adversary& other) {
    return one.of != other.of         ? one.of < other.of
           : one.value != other.value ? one.value > other.value
                                      : one.instance < other.instance;
  });
  std::array<int, 3> count{};
  std::erase_if(
      all, [&](const adversary& each) { return ++count[std::size_t(each.of)] > (each.of == aim::error ? 34 : 33); });
  for (adversary& each : all)
    for (const instance& of : instances)
      if (of.name == each.instance && of.reference)
        each.reference = of.reference(each.numbers);
  return all;
}

} // namespace campaign
