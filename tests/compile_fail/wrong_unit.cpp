// expects: conver
// expects: length_base_dimension

#include "scene.hpp"

int main() { compose(pair, hertz{}, jkr{.work_of_adhesion = 1.0 * metres}); }
