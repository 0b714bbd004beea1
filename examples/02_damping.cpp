// 02 Damping (builds on 01): a viscous bulk, and where its contact ends.
//
// A contact without adhesion cannot pull, so it ends where the force vanishes, before the overlap does; many published
// constants let it pull until the overlap is gone. The difference grows with the damping. The ledger says what was
// lost.
//
// Try next: hunt_crossley{...} or tsuji{...} in place of kuwabara_kono{...}.
#include <ricochet/collide.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere bead{.solid = materials::acrylic, .radius = 2.0 * millimetres};
  const contact_pair pair = between(bead, bead);
  bool closed = true;
  std::printf("%12s %18s %18s %12s\n", "A (us)", "e to zero force", "e to zero overlap", "bulk loss");
  for (const double microseconds : {0.1, 1.0, 3.0, 10.0}) {
    const kuwabara_kono viscous{.bulk_time = 1e-6 * microseconds * seconds};
    const impact gentle{.speed = 0.3 * metres_per_second};
    const auto out = collide(compose(pair, hertz{}, viscous, energy_ledger{}), gentle);
    const auto pulling = collide(compose(pair, hertz{}, viscous, end_at_zero_overlap{}), gentle);
    std::printf("%12g %18.10f %18.10f %12.8f\n", microseconds, *out.restitution, *pulling.restitution, out.bulk_loss);
    closed = closed && std::abs(1 - *out.restitution * *out.restitution - out.bulk_loss) < 1e-7;
  }
  return closed ? 0 : 1;
}
