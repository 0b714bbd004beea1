#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

// What an outcome reports beyond ending and restitution, named in compose(). Unasked, it has no unknowns, no events and
// no members.

/// Losses per law, remaining energy and the residual of the balance.
struct energy_ledger {
  using role = role::request;
};
/// Time from first touch to final loss of contact, flights included.
struct contact_duration {
  using role = role::request;
};
/// Largest approach, contact radius, tension and compression.
struct extremes {
  using role = role::request;
};
/// The motion itself, as columns.
struct trajectory {
  using role = role::request;
};

/// A sentence for each law used outside its range (model/regime.hpp).
struct regime_warnings {
  using role = role::request;
};

/// The requests of a model, as a value that can stand in its type.
struct requests {
  bool ledger = false, duration = false, extremes = false, trajectory = false, warnings = false;
  /// Is nothing asked for that has to be watched during the motion?
  constexpr bool outcome_only() const { return !ledger && !duration && !extremes && !trajectory; }
  friend constexpr bool operator==(const requests&, const requests&) = default;
};

} // namespace ricochet
