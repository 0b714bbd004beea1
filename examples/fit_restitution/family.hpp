// The collisions that were measured, as a function of the parameters sought.
#pragma once
#include "arguments.hpp"
#include "scene_reader.hpp"

namespace fit_restitution {

/// Of each measurement a scene: columns of the data file, then those of the scene, then the free ones and those tied to
/// them.
class family {
public:
  /// \throws ricochet::bad_input if a column is free, tied or given twice, or is none that `collisions` knows; naming
  /// the measurement whose scene cannot be read with the parameters in the middle of their ranges
  family(ricochet::measured_curve data, const arguments& given);

  const ricochet::measured_curve& measured() const { return data_; }

  /// Of the measured collisions; NaN where one is not resolved. \throws ricochet::bad_input naming the measurement
  /// whose scene cannot be read
  std::vector<double> restitutions(const std::vector<double>& parameters, double tolerance) const;

  /// Of other speeds, in m/s; all else as in the first measurement.
  std::vector<double> restitutions(const std::vector<double>& parameters, double tolerance,
                                   const std::vector<double>& speeds) const;

  /// Do all columns but those of speed and restitution say the same of all measurements?
  bool alike() const;

  /// Sentences on what is given and not used.
  const std::vector<std::string>& notes() const { return notes_; }

  /// A sentence where collisions with these parameters take a law outside its range; else empty.
  std::string out_of_range(const std::vector<double>& parameters) const;

  /// What the columns tied to free ones come to.
  std::vector<std::pair<std::string, double>> tied(const std::vector<double>& parameters) const;

private:
  columns columns_of(std::size_t measurement, const std::vector<double>& parameters) const;
  /// `unread`: counts the columns that the scene does without.
  collisions::scene scene_of(const columns& all, std::size_t measurement,
                             std::map<std::string, std::size_t>* unread = nullptr) const;

  ricochet::measured_curve data_;
  const arguments& given_;
  mutable collisions::scene_reader reader_;
  std::vector<std::string> notes_;
};

} // namespace fit_restitution
