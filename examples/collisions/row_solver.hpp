// Rows one after another: solved, or counted as an earlier run has solved them.
#pragma once
#include "arguments.hpp"
#include "messages.hpp"
#include "output_table.hpp"
#include "scene_reader.hpp"

#include <optional>
#include <string>

namespace collisions {

class row_solver {
public:
  row_solver(const header& columns, const arguments& given, messages& messages)
      : columns_(columns), given_(given), messages_(messages) {}

  /// The line to write for a row, solved or failed; says what there is to say of it.
  std::string line_of(const csv_record& record);

  /// Counts a row that has been solved and written before.
  void count(const written_row& row);

  long rows() const { return rows_; }
  long unresolved() const { return unresolved_; } ///< failed ones among them

  /// A note on warnings, where there were any.
  void say_at_the_end();

private:
  std::optional<outcome> solve(const csv_record& record);

  const header& columns_;
  const arguments& given_;
  messages& messages_;
  scene_reader scenes_;
  long rows_ = 0, unresolved_ = 0, warned_ = 0;
};

} // namespace collisions
