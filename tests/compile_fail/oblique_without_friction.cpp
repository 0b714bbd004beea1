// expects: an oblique impact needs a tangential law: add coulomb

#include "scene.hpp"

#include <ricochet/solve/oblique/oblique.hpp>

int main() { collide(compose(pair, hertz{}), oblique_impact{1.0 * metres_per_second}); }
