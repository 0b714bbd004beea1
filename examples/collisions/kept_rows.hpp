// The rows that an interrupted run has left in the output's .part file. Each is compared with the row of the input that
// it was computed from, so that whatever is kept belongs to this input.
#pragma once
#include "output_table.hpp"

#include <cstdint>
#include <fstream>
#include <string>

namespace collisions {

class kept_rows {
public:
  /// Nothing is kept where there is no such file or it is empty, or `part` is empty. The head is what this run begins
  /// its output with, the names of the columns included. \throws file_error if the file begins otherwise.
  kept_rows(const std::string& part, const std::string& head, const header& columns);

  /// Whether there is a row more; what is not whole, and all behind it, is none.
  bool more() const { return next_.has_value(); }

  /// Takes the next row, which is to be that of this record. \throws file_error if it is not.
  written_row take(const csv_record& input);

  /// Bytes of the head and the rows taken, which are to stay.
  std::uintmax_t size() const { return size_; }

  /// \throws file_error: the input ends before the kept rows do.
  [[noreturn]] void refuse_the_rest() const;

private:
  void read_next();
  [[noreturn]] void refuse(const std::string& why) const;

  std::string part_;
  const header& columns_;
  std::ifstream file_;
  csv_reader reader_{file_};
  csv_record record_;
  std::optional<written_row> next_;
  std::uintmax_t size_ = 0, whole_ = 0; ///< a row that ends behind whole_ is not whole
};

} // namespace collisions
