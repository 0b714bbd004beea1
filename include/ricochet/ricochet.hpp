// Everything but the adapters for other scalar types (number/), in the order in which data flow through the library.
#pragma once
#include <ricochet/version.hpp>

#include <ricochet/collide.hpp>

#include <ricochet/law/elastic/hertz.hpp>

#include <ricochet/law/adhesion/jkr.hpp>

#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>

#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
