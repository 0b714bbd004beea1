// Sets of random collisions, each as ricochet's scenes and as the equations that peers solve, with references.
#pragma once
#include "peer_equations.hpp"

#include <ricochet/batch/batch.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace instances {
using namespace ricochet;
using namespace ricochet::units;

/// Collisions under the same laws whose bodies and parameters differ. They all separate after one contact: peers
/// neither tell when a contact is captured nor follow a second one.
template <class Model, class System>
struct instance {
  std::string name;
  std::vector<scene<Model>> scenes;
  std::vector<System> systems;
  std::vector<double> expected; ///< restitution, from a solution in long double
};

/// Longest that a peer goes on, in units in which the contact time is near three.
inline constexpr double longest = 100;

class random_numbers {
public:
  double log_uniform(double low, double high) {
    return low * std::exp(std::uniform_real_distribution<>(0, std::log(high / low))(generator_));
  }
  std::size_t below(std::size_t count) { return std::size_t(generator_() % count); }

private:
  std::mt19937_64 generator_{1};
};

/// A pair at which mass and, at an impact of speed one, force and approach are of order one, as ricochet's own scales
/// make them.
struct reduced_pair {
  contact_pair pair;
  peer::pair<double> numbers;
};
inline reduced_pair next_pair(random_numbers& random) {
  const double E = random.log_uniform(0.5, 2), R = random.log_uniform(3, 300);
  const double modulus = E / std::sqrt(R); // E sqrt(R) of order one
  return {{modulus * pascals, R * metres, 1 * kilograms}, {modulus, R, 1}};
}

/// Work of adhesion at which contacts without other losses stick below `part` of the impact's speed.
inline double work_of_adhesion_at(double part, const peer::pair<double>& p) {
  return std::pow(part * part / 14.18 * std::cbrt(p.modulus * p.modulus) / std::pow(p.radius, 4. / 3), 0.6);
}

template <class Model>
std::optional<double> reference(const Model& model, const impact& at) {
  const scales unit = scales_at(model, at.speed);
  const reduced_model<long double, Model> numbers(model, unit);
  collision<decltype(numbers), stepper::tsitouras_papakostas75> solver(numbers, 1e-15L, 40'000'000);
  const auto out = solver.solve(reduce<long double>(at.speed, unit));
  return out.restitution && out.contacts == 1 ? std::optional(double(*out.restitution)) : std::nullopt;
}

/// `next(random)` gives a model and its peer's equations.
template <class Next>
auto make(const std::string& name, std::size_t count, const Next& next) {
  random_numbers random;
  using drawn = decltype(next(random));
  instance<typename drawn::first_type, typename drawn::second_type> result{name, {}, {}, {}};
  const impact at{1 * metres_per_second};
  while (result.scenes.size() < count) {
    const auto [model, system] = next(random);
    if (const auto e = reference(model, at)) {
      result.scenes.push_back({model, at});
      result.systems.push_back(system);
      result.expected.push_back(*e);
    }
  }
  return result;
}

inline auto viscous_hertz(std::size_t count) {
  return make("Hertz + Kuwabara-Kono", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double A = random.log_uniform(1e-3, 0.5);
    return std::pair(compose(pair, hertz{}, kuwabara_kono{A * seconds}), peer::kuwabara_kono<double>(numbers, A));
  });
}

inline auto hunt_crossley_hertz(std::size_t count) {
  return make("Hertz + Hunt-Crossley", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double c = random.log_uniform(1e-2, 3);
    return std::pair(compose(pair, hertz{}, hunt_crossley{c * seconds_per_metre}),
                     peer::hunt_crossley<double>(numbers, c));
  });
}

inline auto tsuji_hertz(std::size_t count) {
  return make("Hertz + Tsuji", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double alpha = random.log_uniform(1e-2, 2);
    return std::pair(compose(pair, hertz{}, tsuji{alpha}), peer::tsuji<double>(numbers, alpha));
  });
}

inline auto static_jkr(std::size_t count) {
  return make("Hertz + JKR", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double w = work_of_adhesion_at(random.log_uniform(0.1, 0.8), numbers);
    return std::pair(compose(pair, hertz{}, jkr{w * joules_per_square_metre}),
                     peer::jkr_kuwabara_kono<double>(numbers, w, 0));
  });
}

inline auto viscous_jkr(std::size_t count) {
  return make("Hertz + JKR + Kuwabara-Kono", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double w = work_of_adhesion_at(random.log_uniform(0.1, 0.8), numbers), A = random.log_uniform(1e-3, 0.1);
    return std::pair(compose(pair, hertz{}, jkr{w * joules_per_square_metre}, kuwabara_kono{A * seconds}),
                     peer::jkr_kuwabara_kono<double>(numbers, w, A));
  });
}

inline auto brach_dunn(std::size_t count) {
  return make("Hertz + ring force + Hunt-Crossley", count, [](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const double f = random.log_uniform(1e-3, 0.05), c = random.log_uniform(1e-2, 1), c_A = random.log_uniform(1e-2, 1);
    return std::pair(compose(pair, hertz{},
                             line_force{f / std::sqrt(numbers.radius) * newtons_per_metre, c_A * seconds_per_metre},
                             hunt_crossley{c * seconds_per_metre}),
                     peer::line_force<double>(numbers, f / std::sqrt(numbers.radius), c_A, c));
  });
}

/// Relaxation times from 1e-4 to 1e-2 of the contact time and Tabor numbers from 5 to 50; `edge(T, z0)` gives the law
/// and the peer's edge.
template <class Edge>
auto viscoelastic_jkr(const std::string& name, std::size_t count, const Edge& edge) {
  return make(name, count, [edge](random_numbers& random) {
    const auto [pair, numbers] = next_pair(random);
    const auto& [E, R, m] = numbers;
    const double w = work_of_adhesion_at(random.log_uniform(0.03, 0.5), numbers), A = random.log_uniform(1e-3, 0.1);
    const double T = 2.87 * random.log_uniform(1e-4, 1e-2);
    const double z0 = std::cbrt(R * w * w / (E * E)) / random.log_uniform(5, 50);
    const auto [law, peers] = edge(T * seconds, z0 * metres, random);
    const double k = law.modulus_ratio;
    const double touch = std::cbrt(2 * std::numbers::pi * R * R * law.first_ratio() * w / E);
    using system = peer::viscoelastic_jkr<double, std::remove_const_t<decltype(peers)>>;
    return std::pair(compose(pair, hertz{}, jkr{w * joules_per_square_metre}, kuwabara_kono{A * seconds}, law),
                     system{numbers, w, A, E * z0 * z0 / (w * T), touch, k, peers});
  });
}

inline auto viscoelastic_jkr_fit(std::size_t count) {
  return viscoelastic_jkr(
      "Hertz + JKR + Greenwood fit + Kuwabara-Kono", count, [](duration T, length z0, random_numbers&) {
        return std::pair(greenwood_fit{.relaxation_time = T, .interaction_range = z0}, peer::published_fit{});
      });
}

/// The exact law's edge for peers: its formula has no inverse in closed form, and they are given ricochet's table.
struct tabulated_edge {
  greenwood_law<reduced<double>> law;
  auto rate(double ratio) const { return rate_anywhere<double>(law, std::sqrt(ratio)); }
};

inline auto viscoelastic_jkr_exact(std::size_t count) {
  const auto table = [](double k) { return std::make_shared<const greenwood_table>(k); };
  return viscoelastic_jkr(
      "Hertz + JKR + Greenwood + Kuwabara-Kono", count,
      [tables = std::array{table(0.005), table(0.02), table(0.1), table(0.5)}](duration T, length z0,
                                                                               random_numbers& random) {
        const auto& shared = tables[random.below(tables.size())];
        const double k = shared->modulus_ratio;
        return std::pair(greenwood{T, k, z0, 1.01, shared}, tabulated_edge{{1, k, 1, 1.01, shared}});
      });
}

} // namespace instances
