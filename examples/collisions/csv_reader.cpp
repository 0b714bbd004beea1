#include "csv_reader.hpp"
#include "errors.hpp"

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

} // namespace

csv_reader::csv_reader(std::istream& in) : in_(in) { start_afresh(); }

csv_reader::~csv_reader() { csv_free(&parser_); }

void csv_reader::start_afresh() {
  csv_free(&parser_);
  if (csv_init(&parser_, strict) != 0)
    throw std::bad_alloc();
  csv_set_space_func(&parser_, [](unsigned char) { return 0; }); // cells keep their spaces
}

bool csv_reader::read_line() {
  line_.clear();
  char c = 0;
  while (in_.get(c)) {
    line_ += c;
    if (c == '\r' && in_.peek() == '\n')
      continue;
    if (c == '\n' || c == '\r')
      break;
  }
  if (in_.bad())
    throw file_error("the input cannot be read");
  if (line_.empty())
    return false;
  if (++line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF"))
    line_.erase(0, 3);
  return true;
}

std::vector<std::string> csv_reader::comments() {
  std::vector<std::string> found;
  while (read_line()) {
    const std::string text = line_.substr(0, line_.find_last_not_of(blanks) + 1);
    unread_ = !text.empty() && text.front() != '#';
    if (unread_)
      break;
    if (!text.empty())
      found.push_back(text);
  }
  return found;
}

bool csv_reader::next(csv_record& record) {
  do
    if (!std::exchange(unread_, false) && !read_line())
      return false;
  while (line_.find_first_not_of(blanks) == std::string::npos);
  record = {.line = line_number_, .cells = {}, .error = {}};
  parse(record);
  return true;
}

void csv_reader::parse(csv_record& record) {
  filling data{record};
  bool more = true;
  while (more && !data.complete) {
    if (csv_parse(&parser_, line_.data(), line_.size(), take_cell, take_end, &data) != line_.size())
      break;
    more = data.complete || read_line();
  }
  if (!more && csv_fini(&parser_, take_cell, take_end, &data) != 0) {
    record.error = "a quoted cell is not closed by a quote before the end of the file";
  } else if (const int why = csv_error(&parser_); why == CSV_ENOMEM || why == CSV_ETOOBIG) {
    throw std::bad_alloc();
  } else if (why != CSV_SUCCESS) {
    record.error = "misplaced quote: a cell that holds a quote begins and ends with one, and doubles those within";
  }
  if (!more || !record.error.empty())
    start_afresh();
}

} // namespace collisions
