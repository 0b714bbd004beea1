// expects: a peeling moment needs an adhesion law with a rebound coefficient: add line_force or take coulomb

#include "scene.hpp"

#include <ricochet/law/tangential/coulomb_with_peeling.hpp>

int main() { compose(pair, hertz{}, adhesion, coulomb_with_peeling{.friction_coefficient = 0.3}); }
