// expects: an end condition is only for contacts without adhesion: with jkr the edge decides where contact ends

#include "scene.hpp"

int main() { compose(pair, hertz{}, adhesion, end_at_zero_overlap{}); }
