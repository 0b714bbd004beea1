#include "row_solver.hpp"

#include <fmt/format.h>

#include <new>

namespace collisions {

/// Nothing where the row is bad, which is said.
std::optional<outcome> row_solver::solve(const csv_record& record) {
  const auto bad = [&](const std::string& place, const char* reason) {
    messages_.say(fmt::format("line {}{}{}: {}", record.line, place.empty() ? "" : ", ", place, reason));
    return std::nullopt;
  };
  try {
    return given_.stepper.solve(scenes_.read(row(columns_, record)), given_.tolerance);
  } catch (const row_error& error) {
    return bad(error.place, error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& refused) { // quantities that are impossible only together, and a stepper that gives up
    return bad("", refused.what());
  }
}

std::string row_solver::line_of(const csv_record& record) {
  const std::optional<outcome> result = solve(record);
  const bool resolved =
      result && (result->ending == ricochet::ending::separated || result->ending == ricochet::ending::captured);
  if (result && !resolved)
    messages_.say(fmt::format("line {}: {}: {}", record.line, ricochet::name_of(result->ending), result->reason));
  else if (result && !result->ending_is_certain)
    messages_.say(fmt::format("line {}: note: so near the threshold of sticking that {} is not certain", record.line,
                              ricochet::name_of(result->ending)));
  count({.copied = {}, .resolved = resolved, .warned = result && !result->warnings.empty()});
  return row_line(columns_, record, result ? &*result : nullptr);
}

void row_solver::count(const written_row& row) {
  ++rows_;
  unresolved_ += !row.resolved;
  warned_ += row.resolved && row.warned;
  messages_.row_done();
}

void row_solver::say_at_the_end() {
  if (warned_ > 0)
    messages_.say(fmt::format("note: {} of the rows {} laws outside their range; see the column warnings", warned_,
                              warned_ == 1 ? "uses" : "use"));
}

} // namespace collisions
