// expects: a physical system has no memory of plastic flow: take collide()

#include "scene.hpp"

#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/model/physical_system.hpp>

int main() { physical_system system(compose(pair, hertz{}, thornton_ning_contact{.yield_strength = 1e8 * pascals})); }
