// What came of one collision, and what is wrong with it.
#pragma once
#include <ricochet/outcome/outcome.hpp>

#include <cmath>
#include <limits>
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

inline double e_of(const finding& f) { return f.restitution.value_or(0); }

/// How often the estimate goes into the error beyond what else explains it.
inline double over_estimate(const finding& f, double error) {
  const double excess = error - 1e-12;
  return excess > 0 ? excess / f.error_estimate : 0;
}

/// Difference of two restitutions, both of certain endings; infinite where the endings differ.
inline double difference(const finding& one, const finding& other) {
  return one.ending == other.ending ? std::abs(e_of(one) - e_of(other)) : std::numeric_limits<double>::infinity();
}

} // namespace campaign
