// The collisions that were measured, as a function of the parameters sought.
#pragma once
#include "scene_reader.hpp"

#include <ricochet/study/measured_curve.hpp>

#include <map>

namespace fit_restitution {

/// One column is a multiple of another.
struct tie {
  std::string column;
  double factor;
  std::string of;
};

/// Columns and their cells, as `collisions` takes them.
using columns = std::map<std::string, std::string>;

/// Of each measurement a scene: columns of the data file, then those of the scene, then the free ones and those tied to
/// them.
class family {
public:
  /// \throws ricochet::bad_input if a column is free, tied or given twice, or is none that `collisions` knows
  family(const ricochet::measured_curve& data, std::string data_name, columns scene,
         const std::vector<ricochet::free_parameter>& free, std::vector<tie> ties, unsigned threads);

  /// Of the measured collisions; NaN where one is not resolved. \throws ricochet::bad_input naming the measurement whose
  /// scene cannot be read
  std::vector<double> restitutions(const std::vector<double>& parameters, double tolerance) const;

  /// Of other speeds, in m/s; all else as in the first measurement.
  std::vector<double> restitutions(const std::vector<double>& parameters, double tolerance,
                                   const std::vector<double>& speeds) const;

  /// What the columns tied to free ones come to.
  std::vector<std::pair<std::string, double>> tied(const std::vector<double>& parameters) const;

private:
  columns columns_of(std::size_t measurement, const std::vector<double>& parameters) const;
  collisions::scene scene_of(const columns& all, std::size_t measurement) const;

  const ricochet::measured_curve& data_;
  std::string data_name_;
  columns scene_;
  const std::vector<ricochet::free_parameter>& free_;
  std::vector<tie> ties_;
  unsigned threads_;
  mutable collisions::scene_reader reader_;
};

} // namespace fit_restitution
