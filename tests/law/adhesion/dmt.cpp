#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/number/autodiff.hpp>

using namespace support;

BOOST_AUTO_TEST_CASE(the_attraction_is_the_pull_off_force_and_derives_from_its_potential) {
  using S = reduced<dual<>>;
  const basic_pair<S> pair{dual<>(2), dual<>(3), dual<>(1)};
  const dmt_law<S> law{dual<>(0.7)};
  for (const double approach : {0.01, 0.1, 1.}) {
    const dual<> delta = seeded(approach);
    const configuration<S> c{delta, dual<>(0), sqrt(delta * pair.reduced_radius), dual<>(0)};
    BOOST_TEST(value_of(law.attraction(pair, c)) == 2 * pi<double>() * 0.7 * 3, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(law.potential_energy(pair, c).derivative(1) == -value_of(law.attraction(pair, c)),
               boost::test_tools::tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_CASE(undamped_impacts_lose_nothing_and_go_deeper) {
  scenes source(93);
  for (int i = 0; i < 20; ++i) {
    const scene s = source.next();
    const auto out =
        collide(compose(s.pair, hertz{}, dmt{s.work_of_adhesion}, extremes{}), impact{s.speed}, {.tolerance = 1e-10});
    BOOST_TEST(std::abs(*out.restitution - 1) < 1e-10);
    // (8/15) E* sqrt(R) delta^{5/2} - 2 pi w R delta = m* v^2/2
    const double E = in_si(s.pair.reduced_modulus), R = in_si(s.pair.reduced_radius), depth = in_si(out.max_approach);
    const double elastic = 8. / 15 * E * std::sqrt(R) * std::pow(depth, 2.5);
    const double taken = 2 * pi<double>() * in_si(s.work_of_adhesion) * R * depth;
    const double kinetic = in_si(s.pair.reduced_mass) * square(in_si(s.speed)) / 2;
    BOOST_TEST(std::abs(elastic - taken - kinetic) < 1e-9 * elastic);
  }
}

BOOST_AUTO_TEST_CASE(damped_impacts_stick_below_a_speed) {
  scenes source(94);
  const scene s = source.next();
  const auto model = compose(s.pair, hertz{}, dmt{s.work_of_adhesion}, kuwabara_kono{s.bulk_time}, energy_ledger{});
  const auto fast = collide(model, impact{s.speed}, {.tolerance = 1e-9});
  const auto slow = collide(model, impact{s.speed * 1e-4}, {.tolerance = 1e-9});
  BOOST_TEST(name_of(fast.ending) == "separated");
  BOOST_TEST(name_of(slow.ending) == "captured");
  for (const auto& out : {fast, slow})
    BOOST_TEST(std::abs(out.ledger_residual) < 1e-8);
}
