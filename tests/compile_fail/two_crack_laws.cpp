// expects: two crack-velocity laws were given: keep one

#include "scene.hpp"

int main() { compose(pair, hertz{}, adhesion, crack, crack); }
