// expects: two elastic laws were given: keep one

#include "scene.hpp"

int main() { compose(pair, hertz{}, hertz{}); }
