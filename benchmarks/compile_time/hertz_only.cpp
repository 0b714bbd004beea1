// The least that can be composed.
#include <ricochet/collide.hpp>
#include <ricochet/law/elastic/hertz.hpp>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  return collide(compose(between(grain, grain), hertz{}), impact{8.0 * metres_per_second}).restitution ? 0 : 1;
}
