#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {
template <class Model>
reduced_model<double, Model> reduced_form(const Model& model) {
  return {model, scales_at(model, 1.0 * metres_per_second)};
}
} // namespace

BOOST_AUTO_TEST_CASE(flow_alone_brings_members) {
  const scene s = scenes(31).next();
  const auto bare = reduced_form(hertzian(s));
  const auto flowing = reduced_form(yielding_hertz(s));
  BOOST_TEST(sizeof(flowing) == sizeof(bare) + 2 * sizeof(double)); // strength and coordinate of first yield
  using part = decltype(bare)::part;
  static_assert(std::same_as<part, configuration<reduced<double>>>);
  static_assert(std::same_as<decltype(flowing)::part, flattened_configuration<reduced<double>>>);
}

BOOST_AUTO_TEST_CASE(before_it_yields_a_contact_is_that_of_the_round_bodies) {
  scenes source(32);
  for (int i = 0; i < 100; ++i) {
    const scene s = source.next();
    const auto round = reduced_form(viscous_jkr(s));
    const auto flowing = reduced_form(viscous_yielding_jkr(s));
    auto x = round.touch(1);
    auto y = flowing.touch(1);
    BOOST_TEST(x[root_contact_radius] == y[root_contact_radius]);
    for (const double part : {0., 0.3, 1.}) {
      y[root_contact_radius] = x[root_contact_radius] =
          (1 - part) * x[root_contact_radius] + part * y[largest_coordinate];
      const auto expected = round.at(x, 0);
      const auto found = flowing.at(y, 0);
      const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-14 * std::abs(b); };
      BOOST_TEST(found.c.shape.residual_approach == 0);
      BOOST_TEST(std::abs(flowing.whole_approach(found.c) - round.whole_approach(expected.c)) <
                 1e-14 * found.c.radius * found.c.radius / round.pair.reduced_radius);
      BOOST_TEST(same(found.clock, expected.clock));
      BOOST_TEST(same(flowing.exit_energy(found.c), round.exit_energy(expected.c)));
      BOOST_TEST(same(flowing.exit_energy(), round.exit_energy()));
      BOOST_TEST(&round.pair_of(expected.c) == &round.pair);
    }
  }
}

BOOST_AUTO_TEST_CASE(flow_and_rest_have_the_same_contact_at_its_largest) {
  scenes source(33);
  for (int i = 0; i < 100; ++i) {
    const auto numbers = reduced_form(viscous_yielding_jkr(source.next()));
    auto x = numbers.touch(1);
    x[root_contact_radius] = x[largest_coordinate] *= source.log_uniform(1, 5);
    const auto resting = numbers.at(x, 0).c, flowing = numbers.at(x, 1).c;
    BOOST_TEST(resting.approach == flowing.approach);
    BOOST_TEST(numbers.total_force(resting) == numbers.total_force(flowing));
    BOOST_TEST(numbers.potential(resting) == numbers.potential(flowing));
    // While it flows, the bodies approach as round ones do.
    const double a = resting.radius, R = numbers.pair.reduced_radius;
    const double expected = a * a / R - numbers.adhesion.flattening(numbers.pair) * std::sqrt(a);
    BOOST_TEST(std::abs(numbers.whole_approach(flowing) - expected) < 1e-14 * a * a / R);
    BOOST_TEST(numbers.at(x, 1).clock > numbers.at(x, 0).clock * (1 - 1e-14));
    BOOST_TEST(numbers.exit_energy(resting) >= numbers.exit_energy() * (1 - 1e-14));
  }
}
