// 06 Your own loop (builds on 04): the equations as an ordinary odeint System, in metres and seconds.
//
// Whoever wants another integrator, other events or another end of contact takes physical_system and any odeint loop.
// In time, the edge's speed is unbounded at both ends of the contact: the loop has to choose its first and longest
// step, to reject states outside the equations' domain and to say when to stop, and it knows nothing of its error.
//
// Try next: another stepper; stop later (a smaller `left`) and watch e approach that of collide().
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/physical_system.hpp>

#include <cmath>
#include <cstdio>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const duration relaxation_time = 1e-11 * seconds;
  const double k = 0.02;
  const auto model =
      compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = work_of_adhesion(grain.solid, grain.solid)},
              greenwood{.relaxation_time = relaxation_time, .modulus_ratio = k, .interaction_range = 0.3 * nanometres},
              kuwabara_kono{.bulk_time = bulk_time_of_krijt(relaxation_time, 0.25)});
  const speed v = 8.0 * metres_per_second;

  // [loop]
  namespace odeint = boost::numeric::odeint;
  const physical_system system(model);
  auto x = system.touch(v);
  double t = 0, dt = 1e-18, longest = 1e-11;
  const double left = 1e-4; // the edge lets go at beta = (1 - left)/k, past the fold
  long steps = 0;
  auto stepper = odeint::make_controlled(1e-18, 1e-9, odeint::runge_kutta_dopri5<decltype(x)>());
  while (!(system.past_fold(x) && system.energy_release_ratio(x) >= (1 - left) / k)) {
    auto next = x;
    double t_next = t, step = std::min(dt, longest);
    const bool accepted = stepper.try_step(system, next, t_next, step) == odeint::success;
    const bool outside = !(next[contact_radius] > 0) || system.energy_release_ratio(next) >= 1 / k ||
                         !std::isfinite(next[approach_rate]);
    dt = outside ? std::min(dt, longest) / 4 : step;
    if (accepted && !outside) {
      x = next;
      t = t_next;
    }
    ++steps;
  }
  const double e = -x[approach_rate] / in_si(v);
  // [loop]

  const auto out = collide(model, impact{.speed = v}, {.tolerance = 1e-10});
  std::printf("own loop  e = %.9f in %ld steps\ncollide() e = %.9f +- %.0e in %ld evaluations\n", e, steps,
              *out.restitution, out.error_estimate, out.evaluations);
  return std::abs(e - *out.restitution) < 1e-6 ? 0 : 1;
}
