#include "kept_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace collisions {

namespace {

/// Where the last row has to end to be whole: a row ends with a line end.
std::uintmax_t end_of_whole_rows(std::ifstream& file) {
  file.seekg(-1, std::ios::end);
  const auto last = static_cast<std::uintmax_t>(file.tellg());
  return file.get() == '\n' ? last + 1 : last;
}

std::string line_at(const std::string& text, std::size_t place) {
  const std::size_t begin = place == 0 ? 0 : text.rfind('\n', place - 1) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

} // namespace

kept_rows::kept_rows(const std::string& part, const std::string& head, const header& columns)
    : part_(part), columns_(columns) {
  if (part.empty())
    return;
  file_.open(part, std::ios::binary);
  std::string begin(head.size(), '\0');
  file_.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file_.gcount()));
  file_.clear();
  const auto differs = std::mismatch(begin.begin(), begin.end(), head.begin(), head.end());
  if (differs.first != begin.end()) {
    const auto place = static_cast<std::size_t>(differs.first - begin.begin());
    refuse(fmt::format("it has the line {} where this one has {}", quoted(line_at(begin, place)),
                       quoted(line_at(head, place))));
  }
  if (begin.size() < head.size())
    return;
  whole_ = end_of_whole_rows(file_);
  size_ = head.size();
  file_.clear();
  file_.seekg(0);
  reader_.comments();
  reader_.next(record_); // the names of the columns
  reader_.expect(record_.cells.size());
  read_next();
}

void kept_rows::read_next() {
  next_.reset();
  if (reader_.next(record_) && record_.end <= whole_)
    next_ = read_written(columns_, record_);
}

written_row kept_rows::take(const csv_record& input) {
  if (next_->copied != copied_cells(columns_, input))
    refuse(fmt::format("its line {} is not that of the input's line {}", record_.line, input.line));
  const written_row taken = *std::exchange(next_, std::nullopt);
  size_ = record_.end;
  read_next();
  return taken;
}

void kept_rows::refuse_the_rest() const {
  refuse(fmt::format("it has rows from its line {} on that the input has not", record_.line));
}

void kept_rows::refuse(const std::string& why) const {
  throw file_error(fmt::format("{} was begun by another command, version or input: {}; to begin anew delete it, or "
                               "name another output",
                               part_, why));
}

} // namespace collisions
