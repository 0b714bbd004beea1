#include "family.hpp"
#include "input_columns.hpp"
#include "restitutions.hpp"

#include <fmt/format.h>

namespace fit_restitution {

namespace {

const std::string measured = "restitution", error = "error", speed = "speed";

std::string text_of(double x) { return fmt::format("{}", x); } // as many digits as it takes

} // namespace

family::family(const ricochet::measured_curve& data, std::string data_name, columns scene,
               const std::vector<ricochet::free_parameter>& free, std::vector<tie> ties, unsigned threads)
    : data_(data), data_name_(std::move(data_name)), scene_(std::move(scene)), free_(free), ties_(std::move(ties)),
      threads_(threads) {
  std::map<std::string, std::string> from; // who sets a column
  const auto sets = [&](const std::string& column, const std::string& who) {
    if (!collisions::unit_of(column))
      throw ricochet::bad_input(
          fmt::format("{}: there is no column {}; collisions --help lists those there are", who, column));
    if (const auto [before, is_new] = from.emplace(column, who); !is_new)
      throw ricochet::bad_input(fmt::format("{} is set by {} and by {}", column, before->second, who));
  };
  for (const std::string& column : data_.columns)
    if (collisions::unit_of(column))
      sets(column, data_name_);
  for (const auto& [column, cell] : scene_)
    sets(column, "--scene or --set");
  for (const auto& each : free_) {
    sets(each.name, "--free");
    if (collisions::unit_of(each.name)->empty() || each.name == speed)
      throw ricochet::bad_input("--free: " + each.name + " is no parameter");
  }
  for (const tie& each : ties_) {
    sets(each.column, "--tie");
    if (std::none_of(free_.begin(), free_.end(), [&](const auto& parameter) { return parameter.name == each.of; }))
      throw ricochet::bad_input(fmt::format("--tie: {} is tied to {}, which is not free", each.column, each.of));
  }
}

columns family::columns_of(std::size_t measurement, const std::vector<double>& parameters) const {
  columns all = scene_;
  for (std::size_t i = 0; i < data_.columns.size(); ++i)
    if (data_.columns[i] != measured && data_.columns[i] != error)
      all[data_.columns[i]] = data_.cells[measurement][i];
  for (std::size_t k = 0; k < free_.size(); ++k)
    all[free_[k].name] = text_of(parameters[k]);
  for (const auto& [column, value] : tied(parameters))
    all[column] = text_of(value);
  return all;
}

std::vector<std::pair<std::string, double>> family::tied(const std::vector<double>& parameters) const {
  std::vector<std::pair<std::string, double>> values;
  for (const tie& each : ties_)
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (free_[k].name == each.of)
        values.emplace_back(each.column, each.factor * parameters[k]);
  return values;
}

collisions::scene family::scene_of(const columns& all, std::size_t measurement) const {
  collisions::csv_record names, cells;
  for (const auto& [name, cell] : all) {
    names.cells.push_back(name);
    cells.cells.push_back(cell);
  }
  try {
    const collisions::header header(names);
    return reader_.read(collisions::row(header, cells));
  } catch (const collisions::row_error& refused) {
    throw ricochet::bad_input(fmt::format("the collision of {}, line {}{}{}: {}", data_name_, data_.lines[measurement],
                                          refused.place.empty() ? "" : ", ", refused.place, refused.what()));
  }
}

std::vector<double> family::restitutions(const std::vector<double>& parameters, double tolerance) const {
  std::vector<collisions::scene> scenes;
  for (std::size_t i = 0; i < data_.data.size(); ++i)
    scenes.push_back(scene_of(columns_of(i, parameters), i));
  return fit_restitution::restitutions(scenes, tolerance, threads_);
}

std::vector<double> family::restitutions(const std::vector<double>& parameters, double tolerance,
                                         const std::vector<double>& speeds) const {
  std::vector<collisions::scene> scenes;
  columns all = columns_of(0, parameters);
  for (const double v : speeds) {
    all[speed] = text_of(v);
    scenes.push_back(scene_of(all, 0));
  }
  return fit_restitution::restitutions(scenes, tolerance, threads_);
}

} // namespace fit_restitution
