#include "output_file.hpp"
#include "errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace collisions {

namespace {

char to_remove[4096] = ""; ///< the temporary file's name while there is one, for the signal handler

extern "C" void remove_and_die(int signal) {
  if (to_remove[0] != '\0')
    unlink(to_remove);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void remove_when_interrupted(const std::string& name) {
  if (name.size() >= sizeof to_remove)
    return;
  std::memcpy(to_remove, name.c_str(), name.size() + 1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_and_die) == SIG_IGN) // as under nohup
      std::signal(signal, SIG_IGN);
}

} // namespace

output_file::output_file(const std::string& path) : path_(path) {
  namespace fs = std::filesystem;
  if (path_.empty())
    return;
  std::error_code ignored;
  if (const fs::path target = fs::canonical(path_, ignored); !target.empty())
    path_ = target.string(); // a symbolic link stays one
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) { // a device or a pipe is not to be replaced by a file
    file_ = std::fopen(path_.c_str(), "w");
  } else {
    temporary_ = fmt::format("{}.{}.part", path_, getpid());
    const int descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    file_ = descriptor < 0 ? nullptr : fdopen(descriptor, "w");
  }
  if (!file_)
    fail("made");
  if (!temporary_.empty())
    remove_when_interrupted(temporary_);
}

output_file::~output_file() {
  if (file_ && file_ != stdout)
    std::fclose(file_);
  if (!temporary_.empty())
    unlink(temporary_.c_str());
}

void output_file::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size())
    fail("written");
}

void output_file::finish() {
  if (std::fflush(file_) != 0)
    fail("written");
  if (file_ == stdout)
    return;
  if (!temporary_.empty() && fsync(fileno(file_)) != 0)
    fail("written");
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
    fail("written");
  if (!temporary_.empty() && std::rename(temporary_.c_str(), path_.c_str()) != 0)
    fail("given its name");
  temporary_.clear();
  to_remove[0] = '\0';
}

bool output_file::is_terminal() const { return file_ && isatty(fileno(file_)) == 1; }

void output_file::fail(const char* what) const {
  throw file_error(
      fmt::format("{} cannot be {}: {}", path_.empty() ? "standard output" : path_, what, std::strerror(errno)));
}

} // namespace collisions
