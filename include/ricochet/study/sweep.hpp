#pragma once
#include <ricochet/solve/collide.hpp>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ricochet {

/// n speeds from `low` to `high`, both included, in equal ratios. \throws bad_input unless 0 < low < high and n >= 2.
inline std::vector<speed> logarithmic_speeds(speed low, speed high, std::size_t n) {
  require("low speed", low, positive);
  require("high speed", high, range{.low = in_si(low), .low_included = false});
  require("number of speeds", static_cast<double>(n), range{.low = 2});
  std::vector<speed> speeds(n);
  for (std::size_t i = 0; i < n; ++i)
    speeds[i] = low * std::pow(in_si(high) / in_si(low), static_cast<double>(i) / static_cast<double>(n - 1));
  return speeds;
}

/// One collision for each speed, in order. `progress(done, all)` is called after each.
template <class Model>
auto sweep(const Model& model, std::span<const speed> speeds, const collide_options& options = {},
           const std::function<void(std::size_t, std::size_t)>& progress = {}) {
  std::vector<decltype(collide(model, impact{}, options))> outcomes;
  outcomes.reserve(speeds.size());
  for (const speed& v : speeds) {
    outcomes.push_back(collide(model, impact{v}, options));
    if (progress)
      progress(outcomes.size(), speeds.size());
  }
  return outcomes;
}

} // namespace ricochet
