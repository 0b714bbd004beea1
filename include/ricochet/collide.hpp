// Bodies, composition and collide(): everything but the laws, which are included one by one from law/.
#pragma once
#include <ricochet/body/materials.hpp>
#include <ricochet/body/pair.hpp>
#include <ricochet/model/compose.hpp>
#include <ricochet/solve/collide.hpp>
