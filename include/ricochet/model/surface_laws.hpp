#pragma once
#include <ricochet/model/shaped_laws.hpp>

namespace ricochet {

/// The laws of a contact model with the equations of the motion along the surface, of a contact that slides or rolls as
/// a whole; of homogeneous spheres: 1/m* + sum R_i^2/I_i = 7/2m*. Nothing where no law slides.
template <class T, class Model>
class surface_laws : public shaped_laws<T, Model> {
  using laws = shaped_laws<T, Model>;

public:
  using laws::adhesion;
  using laws::elastic;
  using laws::laws;
  using laws::pair;
  using laws::peels;
  using laws::slides;
  using laws::tangential;
  using typename laws::part;
  using surface_unknowns =
      join<std::conditional_t<slides, variables<slip_t, slip_distance_t>, variables<>>,
           std::conditional_t<peels, variables<surface_speed_t, surface_distance_t, friction_loss_t, peeling_loss_t>,
                              variables<>>>;

  /// `direction` in which the contact point slides, 0 while it rolls; `clock`: dt/d(sigma).
  template <class State>
  void slide(const part& c, const State& x, State& dx, const T& clock, int direction) const requires slides {
    const T advance = clock / pair.reduced_mass;
    const auto friction = [&] { return tangential.sliding_force(elastic.force(pair, c)); };
    dx[slip_distance] = x[slip] * clock;
    if constexpr (!peels) {
      dx[slip] = direction == 0 ? T(0) : T(-T(7) / T(2) * friction() * advance);
    } else {
      // As forces at the sphere's surface: what the moment takes of the spin, and what friction takes of the speed.
      const T resistance = resistance_per_radius(x[surface_speed]) * c.radius;
      const T held = direction == 0 ? needed(resistance) : T(T(direction) * friction());
      dx[slip] = direction == 0 ? T(0) : T((T(5) / T(2) * resistance - T(7) / T(2) * held) * advance);
      dx[surface_speed] = T(5) / T(2) * (held - resistance) * advance;
      dx[surface_distance] = x[surface_speed] * clock;
      dx[friction_loss] = held * x[slip] * clock;
      dx[peeling_loss] = resistance * x[surface_speed] * clock;
    }
  }

  T resistance_per_radius(const T& surface_speed_now) const requires peels {
    return tangential.edge_resistance(pair, adhesion.rebound_coefficient, surface_speed_now) / pair.reduced_radius;
  }

  /// By how much the friction that can be had exceeds that which a rolling contact needs, over the contact radius, so
  /// that it is smooth down to zero; one where it needs none.
  T excess_of_friction(const part& c, const T& surface_speed_now) const requires peels {
    const T wanted = needed(resistance_per_radius(surface_speed_now));
    if (value_of(wanted) == 0)
      return T(1);
    const T had = value_of(c.radius) > 0 ? T(tangential.sliding_force(elastic.force(pair, c)) / c.radius) : T(0);
    return value_of(wanted) > 0 ? T(had - wanted) : T(had + wanted);
  }

private:
  /// Friction that keeps a contact with this resistance rolling.
  static T needed(const T& resistance) { return T(5) / T(7) * resistance; }
};

} // namespace ricochet
