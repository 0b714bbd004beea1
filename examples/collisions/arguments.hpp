// The command line.
#pragma once
#include "solve.hpp"

#include <optional>
#include <string>

namespace collisions {

struct arguments {
  std::string input;  ///< empty: standard input
  std::string output; ///< empty: standard output
  double tolerance = 1e-10;
  stepper_choice stepper = steppers[0];
  std::string command; ///< the whole command line, for the output's head
};

/// Nothing where the program is to end now with the status given: after --help, or after wrong use, which it has said.
std::optional<arguments> read_arguments(int argc, const char* const* argv, int& status);

} // namespace collisions
