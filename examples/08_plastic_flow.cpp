// 08 Plastic flow (builds on 03): spheres that yield while adhesion pulls at them.
//
// thornton_ning adds what plastic flow alone would take to the losses of an elastic motion, as Krijt 2013 (30) does;
// thornton_ning_contact lets the contact flow within the motion and unload as the flatter one that it has become. The
// table says when adding is good enough: where JKR's sticking speed is a tenth of the yield speed or less, e comes out
// within 0.01, never too small; near the yield speed of spheres that stick more, it is of no use.
//
// Try next: add kuwabara_kono{...} to both; a strength below 111 MPa, that of a contact which yields while
// adhesion draws it together, is refused.
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const contact_pair pair = between(grain, grain);
  bool books_close = true, added_is_larger = true;
  for (const double w : {0.0, 0.1, 0.74}) {
    // [plastic flow]
    const jkr adhesion{.work_of_adhesion = w * joules_per_square_metre};
    const modulus strength = 200.0 * megapascals;
    const auto within = compose(pair, hertz{}, adhesion, thornton_ning_contact{.yield_strength = strength},
                                energy_ledger{}); // plastic flow within the motion
    const auto added = compose(pair, hertz{}, adhesion, thornton_ning{.yield_strength = strength}); // Krijt 2013 (30)
    // [plastic flow]

    std::printf("w = %g J/m^2: sticking speed without flow %.3f, yield speed without adhesion %.3f m/s\n", w,
                w > 0 ? in_si(closed_form::sticking_speed(pair, adhesion.work_of_adhesion)) : 0,
                in_si(closed_form::yield_speed(pair, strength)));
    std::printf("    v (m/s)   e       e by (30)   plastic   adhesive loss   residual approach (nm)\n");
    for (const double v : {2.0, 4.0, 8.0, 32.0, 128.0}) {
      const impact at{.speed = v * metres_per_second};
      const auto out = collide(within, at);
      const double e = out.restitution.value_or(0), e_added = collide(added, at).restitution.value_or(0);
      std::printf("%9g   %.5f   %.5f   %8.5f   %11.5f   %15.3f\n", v, e, e_added, out.plastic_loss, out.crack_loss,
                  1e9 * in_si(out.residual_approach));
      books_close &= std::abs(out.ledger_residual) < 1e-7;
      added_is_larger &= e_added > e - 1e-7;
    }
  }
  return books_close && added_is_larger ? 0 : 1;
}
