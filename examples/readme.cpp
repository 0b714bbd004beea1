// The program of the README.
// [program]
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const duration relaxation_time = 1e-11 * seconds;

  const auto model = compose(
      between(grain, grain), hertz{}, jkr{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)},
      greenwood{.relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres},
      kuwabara_kono{.bulk_time = bulk_time_of_krijt(relaxation_time, 0.25)}, energy_ledger{}, contact_duration{});

  const auto out = collide(model, impact{.speed = 8.0 * metres_per_second});

  std::printf("%s with e = %.7f (%s) after %.4g ns\n", name_of(out.ending), out.restitution.value_or(0),
              out.error_estimate <= 1e-8 ? "certain to 1e-8" : "uncertain", 1e9 * in_si(out.contact_duration));
  std::printf("lost at the edge %.4f, in the bulk %.4f of the kinetic energy\n", out.crack_loss, out.bulk_loss);
}
// [program]
