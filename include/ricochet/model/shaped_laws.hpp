#pragma once
#include <ricochet/model/reduced_laws.hpp>
#include <ricochet/model/state.hpp>

namespace ricochet {

/// The laws of a contact model in the coordinate y of its motion, a or sqrt(a), and the shape that plastic flow gives
/// the contact they are evaluated on: a function of the largest y so far.
template <class T, class Model>
class shaped_laws : public reduced_laws<T, Model> {
  using laws = reduced_laws<T, Model>;

public:
  using laws::adhesion;
  using laws::adhesive;
  using laws::cohesive;
  using laws::flows;
  using laws::free_edge;
  using laws::pair;
  using typename laws::part;
  static constexpr bool root_coordinate = !cohesive && (adhesive || needs_root_radius<decltype(Model::elastic)> ||
                                                        needs_root_radius<decltype(Model::damping)>);
  using coordinate_t = std::conditional_t<cohesive, cohesive_coordinate_t,
                                          std::conditional_t<root_coordinate, root_contact_radius_t, contact_radius_t>>;
  static constexpr coordinate_t coordinate{};

  using laws::laws;
  explicit shaped_laws(const laws& others) : laws(others) {}

  /// Least energy the contact has where it lets go; below it, it can never separate.
  const T& exit_energy() const { return exit_energy_; }

  /// The same of a contact flattened as this one is. Flow to come takes energy away and raises it: what is certain now,
  /// stays so.
  T exit_energy([[maybe_unused]] const part& c) const {
    if constexpr (flows && adhesive)
      return adhesion.exit_energy(c.pair);
    else
      return exit_energy_;
  }

protected:
  void prepare_contact() {
    if constexpr (adhesive) {
      flattening_ = adhesion.flattening(pair);
      exit_energy_ = free_edge ? T(0) : adhesion.exit_energy(pair);
    }
    if constexpr (cohesive) {
      branch_ = adhesion.branch(pair, sqrt(T(pair.reduced_radius)));
      part c{};
      place(c, branch_.fold(), value_of(branch_.fold()) > 0);
      exit_energy_ = this->potential(c);
    }
    if constexpr (flows) {
      yield_coordinate_ = this->plasticity.yield_radius(pair, flattening_);
      if constexpr (root_coordinate)
        yield_coordinate_ = sqrt(yield_coordinate_);
    }
  }

  static T radius_at(const T& y) { return root_coordinate ? T(y * y) : y; }

  contact_shape<reduced<T>> shape_at(const T& largest) const requires flows {
    return this->plasticity.shape(pair, flattening_, radius_at(yield_coordinate_), radius_at(largest));
  }

  /// Energy that flow takes for each growth of y, of a contact at its largest.
  T plastic_loss_per_growth(const part& c, const T& y) const requires flows {
    const T lost = this->plasticity.lost_force(c);
    return root_coordinate ? T(T(2) * y * lost) : lost;
  }

  /// Leads a contact with a cohesive zone to y on its branch; the slope of the approach there.
  T place(part& c, const T& y, bool touching) const requires cohesive {
    const auto p = branch_.at(y, touching);
    c.approach = p.approach;
    c.radius = p.radius;
    c.root_radius = sqrt(max(p.radius, T(0)));
    c.cohesive_radius = p.cohesive_radius;
    c.angle = p.angle;
    return p.slope;
  }

  T flattening_ = T(0), exit_energy_ = T(0);
  [[no_unique_address]] std::conditional_t<flows, T, variables<>> yield_coordinate_{};
  [[no_unique_address]] branch_of<decltype(Model::adhesion), T> branch_{};
};

} // namespace ricochet
