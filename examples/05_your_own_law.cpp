// 05 Your own law (builds on 02): a damping law that ricochet does not have, in 25 lines outside the library.
//
// It is one template over a number system S: written in Boost.Units quantities at the door, so that a wrong exponent
// does not compile, and in plain numbers in the loop. The concept of its role (law/damping/bulk_damping_law.hpp) says
// what it must offer.
//
// Try next: forget the square root in `coefficient` and read the compiler's first line.
#include <ricochet/collide.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <cstdio>

// [law]
/// Constant dashpot, smoothed in near touch: F_D = c (a/a0)/(1 + a/a0) d(delta)/dt.
template <class S>
struct dashpot_law {
  using role = ricochet::role::damping;
  using number = typename S::number;
  typename S::damping constant{};    ///< c, N s/m
  typename S::length touch_radius{}; ///< a0, m

  template <class Other>
  using in = dashpot_law<Other>;
  static constexpr auto parameters() {
    using ricochet::parameter;
    return std::tuple{parameter{"constant", &dashpot_law::constant, ricochet::non_negative},
                      parameter{"touch_radius", &dashpot_law::touch_radius, ricochet::positive}};
  }

  typename S::damping coefficient(const ricochet::basic_pair<S>&, const ricochet::configuration<S>& c) const {
    const number grown = c.radius / touch_radius;
    return constant * grown / (number(1) + grown);
  }
};
using dashpot = dashpot_law<ricochet::dimensional>;
// [law]

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere bead{.solid = materials::quartz, .radius = 1.0 * millimetres};
  double last = 1;
  for (const double c : {0.0, 0.01, 0.03, 0.1}) {
    const dashpot damper{.constant = c * newtons / metres_per_second, .touch_radius = 1.0 * micrometres};
    const auto out = collide(compose(between(bead, bead), hertz{}, damper, energy_ledger{}),
                             impact{.speed = 0.1 * metres_per_second});
    std::printf("c = %4g N s/m  e = %.9f +- %.0e  ledger closes to %.0e\n", c, *out.restitution, out.error_estimate,
                out.ledger_residual);
    if (*out.restitution > last)
      return 1;
    last = *out.restitution;
  }
  return last < 0.95 ? 0 : 1;
}
