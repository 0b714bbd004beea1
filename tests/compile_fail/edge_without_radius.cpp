// expects: an adhesion law with a surface energy needs an elastic law with an edge: take hertz, or dmt or line_force

#include "scene.hpp"

#include <ricochet/law/elastic/linear.hpp>

int main() { compose(pair, linear{40.0 * newtons_per_metre}, adhesion); }
