// expects: every argument of compose() after the pair must be a law or a request: it needs `using role = ...`

#include "scene.hpp"

int main() { compose(pair, hertz{}, 4.0 * metres_per_second); }
