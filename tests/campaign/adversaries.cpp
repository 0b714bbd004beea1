#include "adversaries.hpp"

#include "support/rows.hpp"

#include <ricochet/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace campaign {

namespace {

using row = std::map<std::string, std::string>;

std::string shown(double x) { return fmt::format("{:.17g}", x); }

/// The first thing that is not as it should be; empty if all is.
std::string wrong_with(const row& each, const instance& of, double& over) {
  const scene s = scene::of(each);
  const finding f = of.solve(s, {.tolerance = s.tolerance});
  if (!f.wrong.empty())
    return f.wrong;
  if (!f.ended())
    return fmt::format("{}: {}", ricochet::name_of(f.ending), f.reason);
  if (!f.certain)
    return "";
  if (each.at("ending") != ricochet::name_of(f.ending))
    return fmt::format("{} in place of {}", ricochet::name_of(f.ending), each.at("ending"));
  const auto compare = [&](const char* value, double known_to) {
    if (!each.at(value).empty())
      over = std::max(over, over_estimate(f, std::abs(e_of(f) - std::stod(each.at(value))) - known_to));
  };
  compare("finer_restitution", each.at("finer_estimate").empty() ? 0 : std::stod(each.at("finer_estimate")));
  compare("reference_restitution", 0);
  if (!(over <= std::stod(each.at("allowed_error"))))
    return fmt::format("error is {:.3g} times the estimate of {:.3g}", over, f.error_estimate);
  if (const double most = std::stod(each.at("allowed_evaluations")); double(f.evaluations) > most)
    return fmt::format("{} evaluations, allowed are {}", f.evaluations, most);
  return "";
}

} // namespace

void write_adversaries(const std::vector<adversary>& all, const std::string& file, const std::string& command) {
  std::ofstream out(file + ".part");
  out << fmt::format(
      "# ricochet {}\n# command: {}\n"
      "# Scenes that are hard on an instance: of all that were tried, those with the largest error over its estimate,\n"
      "# the most evaluations (below 1e6) and the largest residual of the ledger over the tolerance (column aim; "
      "value).\n"
      "# finer_: at a hundredth of the tolerance; reference_restitution: fehlberg78 in long double at 1e-17; blank if "
      "none.\n"
      "# allowed_error: over the estimate; allowed_evaluations: twice those found, and 1000.\n# units:",
      ricochet::version, command);
  const auto names = scene::names(), units = scene::units();
  for (std::size_t i = 0; i < names.size(); ++i)
    out << fmt::format(" {} [{}]", names[i], units[i]);
  out << "; all others [1]\n"
         "instance,aim,value,ending,restitution,error_estimate,finer_restitution,finer_estimate,"
         "reference_restitution,ledger_residual,evaluations,allowed_error,allowed_evaluations";
  for (const std::string& name : names)
    out << ',' << name;
  out << '\n';
  for (const adversary& each : all) {
    const bool finer = each.finer.ended() && each.finer.certain;
    double over = finer ? over_estimate(each.found, difference(each.found, each.finer) - each.finer.error_estimate) : 0;
    if (each.reference)
      over = std::max(over, over_estimate(each.found, std::abs(e_of(each.found) - *each.reference)));
    out << fmt::format("{},{},{:.3g},{},{},{:.3g},{},{},{},{:.3g},{},{},{}", each.instance,
                       aim_names[std::size_t(each.of)], each.value, ricochet::name_of(each.found.ending),
                       shown(e_of(each.found)), each.found.error_estimate, finer ? shown(e_of(each.finer)) : "",
                       finer ? shown(each.finer.error_estimate) : "", each.reference ? shown(*each.reference) : "",
                       each.found.ledger_residual, each.found.evaluations,
                       over > 1 ? fmt::format("{:.3g}", 1.1 * over) : "1", 2 * each.found.evaluations + 1000);
    for (const std::string& value : each.numbers.values())
      out << ',' << value;
    out << '\n';
  }
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + file);
  std::filesystem::rename(file + ".part", file);
}

bool check_adversaries(const std::string& file, const std::vector<instance>& instances) {
  long rows = 0, wrong = 0, known = 0;
  double largest = 0;
  for (const row& each : support::rows_of(file)) {
    const auto of = std::find_if(instances.begin(), instances.end(),
                                 [&](const instance& i) { return i.name == each.at("instance"); });
    if (of == instances.end())
      continue;
    double over = 0;
    const std::string found = wrong_with(each, *of, over);
    known += over > 1;
    largest = std::max(largest, over);
    ++rows;
    if (!found.empty()) {
      ++wrong;
      fmt::print("row {}, {}: {}\n", rows, of->name, found);
    }
  }
  fmt::print("{} scenes of {}: {} wrong; largest error over estimate {:.3g}, of {} known to be above it\n", rows, file,
             wrong, largest, known);
  return rows > 0 && wrong == 0;
}

} // namespace campaign
