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
  std::optional<family> collisions;
  try {
    collisions.emplace(ricochet::read_measurements(std::filesystem::path(given->data)), *given);
  } catch (const std::exception& refused) {
    say(refused.what());
    return 2;
  }
  for (const std::string& note : collisions->notes())
    say("note: " + note);
  try {
    auto found = ricochet::fit_curve(
        {[&](const std::vector<double>& p, double tolerance) { return collisions->restitutions(p, tolerance); }},
        collisions->measured().data, given->free, given->options);
    if (const std::string sentence = collisions->out_of_range(values_of(found)); !sentence.empty())
      found.warnings.push_back(sentence);
    print(*given, collisions->measured(), found);
    if (!given->output.empty())
      for (const std::string& file : write(*given, *collisions, found))
        fmt::print("written: {}\n", file);
  } catch (const ricochet::bad_input& refused) {
    say(refused.what());
    return 1;
  } catch (const std::exception& error) {
    say(error.what());
    return 2;
  }
}
