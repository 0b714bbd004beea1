#include "output_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace collisions {

namespace {

using ricochet::ending;

std::string text(double x) { return fmt::format("{:.17g}", x); }
std::string text(long x) { return fmt::format("{}", x); }
std::string text(bool x) { return x ? "1" : "0"; }
std::string text(const std::optional<double>& x) { return x ? text(*x) : ""; }
template <class Unit>
std::string text(const boost::units::quantity<Unit>& x) {
  return text(ricochet::in_si(x));
}

std::string restitution(const outcome& out) {
  if (out.ending == ending::captured)
    return "0";
  return out.ending == ending::separated && out.restitution ? text(*out.restitution) : "";
}

/// What friction did, blank without it.
template <auto Member>
std::string friction(const outcome& out) {
  return out.friction ? text((*out.friction).*Member) : "";
}

std::string rebound_angle(const outcome& out) {
  return out.friction && out.friction->rebound_angle ? text(*out.friction->rebound_angle / ricochet::units::degrees)
                                                     : "";
}

struct output_column {
  const char* name;
  const char* unit;
  const char* meaning;
  std::string (*text)(const outcome&);
};

constexpr std::array<output_column, 28> columns{{
    {"ending", "text", "separated | captured | unresolved | failed",
     [](const outcome& out) -> std::string { return ricochet::name_of(out.ending); }},
    {"restitution", "1", "speed of separation over that of approach, along the normal; 0 when captured", restitution},
    {"contacts", "1", "how often the bodies touched", [](const outcome& out) { return text(long(out.contacts)); }},
    {"contact_duration", "s", "first touch to final loss of contact (so far, when captured)",
     [](const outcome& out) { return text(out.contact_duration); }},
    {"max_approach", "m", "largest mutual approach", [](const outcome& out) { return text(out.max_approach); }},
    {"max_contact_radius", "m", "largest contact radius",
     [](const outcome& out) { return text(out.max_contact_radius); }},
    {"max_tension", "N", "largest total tension", [](const outcome& out) { return text(out.max_tension); }},
    {"max_compression", "N", "largest total compression", [](const outcome& out) { return text(out.max_compression); }},
    {"crack_loss", "1", "lost at the contact's edge, fraction of the initial kinetic energy, jumps included",
     [](const outcome& out) { return text(out.crack_loss); }},
    {"bulk_loss", "1", "lost in the bulk, likewise", [](const outcome& out) { return text(out.bulk_loss); }},
    {"plastic_loss", "1", "taken by plastic flow, likewise; blank without a plasticity law",
     [](const outcome& out) { return text(out.plastic_loss); }},
    {"ledger_residual", "1", "what the energy balance leaves unexplained, over the largest energy met",
     [](const outcome& out) { return text(out.ledger_residual); }},
    {"error_estimate", "1", "bound of the error of the restitution",
     [](const outcome& out) { return text(out.error_estimate); }},
    {"ending_is_certain", "1 or 0", "0 so near the threshold of sticking that the error does not decide",
     [](const outcome& out) { return text(out.ending_is_certain); }},
    {"evaluations", "1", "evaluations of the equations of motion",
     [](const outcome& out) { return text(out.evaluations); }},
    {"tangential_speed", "m/s",
     "at the ending, along its first direction; this and what follows: with friction, else blank",
     friction<&friction_outcome::tangential_speed>},
    {"spin_1_after", "rad/s", "spin of the first body", friction<&friction_outcome::spin_1>},
    {"spin_2_after", "rad/s", "spin of the second body", friction<&friction_outcome::spin_2>},
    {"tangential_restitution", "1", "tangential speed over the first; blank if that was 0",
     friction<&friction_outcome::tangential_restitution>},
    {"rebound_angle", "degrees", "between normal and relative velocity, > 0 forward; blank when captured",
     rebound_angle},
    {"impulse_ratio", "1", "tangential over normal impulse, > 0 where it slows the motion",
     friction<&friction_outcome::impulse_ratio>},
    {"friction_loss", "1", "taken by friction, fraction of the initial kinetic energy along the normal",
     friction<&friction_outcome::friction_loss>},
    {"peeling_loss", "1", "taken by the peeling moment, likewise; blank without coulomb_with_peeling",
     friction<&friction_outcome::peeling_loss>},
    {"rolls", "1 or 0", "1 if the contact point slides no longer; mindlin: if it sticks somewhere",
     friction<&friction_outcome::rolls>},
    {"rotation_1", "rad", "angle that the first body turned during contact", friction<&friction_outcome::rotation_1>},
    {"rotation_2", "rad", "angle that the second body turned", friction<&friction_outcome::rotation_2>},
    {"normal_turn", "rad", "angle that the normal would have turned, neglected",
     friction<&friction_outcome::normal_turn>},
    {"warnings", "text", "a sentence for each law used outside its range; blank if there is none",
     [](const outcome& out) { return fmt::format("{}", fmt::join(out.warnings, "; ")); }},
}};

/// The cell as CSV: in quotes where it must be.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos && !text.starts_with('#'))
    return text;
  std::string out = "\"";
  for (const char c : text)
    out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

bool is_output(const std::string& name) {
  return std::any_of(columns.begin(), columns.end(), [&](const output_column& c) { return c.name == name; });
}

} // namespace

std::string units_line() {
  std::string line = "# units: SI;";
  for (const output_column& column : columns)
    line += fmt::format(" {} [{}]", column.name, column.unit);
  return line + '\n';
}

std::string output_help() {
  std::string all;
  for (const output_column& column : columns)
    all += fmt::format("  {:<27}{:<8}{}\n", column.name, column.unit, column.meaning);
  return all;
}

std::string header_line(const header& header) {
  std::set<std::string> taken;
  for (const std::string& name : header.cells())
    taken.insert(trimmed(name));
  std::string line;
  for (const std::string& name : header.cells()) {
    std::string copied = name;
    if (is_output(trimmed(name))) {
      for (copied = "input_" + trimmed(name); taken.contains(copied);)
        copied = "input_" + copied;
      taken.insert(copied);
    }
    line += cell(copied) + ',';
  }
  for (const output_column& column : columns)
    line += column.name + std::string(&column == &columns.back() ? "\n" : ",");
  return line;
}

std::vector<std::string> copied_cells(const header& header, const csv_record& record) {
  std::vector<std::string> cells = record.cells;
  cells.resize(header.cells().size());
  return cells;
}

std::string row_line(const header& header, const csv_record& record, const outcome* result) {
  std::string line;
  for (const std::string& copied : copied_cells(header, record))
    line += cell(copied) + ',';
  const bool failed = !result || result->ending == ending::failed;
  for (const output_column& column : columns) {
    if (!failed)
      line += cell(column.text(*result));
    else if (&column == &columns.front())
      line += ricochet::name_of(ending::failed);
    line += &column == &columns.back() ? '\n' : ',';
  }
  return line;
}

std::optional<written_row> read_written(const header& header, const csv_record& record) {
  const std::size_t copied = header.cells().size();
  if (!record.error.empty() || record.cells.size() != copied + columns.size())
    return {};
  const auto first = record.cells.begin() + static_cast<std::ptrdiff_t>(copied);
  static_assert(std::string_view(columns.front().name) == "ending" &&
                std::string_view(columns.back().name) == "warnings");
  return written_row{.copied = {record.cells.begin(), first},
                     .resolved = *first == ricochet::name_of(ending::separated) ||
                                 *first == ricochet::name_of(ending::captured),
                     .warned = !record.cells.back().empty()};
}

} // namespace collisions
