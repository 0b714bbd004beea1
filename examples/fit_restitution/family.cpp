#include "family.hpp"
#include "input_columns.hpp"
#include "restitutions.hpp"
#include "solve.hpp"

#include <fmt/format.h>

namespace fit_restitution {

namespace {

const std::string speed = "speed";

bool is_measured(const std::string& column) { return column == "restitution" || column == "error"; }

std::string text_of(double x) { return fmt::format("{}", x); } // as many digits as it takes

} // namespace

family::family(ricochet::measured_curve data, const arguments& given) : data_(std::move(data)), given_(given) {
  std::map<std::string, std::string> from; // who sets a column
  const auto sets = [&](const std::string& column, const std::string& who) {
    if (!collisions::unit_of(column))
      throw ricochet::bad_input(fmt::format("{}: there is no column {}{}; collisions --help lists those there are", who,
                                            column, collisions::hint_for(column)));
    if (const auto [before, is_new] = from.emplace(column, who); !is_new)
      throw ricochet::bad_input(fmt::format("{} is set by {} and by {}", column, before->second, who));
  };
  for (const std::string& column : data_.columns)
    if (collisions::unit_of(column))
      sets(column, given_.data);
  for (const auto& [column, cell] : given_.scene)
    sets(column, "--scene or --set");
  for (const auto& each : given_.free) {
    sets(each.name, "--free");
    if (collisions::unit_of(each.name)->empty() || each.name == speed)
      throw ricochet::bad_input("--free: " + each.name + " is no parameter");
  }
  for (const tie& each : given_.ties) {
    sets(each.column, "--tie");
    if (std::none_of(given_.free.begin(), given_.free.end(), [&](const auto& free) { return free.name == each.of; }))
      throw ricochet::bad_input(fmt::format("--tie: {} is tied to {}, which is not free", each.column, each.of));
  }
  std::vector<double> middle;
  for (const auto& [name, low, high] : given_.free)
    middle.push_back(low > 0 ? low * std::sqrt(high / low) : low + (high - low) / 2);
  std::map<std::string, std::size_t> unread;
  for (std::size_t i = 0; i < data_.data.size(); ++i)
    (void)scene_of(columns_of(i, middle), i, &unread);
  for (const auto& [column, rows] : unread) {
    if (rows < data_.data.size())
      continue;
    const std::string& who = from.at(column);
    if (who == "--free" || who == "--tie" ||
        std::find(given_.set.begin(), given_.set.end(), column) != given_.set.end())
      throw ricochet::bad_input(fmt::format("{} is given, but no law of the model takes it: {}", column,
                                            given_.scene.contains("model") ? given_.scene.at("model") : given_.data));
    notes_.push_back(fmt::format("{} in {} changes nothing: no law of the model takes it", column,
                                 who == given_.data ? who : "the scene"));
  }
  for (const std::string& column : data_.columns)
    if (!collisions::unit_of(column) && !is_measured(column))
      notes_.push_back(fmt::format("not used of {}: {}{}; --help says which columns are", given_.data, column,
                                   collisions::hint_for(column)));
}

bool family::alike() const {
  for (std::size_t i = 0; i < data_.columns.size(); ++i)
    if (collisions::unit_of(data_.columns[i]) && data_.columns[i] != speed)
      for (const auto& row : data_.cells)
        if (row[i] != data_.cells[0][i])
          return false;
  return true;
}

columns family::columns_of(std::size_t measurement, const std::vector<double>& parameters) const {
  columns all = given_.scene;
  for (std::size_t i = 0; i < data_.columns.size(); ++i)
    if (!is_measured(data_.columns[i]))
      all[data_.columns[i]] = data_.cells[measurement][i];
  for (std::size_t k = 0; k < given_.free.size(); ++k)
    all[given_.free[k].name] = text_of(parameters[k]);
  for (const auto& [column, value] : tied(parameters))
    all[column] = text_of(value);
  return all;
}

std::vector<std::pair<std::string, double>> family::tied(const std::vector<double>& parameters) const {
  std::vector<std::pair<std::string, double>> values;
  for (const tie& each : given_.ties)
    for (std::size_t k = 0; k < given_.free.size(); ++k)
      if (given_.free[k].name == each.of)
        values.emplace_back(each.column, each.factor * parameters[k]);
  return values;
}

collisions::scene family::scene_of(const columns& all, std::size_t measurement,
                                   std::map<std::string, std::size_t>* unread) const {
  collisions::csv_record names, cells;
  for (const auto& [name, cell] : all) {
    names.cells.push_back(name);
    cells.cells.push_back(cell);
  }
  try {
    const collisions::header header(names);
    const collisions::row row(header, cells);
    const collisions::scene scene = reader_.read(row);
    if (unread)
      for (const std::string& column : row.unread())
        ++(*unread)[column];
    return scene;
  } catch (const collisions::missing_column& missing) {
    throw ricochet::bad_input(
        fmt::format("{}: {}; give it with --set or --scene, or in {}", missing.place, missing.what(), given_.data));
  } catch (const collisions::row_error& refused) {
    throw ricochet::bad_input(fmt::format("the collision of {}, line {}{}{}: {}", given_.data, data_.lines[measurement],
                                          refused.place.empty() ? "" : ", ", refused.place, refused.what()));
  }
}

std::vector<double> family::restitutions(const std::vector<double>& parameters, double tolerance) const {
  std::vector<collisions::scene> scenes;
  for (std::size_t i = 0; i < data_.data.size(); ++i)
    scenes.push_back(scene_of(columns_of(i, parameters), i));
  return fit_restitution::restitutions(scenes, tolerance, given_.options.threads);
}

std::string family::out_of_range(const std::vector<double>& parameters) const {
  std::string first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < data_.data.size(); ++i) {
    const auto warnings = collisions::solve_automatic(scene_of(columns_of(i, parameters), i), 1e-3).warnings;
    if (!warnings.empty() && count++ == 0)
      first = fmt::format("that of line {}: {}", data_.lines[i], fmt::join(warnings, "; "));
  }
  return count == 0 ? ""
                    : fmt::format("{} of the {} collisions take laws outside their range, first {}", count,
                                  data_.data.size(), first);
}

std::vector<double> family::restitutions(const std::vector<double>& parameters, double tolerance,
                                         const std::vector<double>& speeds) const {
  std::vector<collisions::scene> scenes;
  columns all = columns_of(0, parameters);
  for (const double v : speeds) {
    all[speed] = text_of(v);
    scenes.push_back(scene_of(all, 0));
  }
  return fit_restitution::restitutions(scenes, tolerance, given_.options.threads);
}

} // namespace fit_restitution
