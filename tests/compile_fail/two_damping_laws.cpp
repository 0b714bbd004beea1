// expects: two bulk damping laws were given: keep one

#include "scene.hpp"

int main() { compose(pair, hertz{}, bulk, tsuji{.damping_coefficient = 0.1}); }
