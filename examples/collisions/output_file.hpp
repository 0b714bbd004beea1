// Standard output, or a file that appears under its name only when it is whole.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace collisions {

class output_file {
public:
  /// Standard output where `path` is empty. \throws file_error if the file cannot be made.
  explicit output_file(const std::string& path);
  ~output_file();
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;

  /// \throws file_error if it cannot be written.
  void write(std::string_view text);

  /// Everything is written: gives the file its name. \throws file_error
  void finish();

  bool is_terminal() const;

private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_, temporary_; ///< temporary_ is empty where the file is written in place
  std::FILE* file_ = stdout;
};

} // namespace collisions
