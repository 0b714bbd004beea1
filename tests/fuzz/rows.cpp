// Whatever bytes are given to `collisions` as its table: every line that is not blank is part of one record, every
// record is a scene or has an error of its own, and what is written of it can be read again.
#include "harness.hpp"

#include "input_columns.hpp"
#include "output_table.hpp"
#include "scene_reader.hpp"

#include <algorithm>
#include <sstream>

namespace {

using namespace collisions;
using fuzz::demand, fuzz::demand_sentence;

/// Of each line of the table whether it is blank, found without the reader.
std::vector<bool> blank_lines(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF"))
    bytes.remove_prefix(3);
  std::vector<bool> blank;
  for (std::size_t begin = 0; begin < bytes.size();) {
    std::size_t end = std::min(bytes.find_first_of("\r\n", begin), bytes.size());
    blank.push_back(bytes.substr(begin, end - begin).find_first_not_of(" \t") == std::string_view::npos);
    begin = end + (bytes.substr(end).starts_with("\r\n") ? 2 : 1);
  }
  return blank;
}

/// Of how many records there is a scene, and of how many an error; libFuzzer sees how far it got by the branches.
struct counts {
  std::size_t scenes = 0, errors = 0;
};

void read_scene(scene_reader& scenes, const header& columns, const csv_record& record, counts& found) {
  try {
    scenes.read(row(columns, record));
    ++found.scenes;
  } catch (const row_error& error) {
    ++found.errors;
    demand_sentence(error.what());
    demand_sentence("x" + error.place);
  } catch (const ricochet::bad_input& refused) {
    ++found.errors;
    demand_sentence(refused.what());
  }
}

/// What the program writes of a record is one row again, which holds what is copied.
void write_and_read(const header& columns, const csv_record& record) {
  const std::string text = header_line(columns) + row_line(columns, record, nullptr);
  std::istringstream in(text);
  csv_reader reader(in);
  csv_record names, again, nothing;
  demand(reader.next(names) && names.error.empty(), "the header that is written can be read");
  reader.expect(names.cells.size());
  demand(reader.next(again) && again.end == text.size(), "the row that is written can be read");
  const auto written = read_written(columns, again);
  demand(written && !written->resolved, "the row that is written is a failed one");
  demand(written->copied == copied_cells(columns, record), "the row that is written has the cells of the input");
  demand(!reader.next(nothing), "nothing is written behind the row");
}

void read_table(const std::string& bytes) {
  static scene_reader scenes; // keeps its tables
  std::istringstream in(bytes);
  csv_reader reader(in);
  reader.comments();
  csv_record record;
  if (!reader.next(record) || !record.error.empty())
    return;
  const header columns(record);
  for (const std::string& note : notes_on_misspelt(columns))
    demand_sentence(note);
  reader.expect(columns.cells().size());

  const std::vector<bool> blank = blank_lines(bytes);
  std::size_t next_line = record.line + record.lines, records = 0;
  const auto demand_blank_up_to = [&](std::size_t line) {
    demand(next_line <= line && line <= blank.size() + 1, "records come in order");
    for (; next_line < line; ++next_line)
      demand(blank[next_line - 1], "no line is lost");
  };
  counts found;
  for (; reader.next(record); ++records) {
    demand_blank_up_to(record.line);
    next_line += record.lines;
    read_scene(scenes, columns, record, found);
    write_and_read(columns, record);
  }
  demand_blank_up_to(blank.size() + 1);
  demand(record.line == 0 || record.end <= bytes.size(), "records end within the table");
  demand(records == found.scenes + found.errors, "every record is a scene or has an error");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    read_table(std::string(reinterpret_cast<const char*>(bytes), size));
  } catch (const file_error& error) {
    demand_sentence(error.what());
  }
  return 0;
}
