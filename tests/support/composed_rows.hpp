// Scenes of a CSV file that names each of their numbers in SI, the reduced ones of the pair included: what is read is
// the scene to the last bit, whatever the scalar type.
#pragma once
#include "support/reference_rows.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/end.hpp>

namespace support {

using row = std::map<std::string, std::string>;

/// Columns and their units.
inline constexpr std::pair<const char*, const char*> scene_columns[] = {{"model", "-"},
                                                                        {"reduced_modulus", "Pa"},
                                                                        {"reduced_radius", "m"},
                                                                        {"reduced_mass", "kg"},
                                                                        {"speed", "m/s"},
                                                                        {"bulk_time", "s"},
                                                                        {"hunt_crossley_coefficient", "s/m"},
                                                                        {"tsuji_coefficient", "1"},
                                                                        {"work_of_adhesion", "J/m^2"},
                                                                        {"force_per_length", "N/m"},
                                                                        {"rebound_coefficient", "s/m"},
                                                                        {"relaxation_time", "s"},
                                                                        {"modulus_ratio", "1"},
                                                                        {"interaction_range", "m"}};

inline impact impact_of(const row& r) { return {number(r, "speed") * metres_per_second}; }

/// Calls `use(model)` with the laws and numbers of this row.
template <class Use>
void compose_numbers(const row& r, const Use& use) {
  const contact_pair pair{.reduced_modulus = number(r, "reduced_modulus") * pascals,
                          .reduced_radius = number(r, "reduced_radius") * metres,
                          .reduced_mass = number(r, "reduced_mass") * kilograms};
  const auto viscous = [&] { return kuwabara_kono{number(r, "bulk_time") * seconds}; };
  const auto in_proportion = [&] { return hunt_crossley{number(r, "hunt_crossley_coefficient") * seconds_per_metre}; };
  const auto constant = [&] { return tsuji{number(r, "tsuji_coefficient")}; };
  const auto work = [&] { return number(r, "work_of_adhesion") * joules_per_square_metre; };
  const auto edge = [&] {
    return greenwood{.relaxation_time = number(r, "relaxation_time") * seconds,
                     .modulus_ratio = number(r, "modulus_ratio"),
                     .interaction_range = number(r, "interaction_range") * metres};
  };
  const std::string& name = r.at("model");
  if (name == "hertz+kuwabara_kono")
    use(compose(pair, hertz{}, viscous()));
  else if (name == "hertz+kuwabara_kono+end_at_zero_overlap")
    use(compose(pair, hertz{}, viscous(), end_at_zero_overlap{}));
  else if (name == "hertz+hunt_crossley")
    use(compose(pair, hertz{}, in_proportion()));
  else if (name == "hertz+tsuji")
    use(compose(pair, hertz{}, constant()));
  else if (name == "hertz+tsuji+end_at_zero_overlap")
    use(compose(pair, hertz{}, constant(), end_at_zero_overlap{}));
  else if (name == "hertz+jkr")
    use(compose(pair, hertz{}, jkr{work()}));
  else if (name == "hertz+jkr+kuwabara_kono")
    use(compose(pair, hertz{}, jkr{work()}, viscous()));
  else if (name == "hertz+dmt+hunt_crossley")
    use(compose(pair, hertz{}, dmt{work()}, in_proportion()));
  else if (name == "hertz+line_force+hunt_crossley")
    use(compose(pair, hertz{},
                line_force{.force_per_length = number(r, "force_per_length") * newtons_per_metre,
                           .rebound_coefficient = number(r, "rebound_coefficient") * seconds_per_metre},
                in_proportion()));
  else if (name == "hertz+jkr+greenwood")
    use(compose(pair, hertz{}, jkr{work()}, edge()));
  else if (name == "hertz+jkr+greenwood+kuwabara_kono")
    use(compose(pair, hertz{}, jkr{work()}, edge(), viscous()));
  else
    throw std::runtime_error("no composition is called '" + name + "'");
}

} // namespace support
