// What both harnesses offer, to libFuzzer and to replay.cpp alike; and how they say what must not be.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace fuzz {

/// Ends the program, so that the fuzzer keeps the input.
inline void demand(bool holds, const std::string& what) {
  if (holds)
    return;
  std::fprintf(stderr, "not so: %s\n", what.c_str());
  std::abort();
}

/// A message is one line that says something.
inline void demand_sentence(const std::string& message) {
  demand(!message.empty() && message.size() < 1000 && message.find_first_of("\r\n") == std::string::npos,
         "a message is one line: \"" + message + '"');
}

} // namespace fuzz
