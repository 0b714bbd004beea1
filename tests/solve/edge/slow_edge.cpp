#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/solve/edge/slow_edge.hpp>

using namespace support;

namespace {
const ice_case ice;
}

BOOST_AUTO_TEST_CASE(edges_slower_than_the_collision_are_captured_soon) {
  // T_vis = 70 contact times once took 4e4 evaluations at 1e-6 and 3e6 at 1e-10.
  for (const double T : {1e-8, 1e-7, 1e-6})
    for (const double tolerance : {1e-6, 1e-10}) {
      const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T * seconds), energy_ledger{});
      const auto out = collide(model, impact{2.0 * metres_per_second}, {.tolerance = tolerance});
      BOOST_TEST_CONTEXT("T_vis = " << T << ", tolerance " << tolerance) {
        BOOST_TEST(name_of(out.ending) == "captured");
        BOOST_TEST(out.ending_is_certain);
        BOOST_TEST(std::abs(out.ledger_residual) <= 2 * tolerance);
        BOOST_TEST(out.evaluations < (tolerance > 1e-8 ? 10'000 : 150'000));
      }
    }
}

BOOST_AUTO_TEST_CASE(no_bound_pair_that_the_proof_holds_lets_go) {
  // Where the proof says that a pair stays, the long way round says so too: the energy falls below that of bodies
  // apart.
  for (const double T : {3e-9, 1e-8})
    for (const double v : {2., 3., 4.}) {
      const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T * seconds));
      const scales unit = scales_at(model, v * metres_per_second);
      using reduced_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
      const reduced_type numbers(model, unit);
      flow<reduced_type> f{numbers};
      stepper::tsitouras_papakostas75::method<flow<reduced_type>> method(1e-8, numbers.typical());
      const slow_edge<reduced_type> edge(numbers);
      auto x = numbers.touch(reduce<double>(v * metres_per_second, unit));
      bool held = false;
      double h = 1e-3, energy = 1;
      for (int i = 0; i < 100'000 && energy > 0; ++i) {
        const auto tried = method.try_step(f, x, std::min(h, 0.02));
        h = tried.next;
        if (!tried.accepted)
          continue;
        x = tried.x;
        method.moved();
        f.piece = numbers.root_ratio(x) > 1 ? 1 : 0;
        const auto c = numbers.at(x, f.piece).c;
        energy = numbers.kinetic_energy(c.rate) + numbers.potential(c);
        held |= x[approach_rate] < 0 && edge.reserve(c, energy).has_value();
        if (held)
          BOOST_TEST(value_of(c.radius) > value_of(numbers.adhesion.fold_radius(numbers.pair)));
      }
      BOOST_TEST_CONTEXT("T_vis = " << T << ", v = " << v) {
        BOOST_TEST(energy < 0);
        BOOST_TEST_MESSAGE("held: " << held);
      }
    }
}

BOOST_AUTO_TEST_CASE(fast_edges_and_fast_bodies_are_not_held) {
  const auto reserve = [](double T, double v) {
    const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T * seconds));
    const scales unit = scales_at(model, v * metres_per_second);
    const reduced_model<double, std::remove_const_t<decltype(model)>> numbers(model, unit);
    auto x = numbers.touch(1.0);
    x[numbers.coordinate] = std::sqrt(4 * numbers.adhesion.fold_radius(numbers.pair));
    const auto c = numbers.at(x, 0).c;
    return slow_edge(numbers).reserve(c, numbers.kinetic_energy(reduce<double>(v * metres_per_second, unit)));
  };
  BOOST_TEST(reserve(1e-6, 2).has_value());
  BOOST_TEST(!reserve(1e-12, 2).has_value());
  BOOST_TEST(!reserve(1e-6, 100).has_value());
}
