// What goes to standard error: problems, and progress where a person is watching.
#pragma once
#include <chrono>
#include <string>

namespace collisions {

class messages {
public:
  /// Progress is shown only on a terminal, and only if the output does not go there too.
  explicit messages(bool output_is_terminal);
  ~messages();
  messages(const messages&) = delete;
  messages& operator=(const messages&) = delete;

  /// One line, after the program's name.
  void say(const std::string& sentence);

  /// Shows how many rows are done, at most four times a second.
  void row_done();

private:
  void clear();

  using clock = std::chrono::steady_clock;
  bool shows_progress_;
  bool line_is_shown_ = false;
  long rows_ = 0;
  clock::time_point due_;
};

} // namespace collisions
