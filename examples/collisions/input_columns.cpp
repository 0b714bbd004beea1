#include "input_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

namespace collisions {

namespace {

struct input_column {
  const char* name;
  const char* unit;
  const char* needed_by;
};

constexpr std::array<input_column, 33> columns{{
    {"model", "", "every collision: law names joined by +, in any order"},
    {"radius_1", "m", "every collision"},
    {"radius_2", "m", "every collision; inf is a flat wall"},
    {"density_1", "kg/m^3", "every collision"},
    {"density_2", "kg/m^3", "every collision, but not of a wall"},
    {"youngs_modulus_1", "Pa", "every collision"},
    {"youngs_modulus_2", "Pa", "every collision"},
    {"poissons_ratio_1", "1", "every collision, from 0 to less than 0.5"},
    {"poissons_ratio_2", "1", "every collision, from 0 to less than 0.5"},
    {"speed", "m/s", "every collision: of the bodies relative to each other, at first touch"},
    {"angle", "degrees", "oblique impacts: between velocity and normal, 0 to less than 90; needs friction"},
    {"spin_1", "rad/s", "spinning bodies: > 0 where it would roll forward along the other; needs friction"},
    {"spin_2", "rad/s", "likewise; not of a wall"},
    {"stiffness", "N/m", "linear"},
    {"work_of_adhesion", "J/m^2",
     "jkr, dmt, maugis_dugdale: of the pair, twice the surface free energy for like bodies"},
    {"line_force", "N/m", "line_force: ring force per length of the contact's edge"},
    {"rebound_coefficient", "s/m", "line_force: how much stronger it is on the rebound; or zeta_a; 0 without both"},
    {"zeta_a", "1", "line_force: Brach and Dunn's damping ratio, at the speed along the normal"},
    {"relaxation_time", "s", "greenwood, greenwood_fit"},
    {"modulus_ratio", "1", "greenwood: relaxed over instantaneous, 0.0001 to 0.98 (greenwood_fit: 0.02 or blank)"},
    {"interaction_range", "m", "greenwood, greenwood_fit, maugis_dugdale"},
    {"reference_speed", "m/s", "maugis_barquins: of the edge where it opens at twice the work of adhesion"},
    {"exponent", "1", "maugis_barquins: of the edge's speed, 0.1 to 1"},
    {"bulk_time", "s", "kuwabara_kono"},
    {"hunt_crossley_coefficient", "s/m", "hunt_crossley; or zeta_h"},
    {"zeta_h", "1", "hunt_crossley: Brach and Dunn's damping ratio, likewise"},
    {"tsuji_coefficient", "1", "tsuji"},
    {"dashpot_coefficient", "N s/m", "linear_dashpot; or zeta"},
    {"zeta", "1", "linear_dashpot: damping ratio with the row's stiffness, 1 is critical"},
    {"friction", "1", "coulomb, coulomb_with_peeling, mindlin: coefficient of friction"},
    {"peeling_moment", "N m", "coulomb_with_peeling: at zero it is coulomb"},
    {"stiffness_ratio", "1", "mindlin: along the surface over along the normal; that of the solids if blank"},
    {"yield_strength", "Pa", "thornton_ning, thornton_ning_contact: of the weaker body"},
}};

/// How many letters are to be put in, left out or changed, whatever their case.
std::size_t edit_distance(const std::string& a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
  std::vector<std::size_t> before(b.size() + 1), now(b.size() + 1);
  std::iota(before.begin(), before.end(), std::size_t(0));
  for (const char c : a) {
    now[0] = before[0] + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
      now[j + 1] = std::min({now[j] + 1, before[j + 1] + 1, before[j] + (lower(c) != lower(b[j]))});
    std::swap(before, now);
  }
  return before.back();
}

/// The input column that a column of the header is likely to be meant for, rather one that is missing.
std::optional<std::string> meant_by(const std::string& name, const header& header) {
  constexpr std::size_t farthest = 2, letters_for_each = 3; // of a short name hardly any may differ
  std::optional<std::string> meant;
  auto least = std::pair(farthest + 1, false);
  for (const input_column& column : columns) {
    if (name == column.name)
      return {};
    if (name.size() >
        std::string_view(column.name).size() + farthest) // before its letters are compared: it may be long
      continue;
    const auto how_far = std::pair(edit_distance(name, column.name), header.has(column.name));
    if (how_far < least && letters_for_each * how_far.first <= std::string_view(column.name).size()) {
      least = how_far;
      meant = column.name;
    }
  }
  return meant;
}

} // namespace

std::optional<std::string> unit_of(const std::string& name) {
  for (const input_column& column : columns)
    if (name == column.name)
      return column.unit;
  return {};
}

std::string input_help() {
  std::string all;
  for (const input_column& column : columns)
    all += fmt::format("  {:<27}{:<8}{}\n", column.name, column.unit, column.needed_by);
  return all;
}

std::string hint_for(const std::string& name) {
  const auto meant = meant_by(name, header(csv_record{}));
  return meant ? fmt::format("; did you mean {}?", *meant) : "";
}

std::vector<std::string> notes_on_misspelt(const header& header) {
  std::vector<std::string> notes;
  for (const std::string& cell : header.cells())
    if (const auto meant = meant_by(trimmed(cell), header))
      notes.push_back(fmt::format("column {} is copied through: did you mean {}?", quoted(trimmed(cell)), *meant));
  return notes;
}

} // namespace collisions
