// What maps are made of: collisions resolved wherever they may lie, and polynomials through them.
#pragma once
#include <ricochet/batch/batch.hpp>
#include <ricochet/study/map/map_file.hpp>
#include <ricochet/study/sensitivity.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <Eigen/LU>

namespace ricochet::detail {

/// The constants of a pair and the parameters of its laws, in SI.
template <class Model>
std::string described(const Model& model, std::string about) {
  for_each_quantity(model, [&](const char* name, const auto& quantity) {
    const std::string unit = unit_symbol(quantity);
    about += (about.empty() ? "" : ", ") + std::string(name) + " = " + exact(in_si(quantity)) +
             (unit.empty() ? "" : " " + unit);
  });
  return about;
}

/// Outcomes of scenes to a tolerance.
/// \throws bad_input if one cannot be resolved
template <class Model>
std::vector<outcome_of<Model>> resolved(const std::vector<scene<Model>>& scenes, double tolerance, unsigned threads) {
  auto outcomes =
      ricochet::collide(scenes, {.tolerance = std::max(tolerance, tolerance_range.low), .threads = threads});
  for (std::size_t i = 0; i < scenes.size(); ++i)
    if (outcomes[i].ending != ending::separated && outcomes[i].ending != ending::captured)
      throw bad_input("map: the collision at " + shown(in_si(scenes[i].impact.speed)) + " m/s ended " +
                      name_of(outcomes[i].ending) + ": " + outcomes[i].reason);
  return outcomes;
}

/// sticking_speed(), less close where it meets a fast edge that lets go of bodies at rest, up to the last digits of the
/// speed: such a collision fails. \throws bad_input if that does not help
template <class Model>
sticking_threshold sticking_speed_up_to(const Model& model, speed low, speed high, double width) {
  for (const double least = width;; width *= 10)
    try {
      return sticking_speed(model, low, high, width);
    } catch (const bad_input&) {
      if (width > 50 * least)
        throw;
    }
}

/// Polynomials of t from -1 to 1 through values at Chebyshev's nodes.
template <std::size_t Terms>
struct interpolation {
  using matrix = Eigen::Matrix<double, Terms, Terms>;
  std::array<double, Terms> node;
  matrix to_powers;

  interpolation() {
    matrix powers;
    for (std::size_t i = 0; i < Terms; ++i) {
      node[i] = -std::cos(pi<double>() * (double(i) + 0.5) / Terms);
      for (std::size_t j = 0; j < Terms; ++j)
        powers(Eigen::Index(i), Eigen::Index(j)) = std::pow(node[i], double(j));
    }
    to_powers = powers.inverse();
  }
};

} // namespace ricochet::detail
