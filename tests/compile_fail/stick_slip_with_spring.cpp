// expects: stick and slip is that of a Hertzian contact: take hertz or coulomb

#include "scene.hpp"

#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

int main() { compose(pair, linear{40.0 * newtons_per_metre}, mindlin{}); }
