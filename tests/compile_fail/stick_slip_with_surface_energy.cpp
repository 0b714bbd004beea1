// expects: a tangential law with stick and slip needs a Hertzian contact: drop the adhesion law or take coulomb

#include "scene.hpp"

#include <ricochet/law/tangential/mindlin.hpp>

int main() { compose(pair, hertz{}, adhesion, mindlin{.friction_coefficient = 0.3, .stiffness_ratio = 0.8}); }
