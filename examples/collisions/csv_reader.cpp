#include "csv_reader.hpp"
#include "errors.hpp"
#include "utf8.hpp"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace collisions {

namespace {

constexpr unsigned char strict = CSV_STRICT | CSV_STRICT_FINI;
constexpr const char* blanks = " \t\r\n";

/// What libcsv's calls fill.
struct filling {
  csv_record& record;
  bool complete = false;
};

void take_cell(void* text, std::size_t size, void* data) {
  static_cast<filling*>(data)->record.cells.emplace_back(static_cast<const char*>(text), size);
}

void take_end(int, void* data) { static_cast<filling*>(data)->complete = true; }

void make_text(csv_record& record) {
  for (std::size_t i = 0; i < record.cells.size(); ++i)
    if (std::string why = why_no_text(record.cells[i]); !why.empty()) {
      record.cells[i] = as_text(record.cells[i]);
      if (record.error.empty()) {
        record.error = std::move(why);
        record.bad_cell = i;
      }
    }
}

} // namespace

csv_reader::csv_reader(std::istream& in) : lines_(in) { start_afresh(); }

csv_reader::~csv_reader() { csv_free(&parser_); }

void csv_reader::start_afresh() {
  csv_free(&parser_);
  if (csv_init(&parser_, strict) != 0)
    throw std::bad_alloc();
  csv_set_space_func(&parser_, [](unsigned char) { return 0; }); // cells keep their spaces
}

std::vector<std::string> csv_reader::comments() {
  std::vector<std::string> found;
  for (text_line line; lines_.take(line);) {
    const std::string text = line.text.substr(0, line.text.find_last_not_of(blanks) + 1);
    if (line.too_long || (!text.empty() && text.front() != '#')) {
      lines_.put_back({std::move(line)});
      break;
    }
    if (!text.empty())
      found.push_back(as_text(text));
  }
  return found;
}

bool csv_reader::next(csv_record& record) {
  text_line first;
  do
    if (!lines_.take(first))
      return false;
  while (!first.too_long && first.text.find_first_not_of(blanks) == std::string::npos);
  record = {.line = first.number, .lines = 1, .end = first.end, .cells = {}, .error = {}, .bad_cell = {}};
  if (first.too_long)
    record.error = fmt::format("the line is longer than {} bytes", text_lines::longest);
  else
    parse(first, record);
  make_text(record);
  return true;
}

void csv_reader::parse(const text_line& first, csv_record& record) {
  constexpr const char* open = "a quoted cell is not closed by a quote on this line, nor well on those behind it";
  constexpr const char* misplaced =
      "misplaced quote: a cell that holds a quote begins and ends with one, and doubles those within";
  filling data{record};
  std::vector<text_line> more;
  std::size_t size = 0, cells_of_first = 0;
  for (const text_line* line = &first;; line = &more.back()) {
    size += line->text.size();
    const bool fits = !line->too_long && size <= text_lines::longest && more.size() < most_lines;
    if (!fits || csv_parse(&parser_, line->text.data(), line->text.size(), take_cell, take_end, &data) !=
                     size_t(line->text.size())) {
      record.error = more.empty() ? misplaced : open;
      break;
    }
    if (line == &first)
      cells_of_first = record.cells.size();
    if (data.complete)
      break;
    if (text_line another; lines_.take(another)) {
      more.push_back(std::move(another));
    } else {
      if (csv_fini(&parser_, take_cell, take_end, &data) != 0)
        record.error = open;
      start_afresh();
      break;
    }
  }
  if (const int why = csv_error(&parser_); why == CSV_ENOMEM || why == CSV_ETOOBIG)
    throw std::bad_alloc();
  if (!more.empty() && record.error.empty() && expected_ && record.cells.size() != *expected_)
    record.error = open;
  if (record.error.empty()) {
    if (!more.empty())
      record.end = more.back().end;
    record.lines = 1 + more.size();
    return;
  }
  start_afresh();
  if (!more.empty())
    record.cells.resize(cells_of_first);
  lines_.put_back(std::move(more));
}

} // namespace collisions
