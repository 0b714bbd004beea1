#pragma once
#include <ricochet/law/crack/crack_velocity_law.hpp>
#include <ricochet/model/odeint.hpp>
#include <ricochet/model/reduced_model.hpp>

#include <algorithm>

namespace ricochet {

/// The equations of motion of a contact as they are written in the papers: an odeint System in SI units and time, for
/// whoever wants a loop of their own. Unknowns: x[mutual_approach] (m), x[approach_rate] (m/s) and, with a crack law,
/// x[contact_radius] (m). Its solutions start and end with roots of the time; collide() works in smooth coordinates.
template <class Model>
class physical_system {
  static_assert(!Model::flows, "a physical system has no memory of plastic flow: take collide()");
  static_assert(!Model::cohesive, "a physical system has no radius of a contact with a cohesive zone: take collide()");

public:
  static constexpr bool free_edge = Model::has_crack_law;
  using state_type =
      state<double, join<variables<mutual_approach_t, approach_rate_t>, optionally<contact_radius_t, free_edge>>>;

  explicit physical_system(const Model& model) : numbers_(model, scales{}) {}

  /// The bodies touch at this speed.
  state_type touch(speed v) const {
    state_type x{};
    x[approach_rate] = in_si(v);
    if constexpr (free_edge) {
      const double y = numbers_.touch(in_si(v))[numbers_.coordinate];
      x[contact_radius] = y * y;
    }
    return x;
  }

  void operator()(const state_type& x, state_type& dxdt, double) const {
    const auto c = configure(x);
    dxdt[mutual_approach] = c.rate;
    dxdt[approach_rate] = -numbers_.total_force(c) / numbers_.pair.reduced_mass;
    if constexpr (free_edge) {
      const auto edge = rate_anywhere<double>(numbers_.crack, sqrt(energy_release_ratio(x)));
      dxdt[contact_radius] = edge_speed() * edge.advance / edge.slowness;
    }
  }

  /// beta = G/w of a free edge.
  double energy_release_ratio(const state_type& x) const requires free_edge {
    return numbers_.elastic.energy_release_rate(numbers_.pair, configure(x)) / numbers_.adhesion.work_of_adhesion;
  }

  /// Where a free edge at its limiting ratio lets go, and a static one has no radius any more.
  bool past_fold(const state_type& x) const { return numbers_.past_fold(configure(x)); }

private:
  configuration<reduced<double>> configure(const state_type& x) const {
    double a = 0;
    if constexpr (free_edge)
      a = x[contact_radius];
    else if constexpr (Model::adhesive)
      a = numbers_.adhesion.contact_radius(numbers_.pair, max(x[mutual_approach], fold_approach()));
    else
      a = sqrt(max(0.0, x[mutual_approach]) * numbers_.pair.reduced_radius);
    return {x[mutual_approach], x[approach_rate], a, sqrt(a)};
  }

  double fold_approach() const requires Model::adhesive {
    const double a = numbers_.adhesion.fold_radius(numbers_.pair);
    return numbers_.elastic.load_free_approach(numbers_.pair, a) -
           numbers_.adhesion.flattening(numbers_.pair) * sqrt(a);
  }

  double edge_speed() const requires free_edge {
    return numbers_.crack.speed_scale(numbers_.pair, numbers_.adhesion.work_of_adhesion);
  }

  reduced_model<double, Model> numbers_;
};

} // namespace ricochet
