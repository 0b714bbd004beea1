// Restitutions alone, of many scenes at once.
#pragma once
#include "scene.hpp"

#include <span>
#include <vector>

namespace fit_restitution {

/// Zero of pairs that stick, NaN where a collision is not resolved. Scenes of Hertzian contacts without friction run as
/// batches, others one by one; threads: 0 takes as many as the machine has.
std::vector<double> restitutions(std::span<const collisions::scene> scenes, double tolerance, unsigned threads);

} // namespace fit_restitution
