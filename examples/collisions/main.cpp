// collisions: a CSV table of collisions in, the same with their outcomes out. See --help.
#include "arguments.hpp"
#include "csv_reader.hpp"
#include "input_columns.hpp"
#include "messages.hpp"
#include "output_file.hpp"
#include "output_table.hpp"
#include "scene_reader.hpp"

#include <ricochet/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <unistd.h>

namespace {

using namespace collisions;

std::ifstream opened(const std::string& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw file_error(path + " is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw file_error(fmt::format("{} cannot be read: {}", path, std::strerror(errno)));
  return file;
}

header read_header(csv_reader& input, const std::string& name) {
  csv_record record;
  if (!input.next(record))
    throw file_error(name + " is empty: its first line should name the columns (see --help)");
  if (!record.error.empty())
    throw file_error(fmt::format("{}, line {}: {}", name, record.line, record.error));
  if (std::any_of(record.cells.begin(), record.cells.end(),
                  [](const std::string& column) { return trimmed(column) == "model"; }))
    return header(record);
  const bool other_separator = record.cells.size() == 1 && record.cells[0].find_first_of(";\t") != std::string::npos;
  throw file_error(fmt::format("{}, line {}: there is no column \"model\" in the header {}{}", name, record.line,
                               quoted(fmt::format("{}", fmt::join(record.cells, ","))),
                               other_separator ? "; cells are to be separated by commas" : " (see --help)"));
}

/// One row's outcome; nothing where the row is bad, which is said.
std::optional<outcome> solve_row(const header& columns, const csv_record& record, const arguments& given,
                                 scene_reader& scenes, messages& messages) {
  const auto bad = [&](const std::string& place, const char* reason) {
    messages.say(fmt::format("line {}{}{}: {}", record.line, place.empty() ? "" : ", ", place, reason));
    return std::nullopt;
  };
  try {
    return given.stepper.solve(scenes.read(row(columns, record)), given.tolerance);
  } catch (const row_error& error) {
    return bad(error.place, error.what());
  } catch (const ricochet::bad_input& refused) { // quantities that are impossible only together
    return bad("", refused.what());
  }
}

bool is_resolved(const outcome& out) {
  return out.ending == ricochet::ending::separated || out.ending == ricochet::ending::captured;
}

/// True if every row was computed. \throws file_error
bool run(const arguments& given) {
  std::ifstream file;
  if (!given.input.empty())
    file = opened(given.input);
  else if (isatty(STDIN_FILENO) == 1)
    std::fputs("collisions: reading the table from the terminal; --help tells how it is to look\n", stderr);
  const std::string name = given.input.empty() ? "standard input" : given.input;
  csv_reader input(given.input.empty() ? std::cin : file);
  const std::vector<std::string> comments = input.comments();
  const header columns = read_header(input, name);

  output_file output(given.output);
  messages messages(output.is_terminal());
  output.write(fmt::format("# ricochet {} collisions\n# command: {}\n", ricochet::version, given.command));
  output.write(units_line());
  for (const std::string& comment : comments)
    output.write(comment + '\n');
  output.write(header_line(columns));

  for (const std::string& note : notes_on_misspelt(columns))
    messages.say(note);

  scene_reader scenes;
  bool all_went_well = true;
  long warned = 0;
  for (csv_record record; input.next(record); messages.row_done()) {
    const std::optional<outcome> result = solve_row(columns, record, given, scenes, messages);
    if (result && !is_resolved(*result))
      messages.say(fmt::format("line {}: {}: {}", record.line, ricochet::name_of(result->ending), result->reason));
    else if (result && !result->ending_is_certain)
      messages.say(fmt::format("line {}: note: so near the threshold of sticking that {} is not certain", record.line,
                               ricochet::name_of(result->ending)));
    warned += result && is_resolved(*result) && !result->warnings.empty();
    all_went_well = all_went_well && result && is_resolved(*result);
    output.write(row_line(columns, record, result ? &*result : nullptr));
  }
  if (warned > 0)
    messages.say(fmt::format("note: {} of the rows {} laws outside their range; see the column warnings", warned,
                             warned == 1 ? "uses" : "use"));
  output.finish();
  return all_went_well;
}

} // namespace

int main(int argc, char** argv) {
  int status = 0;
  const auto given = read_arguments(argc, argv, status);
  if (!given)
    return status;
  try {
    std::ios::sync_with_stdio(false);
    return run(*given) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "collisions: %s\n", error.what());
    return 2;
  }
}
