// How much faster than its peers: time for one collision at the same largest error over the same random collisions,
// all measured in turn in one run, on one thread.
#include "peer_odeint.hpp"

#include <ricochet/batch/batch.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <string>

namespace {
using namespace ricochet;
using namespace ricochet::units;

constexpr std::size_t count = 1000;

/// Somebody who computes all collisions at a tolerance of theirs.
struct contender {
  std::string name;
  std::function<void(double tolerance, std::vector<double>& e)> solve;
  double tolerance = 0, error = 0, seconds = 1e300; ///< found
};

double largest_error(const std::vector<double>& e, const std::vector<double>& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < e.size(); ++i)
    worst = std::max(worst, std::abs(e[i] - expected[i]));
  return worst;
}

/// Loosest tolerance, in quarters of a decade, whose largest error is as wanted; none is 0.
void tune(contender& who, double wanted, const std::vector<double>& expected) {
  std::vector<double> e(expected.size());
  for (double tolerance = 1e-2; tolerance > 1e-14; tolerance *= std::pow(10., -0.25)) {
    who.solve(tolerance, e);
    who.error = largest_error(e, expected);
    if (who.error <= wanted) {
      who.tolerance = tolerance;
      return;
    }
  }
}

double seconds_of(const contender& who) {
  std::vector<double> e(count);
  const auto start = std::chrono::steady_clock::now();
  who.solve(who.tolerance, e);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct goal {
  std::size_t ours, theirs;
  double ratio;
};

void compare(const char* scene, double wanted, std::vector<contender> all, const std::vector<double>& expected,
             const std::vector<goal>& goals) {
  for (auto& who : all)
    tune(who, wanted, expected);
  for (int round = 0; round < 5; ++round)
    for (auto& who : all)
      if (who.tolerance > 0)
        who.seconds = std::min(who.seconds, seconds_of(who));
  std::printf("%s, error <= %.0e\n", scene, wanted);
  for (const auto& who : all)
    if (who.tolerance > 0)
      std::printf("  %-44s %9.3f us  (tolerance %.1e, largest error %.1e)\n", who.name.c_str(),
                  1e6 * who.seconds / double(count), who.tolerance, who.error);
    else
      std::printf("  %-44s never gets there (%.1e)\n", who.name.c_str(), who.error);
  for (const auto& g : goals) {
    const auto &ours = all[g.ours], &theirs = all[g.theirs];
    if (ours.tolerance > 0 && theirs.tolerance > 0) {
      const double ratio = theirs.seconds / ours.seconds;
      std::printf("  %s against %s: %.1fx, goal %.0fx: %s\n", ours.name.c_str(), theirs.name.c_str(), ratio, g.ratio,
                  ratio >= g.ratio ? "met" : "not met");
    }
  }
}

template <class Model>
contender ours_in_batch(const std::vector<scene<Model>>& scenes) {
  return {"ricochet, batch", [scenes](double tolerance, std::vector<double>& e) {
            const auto out = collide(scenes, {.tolerance = tolerance, .threads = 1});
            for (std::size_t i = 0; i < e.size(); ++i)
              e[i] = out[i].restitution.value_or(0);
          }};
}

template <class Model>
contender ours_alone(const std::vector<scene<Model>>& scenes) {
  return {"ricochet, one by one", [scenes](double tolerance, std::vector<double>& e) {
            for (std::size_t i = 0; i < e.size(); ++i)
              e[i] = collide(scenes[i].model, scenes[i].impact, {.tolerance = tolerance}).restitution.value_or(0);
          }};
}

/// A peer's systems, in units in which the impact's speed is one and so are mass and Hertzian approach, within factors.
template <class System>
contender with_bisection(const std::vector<System>& systems, double longest) {
  return {"odeint dopri5, dense output, bisection", [systems, longest](double tolerance, std::vector<double>& e) {
            for (std::size_t i = 0; i < e.size(); ++i)
              e[i] = peer::by_bisection(systems[i], 1, tolerance, longest);
          }};
}
template <class System>
contender with_newton(const std::vector<System>& systems, double longest) {
  return {"odeint dopri5, Newton", [systems, longest](double tolerance, std::vector<double>& e) {
            for (std::size_t i = 0; i < e.size(); ++i)
              e[i] = peer::by_newton(systems[i], 1, tolerance, longest);
          }};
}

class random_numbers {
public:
  double log_uniform(double low, double high) {
    return low * std::exp(std::uniform_real_distribution<>(0, std::log(high / low))(generator_));
  }

private:
  std::mt19937_64 generator_{1};
};

/// A pair and an impact at which mass, speed and force are of order one, as ricochet's own scales make them.
struct reduced_scene {
  contact_pair pair;
  peer::pair numbers;
};
reduced_scene next_pair(random_numbers& random) {
  const double E = random.log_uniform(0.5, 2), R = random.log_uniform(3, 300);
  const double modulus_in_scale = E / std::sqrt(R); // E sqrt(R) of order one
  return {{modulus_in_scale * pascals, R * metres, 1 * kilograms}, {modulus_in_scale, R, 1}};
}

template <class Model>
std::vector<double> references(const std::vector<scene<Model>>& scenes) {
  std::vector<double> e;
  for (const auto& s : scenes) {
    const scales unit = scales_at(s.model, s.impact.speed);
    const reduced_model<long double, Model> numbers(s.model, unit);
    collision<decltype(numbers), stepper::tsitouras_papakostas75> solver(numbers, 1e-15L, 40'000'000);
    e.push_back(double(solver.solve(reduce<long double>(s.impact.speed, unit)).restitution.value_or(0)));
  }
  return e;
}

template <class Model, class System>
void compare_all(const char* name, const std::vector<scene<Model>>& scenes, const std::vector<System>& systems,
                 double longest, const std::vector<std::pair<double, std::vector<goal>>>& goals) {
  const auto expected = references(scenes);
  for (const auto& [wanted, ratios] : goals)
    compare(
        name, wanted,
        {ours_in_batch(scenes), ours_alone(scenes), with_bisection(systems, longest), with_newton(systems, longest)},
        expected, ratios);
}

constexpr std::size_t batch = 0, alone = 1, bisection = 2, newton = 3;

} // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  random_numbers random;
  const impact at{1 * metres_per_second};
  {
    std::vector<scene<decltype(compose(contact_pair{}, hertz{}, kuwabara_kono{}))>> scenes;
    std::vector<peer::kuwabara_kono> systems;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [pair, numbers] = next_pair(random);
      const double A = random.log_uniform(1e-3, 0.5);
      scenes.push_back({compose(pair, hertz{}, kuwabara_kono{A * seconds}), at});
      systems.push_back({numbers, A});
    }
    compare_all("Hertz + Kuwabara-Kono", scenes, systems, 100,
                {{1e-6, {{batch, bisection, 100}, {batch, newton, 20}, {alone, newton, 6}}},
                 {1e-10, {{batch, bisection, 150}, {batch, newton, 50}, {alone, newton, 10}}}});
  }
  {
    std::vector<scene<decltype(compose(contact_pair{}, hertz{}, hunt_crossley{}))>> scenes;
    std::vector<peer::hunt_crossley> systems;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [pair, numbers] = next_pair(random);
      const double c = random.log_uniform(1e-2, 3);
      scenes.push_back({compose(pair, hertz{}, hunt_crossley{c * seconds_per_metre}), at});
      systems.push_back({numbers, c});
    }
    compare_all("Hertz + Hunt-Crossley", scenes, systems, 100,
                {{1e-6, {{batch, bisection, 100}, {batch, newton, 20}, {alone, newton, 6}}},
                 {1e-10, {{batch, bisection, 150}, {batch, newton, 50}, {alone, newton, 10}}}});
  }
  {
    std::vector<scene<decltype(compose(contact_pair{}, hertz{}, jkr{}, kuwabara_kono{}))>> scenes;
    std::vector<peer::jkr_kuwabara_kono> systems;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [pair, numbers] = next_pair(random);
      // Capture speeds from a tenth to nine tenths of the impact's, without the damping.
      const double part = random.log_uniform(0.1, 0.8), A = random.log_uniform(1e-3, 0.1);
      const double w = std::pow(
          part * part / 14.18 * std::cbrt(numbers.modulus * numbers.modulus) / std::pow(numbers.radius, 4. / 3), 0.6);
      scenes.push_back({compose(pair, hertz{}, jkr{w * joules_per_square_metre}, kuwabara_kono{A * seconds}), at});
      systems.push_back({numbers, w, A});
    }
    compare_all("Hertz + JKR + Kuwabara-Kono", scenes, systems, 100,
                {{1e-6, {{batch, bisection, 150}, {alone, bisection, 6}, {alone, newton, 6}}},
                 {1e-10, {{batch, bisection, 150}, {alone, bisection, 10}, {alone, newton, 10}}}});
  }
}
