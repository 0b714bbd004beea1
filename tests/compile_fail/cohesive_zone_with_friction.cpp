// expects: a contact with a cohesive zone moves along its normal only: drop the tangential law or take jkr or dmt

#include "scene.hpp"

#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/tangential/coulomb.hpp>

int main() { compose(pair, hertz{}, maugis_dugdale{}, coulomb{}); }
