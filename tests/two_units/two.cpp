#include <ricochet/ricochet.hpp>

#include "two_units.hpp"

seen seen_by_two() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  const auto model = compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = 0.74 * joules_per_square_metre});
  return {&units::metres, &materials::water_ice, integrate(model, impact{4.0 * metres_per_second}).restitution.value()};
}
