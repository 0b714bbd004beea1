// Compositions of laws as values, so that one test can go through all of them.
#pragma once
#include "support/random_scenes.hpp"

#include <string>
#include <vector>

namespace support {

/// What is asked of a collision whatever its laws; losses in units of the initial kinetic energy.
struct summary {
  ricochet::ending ending;
  double restitution; ///< 0 when captured
  double error_estimate;
  bool certain;
  double duration, crack_loss, bulk_loss, plastic_loss; ///< of collide(), which is not asked for them, 0

  /// Nothing is known of the restitution of others.
  bool ended() const { return ending == ending::separated || ending == ending::captured; }
};

struct composition {
  const char* name;
  summary (*integrate)(const scene&, double tolerance);
  summary (*collide)(const scene&, double tolerance); ///< by the closed form where there is one
};

const std::vector<composition>& compositions();
/// \throws std::out_of_range for a name that is not among them.
const composition& composed_of(const std::string& name);

/// One table for all scenes of a modulus ratio.
greenwood edge(const scene& s);

} // namespace support
