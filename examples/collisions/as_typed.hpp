// The command line as text.
#pragma once
#include <string>

namespace collisions {

/// An argument as a shell would need it, on one line.
inline std::string as_typed(const std::string& argument) {
  const bool plain =
      !argument.empty() && argument.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                      "0123456789_-+=./:,@%") == std::string::npos;
  std::string out;
  for (const char c : argument)
    out += c == '\'' ? "'\\''" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return plain ? out : '\'' + out + '\'';
}

/// A program's command on one line.
inline std::string command_as_typed(std::string program, int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i)
    program += ' ' + as_typed(argv[i]);
  return program;
}

} // namespace collisions
