// expects: an end condition is only for contacts without adhesion: with adhesion the contact lets go where it tears

#include "scene.hpp"

int main() { compose(pair, hertz{}, adhesion, end_at_zero_overlap{}); }
