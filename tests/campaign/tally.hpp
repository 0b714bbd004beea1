// Counts what came of the scenes, and keeps what is worth a look.
#pragma once
#include "finding.hpp"
#include "instance.hpp"

#include <array>
#include <cstdint>
#include <map>

namespace campaign {

enum class verdict {
  certified,  ///< separated or captured, certainly, with the error below the tolerance
  near,       ///< so near a threshold that the ending is not certain, and it says so
  unmet,      ///< the estimate is above the tolerance, and it says so
  unresolved, ///< with its reason
  failed,     ///< with its reason
  refused,    ///< as bad input
  wrong       ///< a property does not hold, or bad input went through
};
inline constexpr std::array verdict_names{"certified", "near threshold", "tolerance not met", "unresolved", "failed",
                                          "refused",   "wrong"};

struct record {
  std::uint64_t index = ~std::uint64_t(0); ///< of the scene
  double value = 0;
};

/// Of one instance in one range; sums and extremes do not depend on the order in which scenes are added.
struct tally {
  std::array<long, verdict_names.size()> count{};
  std::map<std::string, std::pair<long, std::uint64_t>> reasons; ///< how often, and the first scene
  record most_evaluations, largest_residual, largest_error;      ///< error: over the estimate
  long evaluations = 0, compared = 0;

  void add(std::uint64_t index, verdict is, const finding& found);
  void merge(const tally& other);
  long total() const;
};

void keep_larger(record& largest, const record& other);

} // namespace campaign
