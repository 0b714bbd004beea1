// Files of maps: text that says what is in it, and whose last line tells whether it is still what was written.
#pragma once
#include <ricochet/body/validate.hpp>
#include <ricochet/version.hpp>

#include <boost/crc.hpp>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ricochet::detail {

/// 2: maps with a checksum. Version 0.1 wrote 1, without one and of e^2, in its first months.
inline constexpr int map_format = 2;

/// The fewest digits that give the same number again.
inline std::string exact(double x) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

inline std::string checksum_of(std::string_view text) {
  boost::crc_32_type crc; // the one of zip and PNG
  crc.process_bytes(text.data(), text.size());
  char hexadecimal[9];
  std::snprintf(hexadecimal, sizeof hexadecimal, "%08x", static_cast<unsigned>(crc.checksum()));
  return hexadecimal;
}

/// Lines of a map's file: comments begin with #, then numbers, each line of them as it is put there.
class map_writer {
public:
  map_writer(const std::string& kind, const std::string& description) {
    text_ = std::string("# ricochet ") + version + " " + kind + ", format " + std::to_string(map_format) + "\n";
    comment("of: " + description);
  }

  void comment(const std::string& line) { text_ += "# " + line + "\n"; }

  template <class... Numbers>
  void line(const Numbers&... numbers) {
    (put(numbers), ...);
    text_.back() = '\n';
  }

  /// The file gets its name only when it is whole. \throws std::runtime_error if it cannot be written.
  void finish(const std::filesystem::path& file) const {
    const std::filesystem::path unfinished = file.string() + ".part";
    std::ofstream out(unfinished, std::ios::binary);
    out << text_ << "checksum " << checksum_of(text_) << '\n';
    out.close();
    if (!out)
      throw std::runtime_error("cannot write " + unfinished.string());
    std::filesystem::rename(unfinished, file);
  }

private:
  void put(double x) { text_ += exact(x) + " "; }
  template <class Range>
  requires requires(const Range& r) { r.begin(); }
  void put(const Range& numbers) {
    for (const auto& x : numbers)
      put(x);
  }

  std::string text_;
};

/// Numbers of a map's file, in their order. \throws std::runtime_error that names the file and says what is wrong with
/// it.
class map_reader {
public:
  map_reader(const std::filesystem::path& file, const std::string& kind) : file_(file.string()) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
      throw std::runtime_error("cannot read " + file_);
    text_.assign(std::istreambuf_iterator<char>(in), {});
    const std::string first = line(), head = "# ricochet ", format = " map, format ";
    const std::size_t version_ends = first.find(' ', head.size()), kind_ends = first.find(format);
    if (!first.starts_with(head) || version_ends >= kind_ends || kind_ends == std::string::npos)
      refuse("is no map");
    const std::string found = first.substr(version_ends + 1, kind_ends - version_ends - 1) + " map";
    if (found != kind)
      refuse("is a " + found + ", not a " + kind);
    if (first.substr(kind_ends + format.size()) != std::to_string(map_format))
      refuse("is of format " + first.substr(kind_ends + format.size()) + ", where " + std::to_string(map_format) +
             " is read: make the map anew");
    const std::size_t last = text_.rfind("\nchecksum ");
    if (last == std::string::npos || text_.size() != last + 19 || text_.back() != '\n')
      refuse("is not whole: it does not end with a checksum");
    const std::string written = text_.substr(last + 10, 8);
    text_.resize(last + 1);
    if (const std::string is = checksum_of(text_); is != written)
      refuse("is damaged: its checksum is " + is + ", not " + written);
    while (at_ < text_.size() && text_[at_] == '#')
      if (const std::string comment = line(); comment.starts_with("# of: "))
        description_ = comment.substr(6);
  }

  double number() {
    skip_space();
    double x;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
    if (error != std::errc{} || !std::isfinite(x))
      refuse("has no number where one is needed, but '" + text_.substr(at_, 20) + "'");
    at_ = std::size_t(end - text_.data());
    return x;
  }

  /// A number of things. \throws also if it is none, or more than the file can hold.
  std::size_t count() {
    const double n = number();
    if (!(n >= 0 && n <= double(text_.size()) && n == std::floor(n)))
      refuse("says that it holds " + exact(n) + " of something");
    return std::size_t(n);
  }

  /// What `make` makes of numbers read to the end. What it finds wrong with them is said of the file.
  template <class Make>
  auto finish(const Make& make) {
    skip_space();
    if (at_ != text_.size())
      refuse("goes on behind its end");
    try {
      return make();
    } catch (const bad_input& e) {
      throw std::runtime_error(file_ + ": " + e.what());
    }
  }

  const std::string& description() const { return description_; }
  [[noreturn]] void refuse(const std::string& why) const { throw std::runtime_error(file_ + " " + why); }

private:
  std::string line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string found = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    return found;
  }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n'))
      ++at_;
  }

  std::string file_, text_, description_ = "";
  std::size_t at_ = 0;
};

/// A description goes into one line of a file.
inline const std::string& one_line(const std::string& description) {
  if (description.find_first_of("\r\n") != std::string::npos)
    throw bad_input("description of the map: it has a line break, where one line is wanted");
  return description;
}

} // namespace ricochet::detail
