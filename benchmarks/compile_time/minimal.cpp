// A program with the whole physics of Krijt et al. 2013 in one call.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{materials::water_ice, 2.0 * micrometres};
  const auto model = compose(
      between(grain, grain), hertz{}, jkr{.work_of_adhesion = 0.74 * joules_per_square_metre},
      greenwood{.relaxation_time = 1e-11 * seconds, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres},
      kuwabara_kono{.bulk_time = 1.6e-10 * seconds});
  return collide(model, impact{8.0 * metres_per_second}).restitution ? 0 : 1;
}
