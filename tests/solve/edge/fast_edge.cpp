#include <boost/test/unit_test.hpp>

#include <ricochet/solve/edge/fast_edge.hpp>

#include "support/random_scenes.hpp"

using namespace support;

// dy/dt = rate/(d delta/dy) of the static edge, against what the law says at that excess.
BOOST_AUTO_TEST_CASE(the_excess_is_that_of_an_edge_that_keeps_to_the_static_one) {
  scenes random(8);
  for (int i = 0; i < 20; ++i) {
    auto s = random.next();
    for (const double times : {1e-3, 1e-6, 1e-9}) {
      const auto model = viscous_jkr(s, greenwood{times * s.relaxation_time, s.modulus_ratio, s.interaction_range});
      const reduced_model<double, decltype(model)> numbers(model, scales_at(model, s.speed));
      const fast_edge edge(numbers);
      const fast_edge slower(reduced_model<double, decltype(model)>(
          viscous_jkr(s, greenwood{2 * times * s.relaxation_time, s.modulus_ratio, s.interaction_range, 1.01,
                                   model.crack.table}),
          scales_at(model, s.speed)));
      // Both grow with the relaxation time: in proportion, but for a logarithm, and as its power 2/3.
      BOOST_TEST((edge.excess() > 0 && edge.lag() > 0 && edge.least_clock() > 0));
      BOOST_TEST((slower.excess() / edge.excess() > 1.7 && slower.excess() / edge.excess() < 2));
      BOOST_TEST((slower.lag() / edge.lag() > 1.45 && slower.lag() / edge.lag() < 1.59));
      if (edge.excess() < 1e-3) {
        const auto law = numbers.crack.rate(std::sqrt(1 + edge.excess()), 1);
        const double speed = numbers.crack.speed_scale(numbers.pair, numbers.adhesion.work_of_adhesion) * -law.advance /
                             law.slowness; // da/dt
        const double a = numbers.adhesion.equilibrium_radius(numbers.pair);
        const double half_size = std::sqrt(std::sqrt(numbers.pair.reduced_radius)) / 2;
        BOOST_TEST(std::abs(speed / (2 * std::sqrt(a) * half_size) - 1) < 1e-4); // the iteration's own accuracy
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_loss_is_bounded_and_the_bound_is_no_more_than_twice_as_large) {
  scenes random(3);
  for (int i = 0; i < 6; ++i) {
    const auto s = random.next();
    const auto table = std::make_shared<const greenwood_table>(s.modulus_ratio);
    for (const double times : {1e-6, 1e-8, 1e-10}) {
      const auto model =
          static_jkr(s, greenwood{times * s.relaxation_time, s.modulus_ratio, s.interaction_range, 1.01, table});
      const scales unit = scales_at(model, s.speed);
      const reduced_model<double, decltype(model)> numbers(model, unit);
      const fast_edge edge(numbers);
      if (edge.lag() > 1e-3) // as collide() asks for
        continue;
      const double kinetic = numbers.kinetic_energy(reduce<double>(s.speed, unit));
      const double e = *integrate(model, impact{s.speed}, {.tolerance = 1e-12}).restitution;
      const double of_static = *integrate(model.with_static_edge(), impact{s.speed}, {.tolerance = 1e-12}).restitution;
      const double taken = (of_static - e) * (of_static + e), bound = edge.loss(numbers) / kinetic;
      BOOST_TEST_MESSAGE("lag " << edge.lag() << ": takes " << taken / bound << " of the bound");
      BOOST_TEST(taken < bound);
      BOOST_TEST(taken > 0.5 * bound);
    }
  }
}
