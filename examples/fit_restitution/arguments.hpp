// The command line.
#pragma once
#include <ricochet/study/fit/measured_curve.hpp>

#include <filesystem>
#include <map>
#include <optional>

namespace fit_restitution {

/// One column is a multiple of another.
struct tie {
  std::string column;
  double factor;
  std::string of;
};

/// Columns and their cells, as `collisions` takes them.
using columns = std::map<std::string, std::string>;

struct arguments {
  std::string data;             ///< file of measurements
  columns scene;                ///< all other columns that are given
  std::vector<std::string> set; ///< those of them that --set gives
  std::vector<ricochet::free_parameter> free;
  std::vector<tie> ties;
  std::filesystem::path output; ///< beginning of the names of all files written
  ricochet::fit_options options;
  std::string command; ///< as it was typed
};

/// Nothing where the program has to end, with what in `status`; the reason has then been said.
std::optional<arguments> read_arguments(int argc, const char* const* argv, int& status);

} // namespace fit_restitution
