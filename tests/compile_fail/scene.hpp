// What the programs of this directory have in common.
#pragma once
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

inline const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
inline const jkr adhesion{.work_of_adhesion = 0.74 * joules_per_square_metre};
inline const greenwood crack{
    .relaxation_time = 1e-11 * seconds, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres};
inline const kuwabara_kono bulk{.bulk_time = 1.6e-10 * seconds};
