// expects: plastic flow is added to the normal motion only: drop the tangential law or the plasticity law

#include "scene.hpp"

#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/law/tangential/coulomb.hpp>

int main() { compose(pair, hertz{}, thornton_ning_contact{}, coulomb{}); }
