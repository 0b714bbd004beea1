// 04 Crack law (builds on 02 and 03): the contact edge needs time to heal and to open.
//
// The contact radius becomes an unknown of its own. Much more energy is lost than by adhesion and viscosity each for
// itself, and the spheres stick up to more than twice the speed. The exact law takes any modulus ratio k; the published
// fits hold for k = 0.02.
//
// Try next: another relaxation time (0 gives JKR back), another k, and trajectory{} to see the motion.
#include <ricochet/closed_form/independent_losses.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/regime.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const contact_pair pair = between(grain, grain);
  const jkr adhesive{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)};
  const duration relaxation_time = 1e-11 * seconds;
  const kuwabara_kono viscous{.bulk_time = bulk_time_of_krijt(relaxation_time, grain.solid.poissons_ratio)};
  const speed v = 8.0 * metres_per_second;

  const auto exact = compose(
      pair, hertz{}, adhesive, viscous,
      greenwood{.relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres});
  const auto fitted = compose(pair, hertz{}, adhesive, viscous,
                              greenwood_fit{.relaxation_time = relaxation_time, .interaction_range = 0.3 * nanometres});

  const auto show = [&](const char* law, const auto& model) {
    const auto out = collide(model, impact{.speed = v}, {.tolerance = 1e-10});
    const auto sticks = sticking_speed(model, 0.1 * metres_per_second, 100.0 * metres_per_second);
    std::printf("%-15s e(8 m/s) = %.10f, sticks up to %.8f m/s\n", law, *out.restitution, in_si(sticks.value()));
    return *out.restitution;
  };
  show("greenwood", exact);
  const double e = show("greenwood_fit", fitted);
  std::printf("%-15s e(8 m/s) = %.4f\n", "losses added",
              *closed_form::independent_losses(pair, adhesive.work_of_adhesion, viscous.bulk_time, v));

  const auto regime = regime_of(exact, v, {}, grain.solid.poissons_ratio);
  std::printf(
      "Tabor number %.3g; %.3g times the JKR sticking speed; relaxation time over its quasi-static limits: bulk "
      "%.3g, edge %.3g\n",
      *regime.tabor_number, *regime.speed_over_capture, *regime.bulk_loss_scale, *regime.edge_loss_scale);
  for (const std::string& warning : regime.warnings()) // none here
    std::printf("warning: %s\n", warning.c_str());
  return std::abs(e - 0.656742881328) < 1e-9 ? 0 : 1;
}
