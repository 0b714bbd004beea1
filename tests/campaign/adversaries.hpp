// The scenes that are hardest on each instance: found by search, kept in a file, and solved again as a test.
#pragma once
#include "instance.hpp"

#include <optional>
#include <string>
#include <vector>

namespace campaign {

/// What a scene is hard on; each is searched for by itself.
enum class aim {
  error, ///< over its estimate
  evaluations,
  residual ///< of the ledger, over the tolerance
};
inline constexpr const char* aim_names[] = {"error", "evaluations", "residual"};

struct adversary {
  std::string instance;
  aim of;
  scene numbers;
  finding found, finer;            ///< at the scene's tolerance and at a hundredth of it
  double value = 0;                ///< of what was aimed at
  std::optional<double> reference; ///< restitution in long double, where there is one
};

/// The hundred worst of so many trials of each instance in the documented range: one half drawn at random, the rest
/// near the worst so far. Of the same seed the same, on however many threads; progress on standard error.
std::vector<adversary> search_adversaries(const std::vector<instance>& instances, std::uint64_t seed, long trials,
                                          unsigned threads);
/// \throws std::runtime_error if the file cannot be written.
void write_adversaries(const std::vector<adversary>& all, const std::string& file, const std::string& command);
/// Solves each again; prints what is not as it should be, and is true if all is.
bool check_adversaries(const std::string& file, const std::vector<instance>& instances);

} // namespace campaign
