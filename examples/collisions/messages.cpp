#include "messages.hpp"

#include <cstdio>

#include <unistd.h>

namespace collisions {

using namespace std::chrono_literals;

messages::messages(bool output_is_terminal)
    : shows_progress_(!output_is_terminal && isatty(STDERR_FILENO) == 1), due_(clock::now() + 1s) {}

messages::~messages() { clear(); }

void messages::say(const std::string& sentence) {
  clear();
  std::fputs(("collisions: " + sentence + '\n').c_str(), stderr);
}

void messages::row_done() {
  ++rows_;
  if (!shows_progress_ || clock::now() < due_)
    return;
  due_ = clock::now() + 250ms;
  line_is_shown_ = true;
  std::fprintf(stderr, "\rcollisions: %ld rows done", rows_);
}

void messages::clear() {
  if (line_is_shown_)
    std::fprintf(stderr, "\r%60s\r", "");
  line_is_shown_ = false;
}

} // namespace collisions
