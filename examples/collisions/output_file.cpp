#include "output_file.hpp"
#include "errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace collisions {

namespace {

char farewell[8192] = ""; ///< what to say when interrupted, for the signal handler

extern "C" void say_and_die(int signal) {
  [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, farewell, std::strlen(farewell));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::string way_on(const std::string& part) {
  return fmt::format("the rows done are kept in {}, and the same command goes on from there", part);
}

void say_when_interrupted(const std::string& sentence) {
  if (sentence.size() >= sizeof farewell)
    return;
  std::memcpy(farewell, sentence.c_str(), sentence.size() + 1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, say_and_die) == SIG_IGN) // as under nohup
      std::signal(signal, SIG_IGN);
}

/// Whether the open file still has this name: a run that ended in between has given it another.
bool is_called(int descriptor, const std::string& path) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
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
  if (!fs::exists(status) || fs::is_regular_file(status)) {
    open_part();
  } else if (file_ = std::fopen(path_.c_str(), "w"); !file_) { // a device or a pipe is not to be replaced by a file
    fail(path_, "made");
  }
}

void output_file::open_part() {
  part_ = path_ + ".part";
  int descriptor = -1;
  do {
    if (descriptor >= 0)
      close(descriptor);
    descriptor = open(part_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0)
      fail(part_, "made");
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(descriptor);
      throw file_error(fmt::format("{} is being written by another run: let it end, or name another output", path_));
    }
  } while (!is_called(descriptor, part_));
  file_ = fdopen(descriptor, "w");
  if (!file_)
    fail(part_, "made");
  say_when_interrupted(fmt::format("\ncollisions: interrupted; {}\n", way_on(part_)));
}

output_file::~output_file() {
  if (!file_ || file_ == stdout)
    return;
  std::fclose(file_);
  std::error_code ignored;
  if (!part_.empty() && std::filesystem::file_size(part_, ignored) == 0)
    unlink(part_.c_str());
}

void output_file::keep(std::uintmax_t bytes) {
  if (part_.empty())
    return;
  const auto size = static_cast<off_t>(bytes);
  if (ftruncate(fileno(file_), size) != 0 || fseeko(file_, size, SEEK_SET) != 0)
    fail(part_, "written");
}

void output_file::write(std::string_view text) {
  const auto now = clock::now();
  const bool flush = now >= due_; // so that a run that is killed loses no more than what takes a second
  if (flush)
    due_ = now + std::chrono::seconds(1);
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || (flush && std::fflush(file_) != 0))
    fail(path_, "written");
}

void output_file::finish() {
  if (std::fflush(file_) != 0)
    fail(path_, "written");
  if (file_ == stdout)
    return;
  if (!part_.empty() && fsync(fileno(file_)) != 0)
    fail(path_, "written");
  if (!part_.empty() && std::rename(part_.c_str(), path_.c_str()) != 0) // while the lock is held
    fail(path_, "given its name");
  part_.clear();
  farewell[0] = '\0';
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
    fail(path_, "written");
}

bool output_file::is_terminal() const { return file_ && isatty(fileno(file_)) == 1; }

void output_file::fail(const std::string& path, const char* what) const {
  const std::string reason = std::strerror(errno);
  std::error_code ignored;
  const bool kept = !part_.empty() && std::filesystem::exists(part_, ignored);
  throw file_error(fmt::format("{} cannot be {}: {}{}", path.empty() ? "standard output" : path, what, reason,
                               kept ? "; " + way_on(part_) : ""));
}

} // namespace collisions
