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

} // namespace ricochet
