#pragma once
#include <ricochet/body/material.hpp>

namespace ricochet {

/// A homogeneous sphere, radius > 0.
struct sphere {
  material solid;
  length radius;

  ricochet::mass mass() const { return 4 * pi<double>() / 3 * solid.mass_density * radius * radius * radius; }
};

/// A flat wall: radius and mass are infinite.
struct flat_wall {
  material solid;
};

} // namespace ricochet
