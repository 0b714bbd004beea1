// expects: two adhesion laws were given: keep one

#include "scene.hpp"

int main() { compose(pair, hertz{}, adhesion, adhesion); }
