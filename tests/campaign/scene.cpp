#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace campaign {

namespace {

struct parameter {
  const char* name;
  double scene::*member;
  const char* unit;
};
constexpr std::array parameters{parameter{"radius_1", &scene::radius_1, "m"},
                                parameter{"radius_2", &scene::radius_2, "m"},
                                parameter{"youngs_modulus_1", &scene::modulus_1, "Pa"},
                                parameter{"youngs_modulus_2", &scene::modulus_2, "Pa"},
                                parameter{"poissons_ratio_1", &scene::poissons_ratio_1, ""},
                                parameter{"poissons_ratio_2", &scene::poissons_ratio_2, ""},
                                parameter{"density_1", &scene::density_1, "kg/m^3"},
                                parameter{"density_2", &scene::density_2, "kg/m^3"},
                                parameter{"speed", &scene::speed, "m/s"},
                                parameter{"angle", &scene::angle, "rad"},
                                parameter{"spin_1", &scene::spin_1, "rad/s"},
                                parameter{"spin_2", &scene::spin_2, "rad/s"},
                                parameter{"work_of_adhesion", &scene::work_of_adhesion, "J/m^2"},
                                parameter{"interaction_range", &scene::interaction_range, "m"},
                                parameter{"force_per_length", &scene::force_per_length, "N/m"},
                                parameter{"rebound_coefficient", &scene::rebound_coefficient, "s/m"},
                                parameter{"peeling_moment", &scene::peeling_moment, "N m"},
                                parameter{"relaxation_time", &scene::relaxation_time, "s"},
                                parameter{"modulus_ratio", &scene::modulus_ratio, ""},
                                parameter{"reference_speed", &scene::edge_speed, "m/s"},
                                parameter{"exponent", &scene::edge_exponent, ""},
                                parameter{"bulk_time", &scene::bulk_time, "s"},
                                parameter{"hunt_crossley_coefficient", &scene::hunt_crossley_coefficient, "s/m"},
                                parameter{"tsuji_coefficient", &scene::tsuji_coefficient, ""},
                                parameter{"stiffness", &scene::stiffness, "N/m"},
                                parameter{"dashpot_coefficient", &scene::dashpot_coefficient, "N s/m"},
                                parameter{"friction_coefficient", &scene::friction_coefficient, ""},
                                parameter{"stiffness_ratio", &scene::stiffness_ratio, ""},
                                parameter{"yield_strength", &scene::yield_strength, "Pa"},
                                parameter{"tolerance", &scene::tolerance, ""}};

class source {
public:
  source(std::uint64_t seed, std::uint64_t index, extent from) : wide_(from != extent::documented) {
    std::seed_seq all{seed, seed >> 32, index, index >> 32, std::uint64_t(from)};
    generator_.seed(all);
  }

  source(const std::vector<double>& choices, extent from)
      : choices_(choices), given_(true), wide_(from != extent::documented) {}

  std::uint64_t below(std::uint64_t n) {
    if (given_)
      return std::min(n - 1, static_cast<std::uint64_t>(next() * double(n)));
    const std::uint64_t chosen = std::uniform_int_distribution<std::uint64_t>(0, n - 1)(generator_);
    choices_.push_back((double(chosen) + 0.5) / double(n));
    return chosen;
  }
  double uniform(double low, double high) {
    if (!given_)
      choices_.push_back(std::generate_canonical<double, 53>(generator_));
    return low + (high - low) * (given_ ? next() : choices_.back());
  }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }

  /// In the documented range, or the wide one.
  double in(double low, double high, double wide_low, double wide_high) {
    return wide_ ? log_uniform(wide_low, wide_high) : log_uniform(low, high);
  }
  /// The same, and every tenth time zero.
  double or_zero(double x) { return below(10) == 0 ? 0 : x; }

  bool wide() const { return wide_; }
  const std::vector<double>& choices() const { return choices_; }

private:
  double next() { return place_ < choices_.size() ? choices_[place_++] : 0.5; }

  std::mt19937_64 generator_;
  std::vector<double> choices_; ///< to be made, or made so far
  std::size_t place_ = 0;
  bool given_ = false, wide_;
};

double contact_time(const scene& s) {
  using ricochet::in_si;
  const ricochet::contact_pair pair = s.pair();
  const double m = in_si(pair.reduced_mass), R = in_si(pair.reduced_radius), E = in_si(pair.reduced_modulus);
  return 2.87 * std::pow(m / E / R * (m / E) / s.speed, 0.2);
}

constexpr std::array modulus_ratios{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1,
                                    0.2,  0.3,  0.4,  0.5,  0.6,  0.7,  0.8,  0.9,  0.95, 0.98};

/// Replaces one number by one that is not allowed.
void spoil(scene& s, source& random) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  constexpr std::array bodies{&scene::radius_1, &scene::modulus_1, &scene::density_1, &scene::speed, &scene::tolerance};
  constexpr std::array values{nan, -infinity, -1., 0., infinity};
  s.*bodies[random.below(bodies.size())] = values[random.below(values.size())];
  if (random.below(10) == 0)
    s.poissons_ratio_2 = 0.5;
}

} // namespace

ricochet::contact_pair scene::pair() const {
  using namespace ricochet::units;
  const auto solid = [](double modulus, double poissons_ratio, double density) {
    return ricochet::material{.youngs_modulus = modulus * pascals,
                              .poissons_ratio = poissons_ratio,
                              .mass_density = density * kilograms_per_cubic_metre};
  };
  const ricochet::sphere one{solid(modulus_1, poissons_ratio_1, density_1), radius_1 * metres};
  const ricochet::material other = solid(modulus_2, poissons_ratio_2, density_2);
  return wall ? ricochet::between(one, ricochet::flat_wall{other})
              : ricochet::between(one, ricochet::sphere{other, radius_2 * metres});
}

std::string scene::text() const {
  std::string all;
  for (const parameter& p : parameters)
    if (p.name != std::string_view("radius_2") || !wall)
      all += fmt::format("  {:26} {:.17g} {}\n", p.name, this->*p.member, p.unit);
  return all;
}

std::vector<std::string> scene::names() {
  std::vector<std::string> all;
  for (const parameter& p : parameters)
    all.emplace_back(p.name);
  return all;
}

std::vector<std::string> scene::units() {
  std::vector<std::string> all;
  for (const parameter& p : parameters)
    all.emplace_back(*p.unit ? p.unit : "1");
  return all;
}

std::vector<std::string> scene::values() const {
  std::vector<std::string> all;
  for (const parameter& p : parameters)
    all.push_back(wall && p.member == &scene::radius_2 ? "inf" : fmt::format("{:.17g}", this->*p.member));
  return all;
}

scene scene::of(const std::map<std::string, std::string>& values_by_name) {
  scene s{};
  for (const parameter& p : parameters)
    s.*p.member = std::stod(values_by_name.at(p.name));
  s.wall = std::isinf(s.radius_2);
  return s;
}

namespace {
scene drawn_from(source& random, extent from) {
  scene s{};
  s.wall = random.below(2) == 0;
  for (const bool second : {false, true}) {
    (second ? s.radius_2 : s.radius_1) = random.in(1e-8, 0.1, 1e-9, 1);
    (second ? s.modulus_2 : s.modulus_1) = random.in(1e5, 1e12, 1e3, 1e12);
    (second ? s.poissons_ratio_2 : s.poissons_ratio_1) = random.or_zero(random.uniform(0, 0.4999));
    (second ? s.density_2 : s.density_1) = random.in(100, 2e4, 1, 2e4);
  }
  s.speed = random.in(1e-4, 1e3, 1e-9, 1e4);
  s.angle = random.or_zero(random.below(10) == 0 ? std::numbers::pi / 2 - random.log_uniform(1e-6, 0.1)
                                                 : random.uniform(0, std::numbers::pi / 2));
  const auto spin_of = [&](double radius) { // one draw a statement: their order is to be the same with every compiler
    const double sign = random.below(2) == 0 ? -1 : 1;
    const double over_rolling = random.log_uniform(1e-3, 1e3);
    return random.or_zero(sign * over_rolling * s.speed / radius);
  };
  s.spin_1 = spin_of(s.radius_1);
  s.spin_2 = s.wall ? 0 : spin_of(s.radius_2);

  using ricochet::in_si;
  const ricochet::contact_pair pair = s.pair();
  const double time = contact_time(s), R = in_si(pair.reduced_radius), E = in_si(pair.reduced_modulus),
               m = in_si(pair.reduced_mass);
  s.work_of_adhesion = random.or_zero(random.in(1e-3, 10, 1e-6, 1e3));
  s.interaction_range = random.in(1e-10, 1e-9, 1e-11, 1e-7);
  s.force_per_length = random.or_zero(random.in(1e-3, 10, 1e-6, 1e4));
  s.rebound_coefficient = random.or_zero(random.in(1e-3, 10, 1e-6, 1e4)) / s.speed;
  s.peeling_moment = random.or_zero(random.in(1e-4, 10, 1e-6, 1e4)) * s.force_per_length * R * R;
  s.relaxation_time =
      random.or_zero(random.wide() ? random.log_uniform(1e-24, 1) : random.log_uniform(1e-8, 1e2) * time);
  s.modulus_ratio = modulus_ratios[random.below(modulus_ratios.size())];
  s.edge_speed = random.in(1e-6, 1e3, 1e-9, 1e6);
  s.edge_exponent = random.uniform(0.1, 1);
  s.bulk_time = random.or_zero(random.wide() ? random.log_uniform(1e-24, 1) : random.log_uniform(1e-8, 10) * time);
  s.hunt_crossley_coefficient = random.or_zero(random.in(1e-4, 1e2, 1e-8, 1e6)) / s.speed;
  s.tsuji_coefficient = random.or_zero(random.in(1e-4, 4, 1e-6, 1e3));
  s.stiffness = random.in(1e-3, 10, 1e-6, 1e3) * E * R;
  s.dashpot_coefficient = random.or_zero(random.in(1e-4, 3, 1e-6, 1e3)) * 2 * std::sqrt(m * s.stiffness);
  s.friction_coefficient = random.or_zero(random.in(1e-3, 2, 1e-6, 10));
  s.stiffness_ratio = random.uniform(0.6, 1);
  s.yield_strength = random.in(1e6, 1e12, 1e3, 1e12);
  s.tolerance = random.in(1e-10, 1e-2, 1e-12, 0.1);
  if (from == extent::bad)
    spoil(s, random);
  return s;
}
} // namespace

scene draw(std::uint64_t seed, std::uint64_t index, extent from) {
  source random(seed, index, from);
  return drawn_from(random, from);
}

scene drawn_by(const std::vector<double>& choices, extent from) {
  source given(choices, from);
  return drawn_from(given, from);
}

std::vector<double> choices_of(std::uint64_t seed, std::uint64_t index, extent from) {
  source random(seed, index, from);
  drawn_from(random, from);
  return random.choices();
}

const char* name_of(extent from) {
  return from == extent::documented ? "documented" : from == extent::wide ? "wide" : "bad";
}

} // namespace campaign
