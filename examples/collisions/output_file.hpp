// Standard output, or a file that appears under its name only when it is whole. Until then its rows are in NAME.part,
// which an interrupted run leaves for the next to go on from.
#pragma once
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace collisions {

class output_file {
public:
  /// Standard output where `path` is empty. \throws file_error if the file cannot be made, or another run writes it.
  explicit output_file(const std::string& path);
  ~output_file();
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;

  /// Path of the rows not yet in place, those of an interrupted run among them; empty where the output goes elsewhere.
  const std::string& part() const { return part_; }

  /// Keeps so many bytes of part() and drops what is behind them: before the first write(). \throws file_error
  void keep(std::uintmax_t bytes);

  /// \throws file_error if it cannot be written.
  void write(std::string_view text);

  /// Everything is written: gives the file its name. \throws file_error
  void finish();

  bool is_terminal() const;

private:
  void open_part();
  [[noreturn]] void fail(const std::string& path, const char* what) const;

  using clock = std::chrono::steady_clock;
  std::string path_, part_; ///< part_ is empty where the file is written in place
  std::FILE* file_ = stdout;
  clock::time_point due_ = clock::now(); ///< when to hand to the system what has been written
};

} // namespace collisions
