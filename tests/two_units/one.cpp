// All headers in two translation units of one program: it links, and both see the same objects and the same collision.
#include <ricochet/ricochet.hpp>

#include "two_units.hpp"

#include <cstdio>
#include <string>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  const auto model = compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = 0.74 * joules_per_square_metre});
  const double restitution = integrate(model, impact{4.0 * metres_per_second}).restitution.value();
  const seen other = seen_by_two();

  int failures = 0;
  const auto check = [&failures](bool holds, const char* what) {
    if (!holds) {
      std::printf("fails: %s\n", what);
      ++failures;
    }
  };
  check(other.metres == &units::metres, "one unit of length");
  check(other.water_ice == &materials::water_ice, "one material");
  check(other.restitution == restitution, "one restitution");
  const int major = RICOCHET_VERSION / 10000, minor = RICOCHET_VERSION / 100 % 100, patch = RICOCHET_VERSION % 100;
  check(std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch) == version,
        "macro and constant name the same version");
  return failures;
}
