// expects: a crack-velocity law needs an adhesion law with a surface energy: add jkr

#include "scene.hpp"

int main() { compose(pair, hertz{}, crack); }
