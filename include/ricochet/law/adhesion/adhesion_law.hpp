#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// Adhesion law with a surface energy: the edge of a static contact lies where the energy release rate equals the work
/// of adhesion. Axioms: published pull-off force and fold; U at the fold is the exit energy; the static branch is the
/// stable one.
template <class L>
concept adhesion_law = any_law<L> && plays<L, role::adhesion> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair, double x) {
  { law.work_of_adhesion } -> std::convertible_to<double>;
  { law.surface_energy(x) } -> std::same_as<double>;
  { law.flattening(pair) } -> std::same_as<double>;
  { law.touch_radius(pair) } -> std::same_as<double>;
  { law.fold_radius(pair) } -> std::same_as<double>;
  { law.contact_radius(pair, x) } -> std::same_as<double>;
  { law.pull_off_force(pair) } -> std::same_as<double>;
  { law.exit_energy(pair) } -> std::same_as<double>;
};

} // namespace ricochet
