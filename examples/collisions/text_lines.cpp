#include "text_lines.hpp"
#include "errors.hpp"

#include <iterator>
#include <utility>

namespace collisions {

namespace {

void take_mark_off(std::string& first_line) {
  if (first_line.starts_with("\xFF\xFE") || first_line.starts_with("\xFE\xFF"))
    throw file_error("the input is UTF-16: save it as UTF-8");
  if (first_line.starts_with("\xEF\xBB\xBF"))
    first_line.erase(0, 3);
}

} // namespace

bool text_lines::take(text_line& line) {
  if (!waiting_.empty()) {
    line = std::move(waiting_.front());
    waiting_.pop_front();
    return true;
  }
  line = {};
  const std::uintmax_t begin = bytes_read_;
  char c = 0;
  while (in_.get(c)) {
    ++bytes_read_;
    if (line.text.size() < longest)
      line.text += c;
    else
      line.too_long = true;
    if (c == '\r' && in_.peek() == '\n')
      continue;
    if (c == '\n' || c == '\r')
      break;
  }
  if (in_.bad())
    throw file_error("the input cannot be read");
  if (bytes_read_ == begin)
    return false;
  line.number = ++lines_read_;
  line.end = bytes_read_;
  if (line.number == 1)
    take_mark_off(line.text);
  return true;
}

void text_lines::put_back(std::vector<text_line> lines) {
  waiting_.insert(waiting_.begin(), std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
}

} // namespace collisions
