// expects: two end conditions were given: keep one

#include "scene.hpp"

int main() { compose(pair, hertz{}, end_at_zero_force{}, end_at_zero_overlap{}); }
