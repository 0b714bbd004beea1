// expects: plastic flow within the motion goes with an adhesion law with a surface energy: take jkr or thornton_ning

#include "scene.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

int main() { compose(pair, hertz{}, dmt{}, thornton_ning_contact{}); }
