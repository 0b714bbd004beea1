// The command line.
#pragma once
#include "family.hpp"

#include <filesystem>
#include <optional>

namespace fit_restitution {

struct arguments {
  std::string data;  ///< file of measurements
  columns scene;     ///< all other columns that are given
  std::vector<ricochet::free_parameter> free;
  std::vector<tie> ties;
  std::filesystem::path output; ///< beginning of the names of all files written
  ricochet::fit_options options;
  std::string command; ///< as it was typed
};

/// Nothing where the program has to end, with what in `status`; the reason has then been said.
std::optional<arguments> read_arguments(int argc, const char* const* argv, int& status);

} // namespace fit_restitution
