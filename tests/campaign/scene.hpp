// One random scene: every number that a model of the library may ask for, in SI units.
#pragma once
#include <ricochet/body/pair.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace campaign {

/// Where scenes are drawn from.
enum class extent {
  documented, ///< the range that the library promises to master
  wide,       ///< all that physics and carelessness may ask for
  bad         ///< as `wide`, but one number is none that is allowed
};

struct scene {
  double radius_1, radius_2, modulus_1, modulus_2, poissons_ratio_1, poissons_ratio_2, density_1, density_2;
  bool wall; ///< in place of the second sphere
  double speed, angle, spin_1, spin_2;
  double work_of_adhesion, interaction_range;
  double force_per_length, rebound_coefficient, peeling_moment;
  double relaxation_time, modulus_ratio;
  double edge_speed, edge_exponent;
  double bulk_time, hunt_crossley_coefficient, tsuji_coefficient, stiffness, dashpot_coefficient;
  double friction_coefficient, stiffness_ratio;
  double yield_strength;
  double tolerance;

  ricochet::contact_pair pair() const;
  /// Names, values and units, for people.
  std::string text() const;

  /// For CSV files, in this order: names, units ("1" of a pure number), values with all digits; a wall's radius is inf.
  static std::vector<std::string> names(), units();
  std::vector<std::string> values() const;
  /// \throws std::out_of_range where a name is missing.
  static scene of(const std::map<std::string, std::string>& values_by_name);
};

/// Scene number `index` of the run with this seed: the same wherever and in whatever order it is drawn.
scene draw(std::uint64_t seed, std::uint64_t index, extent from);

/// The same from numbers between 0 and 1, one for each choice; those that are missing are 1/2. Near numbers give near
/// scenes of the same range.
scene drawn_by(const std::vector<double>& choices, extent from);
/// Those that draw() makes.
std::vector<double> choices_of(std::uint64_t seed, std::uint64_t index, extent from);

const char* name_of(extent from);

} // namespace campaign
