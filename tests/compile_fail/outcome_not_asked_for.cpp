// expects: crack_loss

#include "scene.hpp"

int main() {
  const auto out = integrate(compose(pair, hertz{}, adhesion, crack), impact{8.0 * metres_per_second});
  return out.crack_loss > 0;
}
