// The reference collisions of tests/data, as scenes and expected outcomes.
#pragma once
#include "support/random_scenes.hpp"
#include "support/rows.hpp"

namespace support {

#ifdef RICOCHET_TEST_DATA
/// Those of a file of tests/data.
inline std::vector<std::map<std::string, std::string>> read_rows(const std::string& file) {
  return rows_of(RICOCHET_TEST_DATA "/" + file);
}
#endif

inline double number(const std::map<std::string, std::string>& row, const std::string& name) {
  return std::stod(row.at(name));
}

/// The bodies of a row.
inline contact_pair bodies(const std::map<std::string, std::string>& row) {
  const auto solid = [&](const std::string& which) {
    return material{number(row, "youngs_modulus_" + which) * pascals, number(row, "poissons_ratio_" + which),
                    number(row, "density_" + which) * kilograms_per_cubic_metre};
  };
  const sphere one{solid("1"), number(row, "radius_1") * metres};
  if (row.at("radius_2") == "inf")
    return between(one, flat_wall{solid("2")});
  return between(one, sphere{solid("2"), number(row, "radius_2") * metres});
}

/// Calls `use(model)` with the model that the row names, composed with the requests given.
template <class Use, class... Requests>
void compose_row(const std::map<std::string, std::string>& row, const Use& use, Requests... requests) {
  const contact_pair pair = bodies(row);
  const std::string& name = row.at("model");
  const auto has = [&](const char* law) { return name.find(law) != std::string::npos; };
  const kuwabara_kono viscous{number(row, "bulk_time") * seconds};
  if (!has("jkr"))
    return use(compose(pair, hertz{}, viscous, requests...));
  const jkr adhesive{number(row, "work_of_adhesion") * joules_per_square_metre};
  if (!has("greenwood"))
    return use(compose(pair, hertz{}, viscous, adhesive, requests...));
  const duration relaxation_time = number(row, "relaxation_time") * seconds;
  const length interaction_range = number(row, "interaction_range") * metres;
  if (has("greenwood_fit"))
    return use(compose(pair, hertz{}, viscous, adhesive,
                       greenwood_fit{.relaxation_time = relaxation_time, .interaction_range = interaction_range},
                       requests...));
  use(compose(pair, hertz{}, viscous, adhesive,
              greenwood{.relaxation_time = relaxation_time,
                        .modulus_ratio = number(row, "modulus_ratio"),
                        .interaction_range = interaction_range},
              requests...));
}

/// Two spheres of water ice, radius 2 um: the ice case of Krijt 2013, section 3.
struct ice_case {
  contact_pair pair =
      between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
  duration relaxation_time = 1e-11 * seconds;
  jkr adhesive{0.74 * joules_per_square_metre};
  kuwabara_kono viscous{bulk_time_of_krijt(relaxation_time, 0.25)};
  length interaction_range = 0.3 * nanometres;

  greenwood_fit fitted() const { return {.relaxation_time = relaxation_time, .interaction_range = interaction_range}; }
  greenwood exact(duration T, double k = 0.02) const {
    return {.relaxation_time = T, .modulus_ratio = k, .interaction_range = interaction_range};
  }
};

} // namespace support
