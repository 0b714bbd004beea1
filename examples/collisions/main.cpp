// collisions: a CSV table of collisions in, the same with their outcomes out. See --help.
#include "arguments.hpp"
#include "csv_reader.hpp"
#include "input_columns.hpp"
#include "kept_rows.hpp"
#include "messages.hpp"
#include "output_file.hpp"
#include "output_table.hpp"
#include "row_solver.hpp"

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

std::string head_of_output(const arguments& given, const std::vector<std::string>& comments, const header& columns) {
  std::string head = fmt::format("# ricochet {} collisions\n# command: {}\n", ricochet::version, given.command);
  head += units_line();
  for (const std::string& comment : comments)
    head += comment + '\n';
  return head + header_line(columns);
}

/// Takes what an interrupted run has left of this input; then `record` is the first row that is to be solved, if there
/// is one, which is returned. \throws file_error if it is of another input.
bool skip_kept_rows(kept_rows& kept, csv_reader& input, csv_record& record, row_solver& solver) {
  bool there_is_one = input.next(record);
  for (; there_is_one && kept.more(); there_is_one = input.next(record))
    solver.count(kept.take(record));
  if (kept.more())
    kept.refuse_the_rest();
  return there_is_one;
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
  input.expect(columns.cells().size());

  output_file output(given.output);
  messages messages(output.is_terminal());
  for (const std::string& note : notes_on_misspelt(columns))
    messages.say(note);

  const std::string head = head_of_output(given, comments, columns);
  kept_rows kept(output.part(), head, columns);
  row_solver solver(columns, given, messages);
  csv_record record;
  bool there_is_one = skip_kept_rows(kept, input, record, solver);
  output.keep(kept.size());
  if (kept.size() == 0)
    output.write(head);
  if (solver.rows() > 0)
    messages.say(fmt::format(
        "going on after {} rows kept in {}{}", solver.rows(), output.part(),
        solver.unresolved() > 0 ? fmt::format(", {} of them failed or unresolved", solver.unresolved()) : ""));
  for (; there_is_one; there_is_one = input.next(record))
    output.write(solver.line_of(record));
  solver.say_at_the_end();
  output.finish();
  return solver.unresolved() == 0;
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
