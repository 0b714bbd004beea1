#pragma once
#include <ricochet/units.hpp>

namespace ricochet {

/// What a law sees of a contact at one instant.
template <class S>
struct configuration {
  typename S::length approach;         ///< mutual approach, > 0 when compressed
  typename S::speed rate;              ///< its rate, > 0 while closing
  typename S::length radius;           ///< contact radius a
  typename S::root_length root_radius; ///< sqrt(a); filled in only where a law of the model declares uses_root_radius
};

/// A contact at one instant on plain numbers, and how its coordinate y moves in slowed time sigma.
template <class T, class Part = configuration<reduced<T>>>
struct contact_instant {
  Part c;
  T clock;            ///< dt/d(sigma)
  T coordinate_rate;  ///< dy/d(sigma)
  T root_ratio;       ///< sqrt(G/w); 1 for a slaved edge with adhesion, 0 without
  T slowness;         ///< of a free edge: 0 where it runs at infinite speed
  truth_of<T> inside; ///< false outside the domain of the equations
};

} // namespace ricochet
