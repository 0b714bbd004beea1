// Closed forms of one number, for many collisions side by side.
#pragma once
#include <ricochet/batch/lane_laws.hpp>
#include <ricochet/closed_form/closed_outcome.hpp>

namespace ricochet {

/// `scene_of(i)` gives collision i < count, `alone(i)` its outcome where it lies beyond the table. The number and its
/// place in the table are computed in lanes, what stands there is looked up one by one.
template <class Lanes, closed_form::tabulated Model, class SceneOf, class Alone>
void solve_tabulated(std::size_t count, const SceneOf& scene_of, const Alone& alone, outcome_of<Model>* outcomes) {
  constexpr const auto& table = closed_form::detail::table_of<Model>();
  auto laws = laws_in_si<Lanes>(scene_of(0).model);
  Lanes speed(1);
  for (std::size_t first = 0; first < count; first += Lanes::size) {
    const std::size_t together = std::min(Lanes::size, count - first);
    for (std::size_t lane = 0; lane < together; ++lane) {
      const auto& [model, impact] = scene_of(first + lane);
      put_lane(laws, lane, laws_in_si<double>(model));
      speed.put(lane, in_si(impact.speed));
    }
    const Lanes x = closed_form::detail::table_argument(laws, speed), place = table.place(x);
    for (std::size_t lane = 0; lane < together; ++lane)
      if (x[lane] <= table.last)
        outcomes[first + lane] = closed_form::detail::closed_outcome<Model>(table.at(place[lane]), 1);
      else
        outcomes[first + lane] = alone(first + lane);
  }
}

} // namespace ricochet
