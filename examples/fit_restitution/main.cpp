// fit_restitution: parameters of a model from a table of measured restitutions, without C++.
#include "arguments.hpp"
#include "report.hpp"

#include <fmt/format.h>

#include <unistd.h>

using namespace fit_restitution;

int main(int argc, char** argv) {
  int status = 0;
  auto given = read_arguments(argc, argv, status);
  if (!given)
    return status;
  const auto say = [](const std::string& why) { fmt::print(stderr, "fit_restitution: {}\n", why); };
  const bool watched = isatty(STDERR_FILENO);
  given->options.progress = [&](std::size_t done, std::size_t of) {
    if (watched)
      fmt::print(stderr, "\rstep {} of {}{}", done, of, done == of ? "\r                    \r" : "");
  };
  try {
    const auto data = ricochet::read_measurements(std::filesystem::path(given->data));
    const family family(data, given->data, given->scene, given->free, given->ties, given->options.threads);
    const auto found = ricochet::fit_curve(
        {[&](const std::vector<double>& p, double tolerance) { return family.restitutions(p, tolerance); }}, data.data,
        given->free, given->options);
    print(*given, data, found);
    if (!given->output.empty())
      for (const std::string& file : write(*given, data, family, found))
        fmt::print("written: {}\n", file);
  } catch (const ricochet::bad_input& refused) {
    say(refused.what());
    return 1;
  } catch (const std::exception& error) {
    say(error.what());
    return 2;
  }
}
