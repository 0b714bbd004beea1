// Random collisions for the tests: materials of the table, radii, speeds and laws' parameters spread log-uniformly.
#pragma once
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <random>

namespace support {
using namespace ricochet;
using namespace ricochet::units;

/// The numbers of one random scene; which of them matter depends on the laws composed.
struct scene {
  sphere one, other; ///< of the other only the material where it is a wall
  bool wall;
  contact_pair pair;
  energy_per_area work_of_adhesion;
  ricochet::speed speed;
  duration relaxation_time, bulk_time;
  double modulus_ratio, tsuji_coefficient;
  length interaction_range;
  inverse_speed hunt_crossley_coefficient;
  ricochet::speed edge_speed;
  double edge_exponent;
  energy_per_area force_per_length;
  inverse_speed rebound_coefficient;
  modulus yield_strength;
};

inline contact_pair bodies(const scene& s) {
  return s.wall ? between(s.one, flat_wall{s.other.solid}) : between(s.one, s.other);
}

/// Strengths from the least that adhesion bears to ten times that: some scenes yield at touch nearly, some not at all.
inline thornton_ning_contact yielding(const scene& s) {
  const root_length flattening = jkr{s.work_of_adhesion}.flattening(s.pair);
  const double times = 1.01 + 2 * square(s.tsuji_coefficient);
  return {times * thornton_ning_contact{}.least_strength(s.pair, flattening)};
}

class scenes {
public:
  explicit scenes(unsigned seed) : generator_(seed) {}

  scene next() {
    using namespace materials;
    static const material solids[] = {
        steel,     silicon, quartz,         copper, polystyrene_latex, tedlar, silver_coated_glass,
        water_ice, acrylic, aluminium_alloy};
    const sphere one{solids[generator_() % 10], log_uniform(5e-7, 1e-4) * metres};
    const sphere other{solids[generator_() % 10], log_uniform(5e-7, 1e-4) * metres};
    scene s{};
    s.one = one, s.other = other;
    s.wall = generator_() % 2 == 0;
    s.pair = bodies(s);
    s.work_of_adhesion = log_uniform(0.02, 3) * joules_per_square_metre;
    const double E = in_si(s.pair.reduced_modulus), R = in_si(s.pair.reduced_radius), m = in_si(s.pair.reduced_mass);
    const double sticking =
        std::sqrt(14.18 / m) * std::pow(in_si(s.work_of_adhesion), 5. / 6) * std::pow(R, 2. / 3) / std::cbrt(E);
    s.speed = sticking * log_uniform(1.3, 30) * metres_per_second;
    const double contact_time = 2.87 * std::pow(m * m / (R * E * E * in_si(s.speed)), 0.2);
    s.relaxation_time = contact_time * log_uniform(1e-4, 2e-2) * seconds;
    s.bulk_time = contact_time * log_uniform(1e-3, 0.1) * seconds;
    s.modulus_ratio = log_uniform(2e-3, 0.5);
    s.interaction_range = log_uniform(2e-10, 4e-10) * metres;
    s.hunt_crossley_coefficient = log_uniform(1e-2, 1) / s.speed;
    s.tsuji_coefficient = log_uniform(1e-2, 2);
    // drawn from the scene, lest the scenes that follow change: 10 to 2500 radii of JKR's jump in a contact time
    const double jump = std::cbrt(6.28 * in_si(s.work_of_adhesion) * R * R / E);
    s.edge_exponent = 0.3 + 0.35 * s.tsuji_coefficient;
    s.edge_speed = 10 * s.modulus_ratio / 2e-3 * jump / contact_time * metres_per_second;
    s.force_per_length = std::cbrt(square(in_si(s.work_of_adhesion)) * E * R) * newtons_per_metre; // binds as w would
    s.rebound_coefficient = s.hunt_crossley_coefficient;
    s.yield_strength = yielding(s).yield_strength;
    return s;
  }

  double log_uniform(double low, double high) {
    return low * std::exp(std::uniform_real_distribution<>(0, std::log(high / low))(generator_));
  }

private:
  std::mt19937_64 generator_;
};

// The instances, composed from a scene; `also` are requests and end conditions.
inline auto hertzian(const scene& s, auto... also) { return compose(s.pair, hertz{}, also...); }
inline auto viscous_hertz(const scene& s, auto... also) { return hertzian(s, kuwabara_kono{s.bulk_time}, also...); }
inline auto hunt_crossley_hertz(const scene& s, auto... also) {
  return hertzian(s, hunt_crossley{s.hunt_crossley_coefficient}, also...);
}
inline auto tsuji_hertz(const scene& s, auto... also) { return hertzian(s, tsuji{s.tsuji_coefficient}, also...); }
inline auto static_jkr(const scene& s, auto... also) { return hertzian(s, jkr{s.work_of_adhesion}, also...); }
inline auto viscous_jkr(const scene& s, auto... also) { return static_jkr(s, kuwabara_kono{s.bulk_time}, also...); }
inline auto viscoelastic_jkr_fit(const scene& s, auto... also) {
  return viscous_jkr(s, greenwood_fit{.relaxation_time = s.relaxation_time, .interaction_range = s.interaction_range},
                     also...);
}
inline auto viscoelastic_jkr(const scene& s, auto... also) {
  return viscous_jkr(s,
                     greenwood{.relaxation_time = s.relaxation_time,
                               .modulus_ratio = s.modulus_ratio,
                               .interaction_range = s.interaction_range},
                     also...);
}
inline auto power_law_jkr(const scene& s, auto... also) {
  return viscous_jkr(s, maugis_barquins{.reference_speed = s.edge_speed, .exponent = s.edge_exponent}, also...);
}

inline auto yielding_hertz(const scene& s, auto... also) { return hertzian(s, yielding(s), also...); }
inline auto yielding_jkr(const scene& s, auto... also) { return static_jkr(s, yielding(s), also...); }
inline auto viscous_yielding_jkr(const scene& s, auto... also) { return viscous_jkr(s, yielding(s), also...); }

/// The restitution (0 when captured) to the precision of long double.
template <class Model>
double reference_restitution(const Model& model, speed v) {
  const scales unit = scales_at(model, v);
  const reduced_model<long double, Model> numbers(model, unit);
  collision<decltype(numbers), stepper::fehlberg78> solver(numbers, 1e-17L, 40'000'000);
  return static_cast<double>(solver.solve(reduce<long double>(v, unit)).restitution.value_or(0));
}

} // namespace support
