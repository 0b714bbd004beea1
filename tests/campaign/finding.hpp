// What came of one collision, and what is wrong with it.
#pragma once
#include <ricochet/outcome/outcome.hpp>

#include <optional>
#include <string>

namespace campaign {

struct finding {
  ricochet::ending ending;
  bool certain = false; ///< of its ending
  std::optional<double> restitution;
  double error_estimate = 0, ledger_residual = 0;
  long evaluations = 0;
  std::string reason; ///< of an ending that is unresolved or failed
  std::string wrong;  ///< the first property that does not hold; empty if all do

  bool ended() const { return ending == ricochet::ending::separated || ending == ricochet::ending::captured; }
  /// Notes what is wrong, unless the condition holds.
  void expect(bool condition, const std::string& what) {
    if (!condition && wrong.empty())
      wrong = what;
  }
};

} // namespace campaign
