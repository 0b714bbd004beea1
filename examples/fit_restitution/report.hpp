// What was found, for people, programs and the eye.
#pragma once
#include "family.hpp"

#include <ricochet/study/fit/least_squares.hpp>

namespace fit_restitution {

std::vector<double> values_of(const ricochet::fit_result& found);

/// To standard output.
void print(const arguments& given, const ricochet::measured_curve& data, const ricochet::fit_result& found);

/// PREFIX.json, _points.csv, _curve.csv and .gp, and what gnuplot makes of the last. Names of the files written.
/// \throws std::runtime_error if one cannot be written
std::vector<std::string> write(const arguments& given, const family& family, const ricochet::fit_result& found);

} // namespace fit_restitution
