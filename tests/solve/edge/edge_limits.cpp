#include <boost/test/unit_test.hpp>

#include <ricochet/solve/edge/edge_limits.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {
/// A ball large against the cohesive zone, some times faster than it sticks: its edge runs at the limits of the law.
struct large_ball {
  contact_pair pair = between(sphere{materials::polystyrene_latex, 2 * millimetres}, flat_wall{materials::quartz});
  double modulus_ratio = 0.1;
  energy_per_area work = 0.2 * joules_per_square_metre;
  speed v = 0.05 * metres_per_second;
  duration relaxation_time = 1e-3 * seconds;

  greenwood edge() const {
    return {.relaxation_time = relaxation_time, .modulus_ratio = modulus_ratio, .interaction_range = 0.4 * nanometres};
  }
  template <class... Also>
  auto model(Also... also) const {
    return compose(pair, hertz{}, jkr{work}, edge(), also...);
  }
};

template <class Model>
reduced_model<double, Model> numbers_of(const Model& model, speed v) {
  return {model, scales_at(model, v)};
}
/// Closing with k w and opening with w/k, as two contacts without a crack law: the approach of the one ends with the
/// radius at which the other's rebound starts. Touch happens 1 % above the limit, of no consequence at this speed.
double restitution_at_limits(const large_ball& ball) {
  const double k = ball.modulus_ratio, m = in_si(ball.pair.reduced_mass);
  const jkr closing{k * ball.work}, opening{ball.work / k};
  const auto deepest =
      integrate(compose(ball.pair, hertz{}, closing, extremes{}), impact{ball.v}, {.tolerance = 1e-11});
  const auto static_closing = numbers_of(compose(ball.pair, hertz{}, closing), ball.v);
  const scales unit = scales_at(compose(ball.pair, hertz{}, closing), ball.v);
  const double joule = unit.factor(energy{});
  const double area = pi<double>() * square(in_si(deepest.max_contact_radius));
  const double at_touch = joule * static_closing.potential(static_closing.contact(static_closing.touch(1.0), 0));
  const double kinetic = m * square(in_si(ball.v)) / 2;
  const double left = kinetic + at_touch - in_si(opening.work_of_adhesion - closing.work_of_adhesion) * area -
                      in_si(opening.exit_energy(ball.pair));
  return std::sqrt(left / kinetic);
}
} // namespace

BOOST_AUTO_TEST_CASE(a_slow_edge_takes_what_jkr_would_with_the_limits_of_its_work) {
  large_ball ball;
  const double by_limits = restitution_at_limits(ball);
  const auto out = integrate(ball.model(), impact{ball.v}, {.tolerance = 1e-9});
  BOOST_TEST_REQUIRE(out.restitution.has_value());
  BOOST_TEST_MESSAGE("e " << *out.restitution << " by limits " << by_limits << ", " << out.evaluations
                          << " evaluations");
  BOOST_TEST(out.error_estimate <= 1e-9);
  BOOST_TEST(*out.restitution < 0.95); // the edge matters
  BOOST_TEST(std::abs(*out.restitution - by_limits) < 1e-4);
  // The slower the edge, the closer.
  double last = 1;
  for (const double slower : {1e2, 1e4}) {
    large_ball still = ball;
    still.relaxation_time *= slower;
    const auto slow = integrate(still.model(), impact{ball.v}, {.tolerance = 1e-7});
    const double deviation = std::abs(slow.restitution.value() - by_limits);
    BOOST_TEST_MESSAGE("T_vis " << in_si(still.relaxation_time) << " s: differs by " << deviation << ", "
                                << slow.evaluations << " evaluations");
    BOOST_TEST(deviation <= last);
    BOOST_TEST(slow.evaluations < 100'000);
    last = deviation;
  }
}

BOOST_AUTO_TEST_CASE(an_edge_is_held_only_where_the_bodies_drive_it) {
  // The contact's energy is 3e5 times that of its edge, whose ratio a solution hardly resolves: errors once led it to
  // the limit of a closing edge though the law took it back, and there it stayed on the rebound.
  const material ball_of{.youngs_modulus = 23.5 * megapascals,
                         .poissons_ratio = 0.28,
                         .mass_density = 7320.0 * kilograms_per_cubic_metre};
  const material wall_of{.youngs_modulus = 514.0 * gigapascals,
                         .poissons_ratio = 0.0,
                         .mass_density = 10900.0 * kilograms_per_cubic_metre};
  const large_ball ball{.pair = between(sphere{ball_of, 140.0 * micrometres}, flat_wall{wall_of}),
                        .modulus_ratio = 0.05,
                        .work = 8.4e-3 * joules_per_square_metre,
                        .v = 634.0 * metres_per_second,
                        .relaxation_time = 2.76e-4 * seconds};
  const double loss = 1 - restitution_at_limits(ball);
  for (const double tolerance : {1e-7, 3e-8, 9e-9, 1e-9}) {
    const auto out = integrate(ball.model(), impact{ball.v}, {.tolerance = tolerance});
    BOOST_TEST_CONTEXT("tolerance " << tolerance) {
      BOOST_TEST_REQUIRE(name_of(out.ending) == "separated");
      BOOST_TEST(out.error_estimate <= tolerance);
      BOOST_TEST(std::abs(1 - *out.restitution - loss) < 0.02 * loss + tolerance);
      BOOST_TEST(out.evaluations < 100'000);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_held_is_within_the_estimate) {
  scenes random(12);
  for (int i = 0; i < 12; ++i) {
    large_ball ball;
    ball.modulus_ratio = std::array{0.02, 0.1, 0.5, 0.9}[std::size_t(i) % 4];
    ball.relaxation_time = random.log_uniform(1e-7, 1) * seconds;
    ball.v = random.log_uniform(0.02, 1) * metres_per_second;
    const auto model = ball.model(kuwabara_kono{1e-8 * seconds}, energy_ledger{});
    const auto fine = integrate(model, impact{ball.v}, {.tolerance = 1e-10});
    const auto rough = integrate(model, impact{ball.v}, {.tolerance = 1e-5});
    BOOST_TEST_CONTEXT("k " << ball.modulus_ratio << ", T_vis " << in_si(ball.relaxation_time) << " s, v "
                            << in_si(ball.v) << " m/s") {
      BOOST_TEST(name_of(fine.ending) == name_of(rough.ending));
      BOOST_TEST(std::abs(fine.restitution.value_or(0) - rough.restitution.value_or(0)) <=
                 fine.error_estimate + rough.error_estimate);
      BOOST_TEST((fine.error_estimate <= 1e-10 && rough.error_estimate <= 1e-5));
      BOOST_TEST((std::abs(fine.ledger_residual) < 1e-9 && std::abs(rough.ledger_residual) < 1e-5));
    }
  }
}

BOOST_AUTO_TEST_CASE(there_are_no_limits_unless_an_error_is_allowed) {
  const large_ball ball;
  const auto numbers = numbers_of(ball.model(), ball.v);
  edge_limits limits(numbers);
  using limits_type = decltype(limits);
  const auto x = numbers.touch(1.0);
  BOOST_TEST(limits.above_lower(x) == 1);
  BOOST_TEST(limits.below_upper(x, 1) == 1);
  limits.allow(numbers.kinetic_energy(1.0), 1e-4);
  BOOST_TEST((limits.above_lower(x) > 0 && limits.above_lower(x) < 0.01)); // touch is 1 % above the limit
  BOOST_TEST(limits.below_upper(x, 1) > 1);
  // Bodies that approach drive a closing edge, those that separate an opening one.
  auto back = x;
  back[approach_rate] = -1;
  BOOST_TEST((limits.driven(x, limits_type::closing) > 0 && limits.driven(back, limits_type::closing) < 0));
  BOOST_TEST((limits.driven(back, limits_type::opening) > 0 && limits.driven(x, limits_type::opening) < 0));
  // Let go of, sqrt(beta) is in every digit that of the limit.
  auto drifted = x;
  drifted[decltype(numbers)::coordinate] *= 1 + 1e-4;
  limits.release(drifted, limits_type::closing);
  BOOST_TEST(std::abs(limits.above_lower(drifted)) < 1e-15);
  BOOST_TEST(
      (limits_type::beyond(0, false) == limits_type::closing && limits_type::beyond(1, true) == limits_type::opening));
  BOOST_TEST(
      (limits_type::beyond(limits_type::closing, true) == 0 && limits_type::beyond(limits_type::opening, false) == 1));
  BOOST_TEST(!limits_type::beyond(0, true));
  // An error so small that round-off decides: none.
  limits_type none(numbers);
  none.allow(numbers.kinetic_energy(1.0), 1e-30);
  BOOST_TEST(none.above_lower(x) == 1);
}
