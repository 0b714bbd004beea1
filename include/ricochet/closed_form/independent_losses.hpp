// Several losses in one impact, as if none knew of the others.
#pragma once
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/viscoelastic_hertz.hpp>

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace ricochet::closed_form {

/// Restitution if each loss took its energy independently; nothing if together they take it all, or one does alone.
/// 1 - e^2 = sum (1 - e_i^2), for two losses e^2 = e_A^2 + e_P^2 - 1
/// restitutions: e_i with one loss each, dimensionless, in [0, 1], or nothing where that loss alone captures.
/// Valid where they act at different times or speeds, as adhesion and plastic flow; not for adhesion and viscosity.
/// Source: Krijt 2013 (27), (30), which leave e^2 < 0 open: captured.
inline std::optional<double> independent_losses(std::initializer_list<std::optional<double>> restitutions) {
  double smallest = 1, lost_by_others = 0; // the smallest is squared as it is, so that it alone comes out exactly
  for (const auto& each : restitutions) {
    if (!each)
      return std::nullopt;
    require("restitution", *each, range{.high = 1, .high_included = true});
    const double larger = std::max(smallest, *each);
    smallest = std::min(smallest, *each);
    lost_by_others += (1 - larger) * (1 + larger);
  }
  const double left = square(smallest) - lost_by_others;
  return left > 0 ? std::optional(std::sqrt(left)) : std::nullopt;
}

/// The same for adhesion of a static edge and weak damping in the bulk.
/// e_I = sqrt(e_JKR^2 + e_D^2 - 1), e_JKR = restitution(pair, w, v), e_D = weak_damping_restitution(pair, A, v)
/// pair, A, v: as in damping_number(); w: work of adhesion of the pair, J/m^2, >= 0.
/// Valid as a yardstick only: viscoelastic adhesive spheres lose much more (ice at 8 m/s: 0.92 against 0.66).
/// Source: Krijt 2013 (27).
inline std::optional<double> independent_losses(const contact_pair& pair, energy_per_area w, duration A, speed v) {
  const double damped = weak_damping_restitution(pair, A, v);
  return independent_losses({restitution(pair, w, v), damped > 0 ? std::optional(damped) : std::nullopt});
}

} // namespace ricochet::closed_form
