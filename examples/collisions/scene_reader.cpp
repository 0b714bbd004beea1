#include "scene_reader.hpp"

#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/closed_form/linear.hpp>
#include <ricochet/model/composable.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace collisions {

namespace {

constexpr const char* everyone = "every collision"; ///< who needs a column that all models need

/// Column of a parameter of the law so named; empty for one that keeps its default.
std::string column_of(std::string_view law, std::string_view parameter) {
  if (law == "linear_dashpot")
    return "dashpot_coefficient";
  if (parameter == "damping_coefficient")
    return std::string(law) + "_coefficient";
  if (parameter == "force_per_length")
    return "line_force";
  if (parameter == "friction_coefficient")
    return "friction";
  if (parameter == "first_ratio_over_k" || parameter == "ratio_at_touch")
    return "";
  return std::string(parameter);
}

/// Column of the damping ratio that may stand in this column's stead; empty where there is none.
std::string ratio_column_of(const std::string& column) {
  return column == "hunt_crossley_coefficient" ? "zeta_h"
         : column == "rebound_coefficient"     ? "zeta_a"
         : column == "dashpot_coefficient"     ? "zeta"
                                               : "";
}

template <class Law>
bool may_be_blank(const std::string& column) {
  return column.empty() || column == "rebound_coefficient" ||
         (std::is_same_v<Law, ricochet::greenwood_fit> && column == "modulus_ratio");
}

/// The coefficient that the row's damping ratio stands for: of a dashpot beside its spring, which has been read, of
/// others at the row's speed along the normal.
template <class Coefficient>
Coefficient read_ratio(const row& row, const std::string& column, const std::string& ratio_column, const scene& scene,
                       std::string_view name) {
  if (!row.is_blank(column))
    throw row_error(row.place(ratio_column),
                    fmt::format("{} is given too, and says the same: keep one of the two", column));
  const auto ratio = row.quantity<double>(ratio_column, ricochet::non_negative, name);
  if constexpr (std::is_same_v<Coefficient, ricochet::damping>)
    return ricochet::closed_form::damping_coefficient_of(ratio, scene.pair, std::get<ricochet::linear>(scene.elastic));
  else
    return ricochet::closed_form::damping_coefficient_of_brach_dunn(ratio, scene.pair, scene.normal_speed());
}

ricochet::material read_material(const row& row, const std::string& body, bool with_density);

/// The law with its parameters from the row, each within the range that the law states. Bodies and motion of the scene
/// have been read.
template <class Law>
Law read_law(const row& row, const scene& scene, std::string_view name) {
  Law law{};
  const auto read = [&](const auto& parameter) {
    const std::string column = column_of(name, parameter.name), ratio = ratio_column_of(column);
    auto& value = law.*(parameter.member);
    using quantity = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<quantity, ricochet::inverse_speed> || std::is_same_v<quantity, ricochet::damping>) {
      if (!ratio.empty() && !row.is_blank(ratio)) {
        value = read_ratio<quantity>(row, column, ratio, scene, name);
        return;
      }
    }
    if constexpr (std::is_same_v<Law, ricochet::mindlin>) {
      if (column == "stiffness_ratio" && row.is_blank(column)) {
        value = ricochet::stiffness_ratio_of(read_material(row, "1", false), read_material(row, "2", false));
        return;
      }
    }
    if (!may_be_blank<Law>(column) || !row.is_blank(column))
      value = row.quantity<quantity>(column, parameter.allowed,
                                     ratio.empty() ? name : fmt::format("{}, unless there is {}", name, ratio));
  };
  if constexpr (requires { Law::parameters(); })
    std::apply([&](const auto&... parameters) { (read(parameters), ...); }, Law::parameters());
  if constexpr (requires { law.validate(); }) // only of the fits, which hold for one modulus ratio
    row.checked("modulus_ratio", [&] { law.validate(); });
  if constexpr (requires { law.validate(scene.pair); }) // only of maugis_dugdale
    row.checked("interaction_range", [&] { law.validate(scene.pair); });
  return law;
}

struct known_law {
  std::string_view name;
  ricochet::role_count roles;
  void (*put)(scene&, const row&, std::string_view name);
};

template <class Law, auto Role>
constexpr known_law law_in(std::string_view name) {
  return {name, ricochet::count_roles<Law>(),
          [](scene& scene, const row& row, std::string_view self) { scene.*Role = read_law<Law>(row, scene, self); }};
}

constexpr std::array<known_law, 20> laws{{
    law_in<ricochet::hertz, &scene::elastic>("hertz"),
    law_in<ricochet::linear, &scene::elastic>("linear"),
    law_in<ricochet::jkr, &scene::adhesion>("jkr"),
    law_in<ricochet::line_force, &scene::adhesion>("line_force"),
    law_in<ricochet::dmt, &scene::adhesion>("dmt"),
    law_in<ricochet::maugis_dugdale, &scene::adhesion>("maugis_dugdale"),
    law_in<ricochet::greenwood, &scene::crack>("greenwood"),
    law_in<ricochet::greenwood_fit, &scene::crack>("greenwood_fit"),
    law_in<ricochet::maugis_barquins, &scene::crack>("maugis_barquins"),
    law_in<ricochet::kuwabara_kono, &scene::damping>("kuwabara_kono"),
    law_in<ricochet::hunt_crossley, &scene::damping>("hunt_crossley"),
    law_in<ricochet::tsuji, &scene::damping>("tsuji"),
    law_in<ricochet::linear_dashpot, &scene::damping>("linear_dashpot"),
    law_in<ricochet::coulomb, &scene::tangential>("coulomb"),
    law_in<ricochet::coulomb_with_peeling, &scene::tangential>("coulomb_with_peeling"),
    law_in<ricochet::mindlin, &scene::tangential>("mindlin"),
    law_in<ricochet::thornton_ning, &scene::plasticity>("thornton_ning"),
    law_in<ricochet::thornton_ning_contact, &scene::plasticity>("thornton_ning_contact"),
    {"end_at_zero_force", ricochet::count_roles<ricochet::end_at_zero_force>(),
     [](scene&, const row&, std::string_view) {}}, // is the default
    law_in<ricochet::end_at_zero_overlap, &scene::end>("end_at_zero_overlap"),
}};

std::vector<std::string> names_in(const std::string& model) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= model.size();) {
    const std::size_t end = std::min(model.find('+', begin), model.size());
    names.push_back(trimmed(model.substr(begin, end - begin)));
    begin = end + 1;
  }
  return names;
}

const known_law& law_named(const std::string& name, const row& row) {
  const auto law = std::find_if(laws.begin(), laws.end(), [&](const known_law& l) { return l.name == name; });
  if (law == laws.end())
    throw row_error(row.place("model"), name.empty()
                                            ? "a law's name is missing beside a +"
                                            : fmt::format("unknown law {}; there are {}", quoted(name), known_laws()));
  return *law;
}

void add(ricochet::role_count& sum, const ricochet::role_count& n) {
  sum.elastic += n.elastic;
  sum.adhesion += n.adhesion;
  sum.crack += n.crack;
  sum.damping += n.damping;
  sum.end += n.end;
  sum.attraction += n.attraction;
  sum.tangential += n.tangential;
  sum.plasticity += n.plasticity;
  sum.flow += n.flow;
  sum.stick_slip += n.stick_slip;
  sum.peeling += n.peeling;
  sum.rebounding += n.rebounding;
  sum.edgeless += n.edgeless;
  sum.cohesion += n.cohesion;
}

/// Empty if this program solves the model, which the library composes, else the sentence of refusal.
std::string_view beyond_program(const std::vector<known_law>& model, const ricochet::role_count& roles) {
  const auto has = [&](std::string_view name) {
    return std::any_of(model.begin(), model.end(), [&](const known_law& law) { return law.name == name; });
  };
  if (has("linear") && roles.adhesion != 0)
    return "linear goes without adhesion here: take hertz, or the library in C++";
  if (has("linear") && roles.damping != 0 && !has("linear_dashpot"))
    return "linear goes without damping or with linear_dashpot here: take one of them, or the library in C++";
  if (has("linear_dashpot") && !has("linear"))
    return "linear_dashpot goes with linear here: take linear, or the library in C++";
  return "";
}

/// The laws named, which go together; the elastic one first.
std::vector<known_law> read_model(const row& row) {
  std::vector<known_law> model;
  ricochet::role_count roles;
  for (const std::string& name : names_in(row.text("model", everyone))) {
    model.push_back(law_named(name, row));
    add(roles, model.back().roles);
  }
  if (const std::string_view why = ricochet::refusal(roles); !why.empty())
    throw row_error(row.place("model"), std::string(why));
  if (const std::string_view why = beyond_program(model, roles); !why.empty())
    throw row_error(row.place("model"), std::string(why));
  std::stable_partition(model.begin(), model.end(), [](const known_law& law) { return law.roles.elastic != 0; });
  return model;
}

ricochet::material read_material(const row& row, const std::string& body, bool with_density) {
  ricochet::material solid{};
  solid.youngs_modulus = row.quantity<ricochet::modulus>("youngs_modulus_" + body, ricochet::positive, everyone);
  solid.poissons_ratio = row.quantity<double>("poissons_ratio_" + body, ricochet::poissons_ratio_range, everyone);
  solid.mass_density = with_density ? row.quantity<ricochet::density>("density_" + body, ricochet::positive, "a sphere")
                                    : ricochet::units::kilograms_per_cubic_metre; // of a wall: of no consequence
  return solid;
}

ricochet::contact_pair read_pair(const row& row) {
  constexpr ricochet::range positive_or_infinite{.low_included = false, .high_included = true};
  const auto radius = row.quantity<ricochet::length>("radius_1", ricochet::positive, everyone);
  const auto other_radius = row.quantity<ricochet::length>("radius_2", positive_or_infinite, everyone);
  const bool wall = std::isinf(other_radius.value());
  const ricochet::sphere body{read_material(row, "1", true), radius};
  const ricochet::material other = read_material(row, "2", !wall);
  return wall ? ricochet::between(body, ricochet::flat_wall{other})
              : ricochet::between(body, ricochet::sphere{other, other_radius});
}

/// \throws row_error where the bodies meet at an angle or spin, and the model has no friction to act on it.
void read_motion(const row& row, bool with_friction, scene& scene) {
  constexpr ricochet::range quarter_turn{.high = 90};
  constexpr ricochet::range any{.low = -std::numeric_limits<double>::max()};
  constexpr const char* add_friction = "needs friction: add coulomb or mindlin to the model";
  const bool wall = std::isinf(ricochet::in_si(scene.pair.bodies.radius_2));
  // Zero if blank; anything else is refused where there is a reason.
  const auto read = [&](const std::string& column, const ricochet::range& allowed, const std::string& refusal) {
    const double x = row.is_blank(column) ? 0 : row.quantity<double>(column, allowed, everyone);
    if (x != 0 && !refusal.empty())
      throw row_error(row.place(column), refusal);
    return x;
  };
  const std::string no_angle = with_friction ? "" : fmt::format("an oblique impact {}", add_friction);
  const std::string no_spin = with_friction ? "" : fmt::format("a spin {}", add_friction);
  scene.speed = row.quantity<ricochet::speed>("speed", ricochet::positive, everyone);
  scene.angle = read("angle", quarter_turn, no_angle) * ricochet::units::degrees;
  scene.spin_1 = read("spin_1", any, no_spin) * ricochet::units::radians_per_second;
  scene.spin_2 = read("spin_2", any, wall ? "a flat wall does not spin: leave it blank or 0" : no_spin) *
                 ricochet::units::radians_per_second;
}

} // namespace

std::string known_laws() {
  std::string all;
  for (const known_law& law : laws)
    all += (all.empty() ? "" : ", ") + std::string(law.name);
  return all;
}

scene scene_reader::read(const row& row) {
  const std::vector<known_law> model = read_model(row);
  scene scene{};
  scene.pair = read_pair(row);
  const bool with_friction =
      std::any_of(model.begin(), model.end(), [](const known_law& law) { return law.roles.tangential != 0; });
  read_motion(row, with_friction, scene);
  for (const known_law& law : model)
    law.put(scene, row, law.name);
  if (auto* exact = std::get_if<ricochet::greenwood>(&scene.crack))
    exact->table = table_for(exact->modulus_ratio);
  return scene;
}

std::shared_ptr<const ricochet::greenwood_table> scene_reader::table_for(double modulus_ratio) {
  constexpr std::size_t most = 256;
  if (tables_.size() >= most && !tables_.contains(modulus_ratio))
    tables_.clear();
  auto& table = tables_[modulus_ratio];
  if (!table)
    table = std::make_shared<const ricochet::greenwood_table>(modulus_ratio);
  return table;
}

} // namespace collisions
