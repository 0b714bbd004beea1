// expects: a crack-velocity law needs an adhesion law with a surface energy: add jkr

#include "scene.hpp"

#include <ricochet/law/adhesion/line_force.hpp>

int main() { compose(pair, hertz{}, line_force{}, crack); }
