// Two grains of ice bounce under hertz and jkr, in a project that only uses ricochet.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  const auto model = compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = 0.74 * joules_per_square_metre});
  const auto out = collide(model, impact{4.0 * metres_per_second}, {.tolerance = 1e-11});
  const double restitution = out.restitution.value();
  std::printf("restitution %.13f\n", restitution);
  return std::abs(restitution - 0.9310715034703) < 1e-9 ? 0 : 1;
}
