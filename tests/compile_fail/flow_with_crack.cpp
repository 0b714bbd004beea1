// expects: plastic flow within the motion goes with a static edge: drop the crack-velocity law or take thornton_ning

#include "scene.hpp"

#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

int main() { compose(pair, hertz{}, adhesion, crack, thornton_ning_contact{}); }
