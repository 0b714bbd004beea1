// expects: plastic flow is added to Hertzian contacts only: drop the plasticity law or take hertz

#include "scene.hpp"

#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>

int main() { compose(pair, linear{40.0 * newtons_per_metre}, thornton_ning{.yield_strength = 1.0 * gigapascals}); }
