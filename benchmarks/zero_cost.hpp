// What the two halves of zero_cost share. They are compiled apart: where a model's steps are used in several places, a
// compiler puts them together otherwise than where they are used in one.
#pragma once
#include "instances.hpp"
#include "measure.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

#include <vector>

namespace zero_cost {
using namespace ricochet;
using namespace ricochet::units;

/// Numbers of a random scene; which of them matter depends on the laws composed.
struct drawn {
  contact_pair pair;
  jkr adhesion;
  kuwabara_kono viscous;
  hunt_crossley crossley;
  line_force ring;
  greenwood edge;
  modulus yield_strength;
};

inline std::vector<drawn> draw(std::size_t count) {
  instances::random_numbers random;
  const auto table = std::make_shared<const greenwood_table>(0.02);
  std::vector<drawn> all;
  while (all.size() < count) {
    const auto [pair, numbers] = instances::next_pair(random);
    const auto& [E, R, m] = numbers;
    const double w = instances::work_of_adhesion_at(random.log_uniform(0.05, 0.3), numbers);
    const double T = 2.87 * random.log_uniform(1e-3, 1e-2), A = random.log_uniform(1e-3, 0.05);
    const double z0 = std::cbrt(R * w * w / (E * E)) / random.log_uniform(5, 50);
    const double yield_pressure = std::pow(0.25 * std::pow(E, 4) / (10.2 * R * R * R), 0.2); // from speed 0.5 on
    contact_pair bodies = pair;
    const length each = 2 * R * metres; // of two like spheres
    bodies.bodies = {each, each, 2 * m * kilograms, 2 * m * kilograms};
    drawn d{bodies,
            {w * joules_per_square_metre},
            {A * seconds},
            {random.log_uniform(0.01, 0.3) * seconds_per_metre},
            {0.01 / std::sqrt(R) * newtons_per_metre, 0.1 * seconds_per_metre},
            {T * seconds, 0.02, z0 * metres, 1.01, table},
            yield_pressure / 1.6 * pascals};
    if (d.yield_strength > thornton_ning_contact{}.least_strength(pair, d.adhesion.flattening(pair)))
      all.push_back(d);
  }
  return all;
}

/// Prints composed models beside the same equations by hand.
void absent_parts(const drawn& scene);
/// Prints what each part costs where it is there.
void present_parts(const std::vector<drawn>& scenes);

} // namespace zero_cost
