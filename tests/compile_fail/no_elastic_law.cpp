// expects: a contact model needs an elastic law: add hertz

#include "scene.hpp"

int main() { compose(pair, adhesion); }
