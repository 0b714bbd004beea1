#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/closed_form/linear.hpp>
#include <ricochet/law/adhesion/line_force.hpp>

using namespace support;

namespace {
template <class Model>
auto numbers_of(const Model& model, speed v) {
  return reduced_model<double, Model>(model, scales_at(model, v));
}
} // namespace

BOOST_AUTO_TEST_CASE(an_adhesive_contact_is_captured_by_its_energy) {
  scenes source(81);
  const scene s = source.next();
  const auto numbers = numbers_of(static_jkr(s), s.speed);
  ledger<std::remove_const_t<decltype(numbers)>> books(numbers);
  capture<std::remove_const_t<decltype(numbers)>> captured(numbers);
  auto x = numbers.touch(0.0);
  const double potential = numbers.potential(numbers.at(x, 0).c); // at touch, less than at the fold
  BOOST_TEST(potential < numbers.exit_energy());
  const double least = std::sqrt(2 * (numbers.exit_energy() - potential) / numbers.pair.reduced_mass);
  for (const double rate : {0.999 * least, 1.001 * least, -0.999 * least, -1.001 * least}) {
    x[approach_rate] = rate;
    captured.look(numbers.at(x, 0).c, books);
    BOOST_TEST(captured.certain() == (std::abs(rate) < least));
  }
}

BOOST_AUTO_TEST_CASE(without_adhesion_only_an_overdamped_contact_pulled_to_zero_overlap_is_captured) {
  scenes source(82);
  scene s = source.next();
  const auto captured_at_rest = [&](const auto& model) {
    const auto numbers = numbers_of(model, s.speed);
    ledger<std::remove_const_t<decltype(numbers)>> books(numbers);
    capture<std::remove_const_t<decltype(numbers)>> captured(numbers);
    auto x = numbers.touch(0.0);
    x[numbers.coordinate] = 0.1;
    captured.look(numbers.at(x, 0).c, books);
    return captured.certain();
  };
  BOOST_TEST(!captured_at_rest(hertzian(s)));
  s.tsuji_coefficient = 3; // sqrt 5 is critical
  BOOST_TEST(!captured_at_rest(tsuji_hertz(s)));
  BOOST_TEST(captured_at_rest(tsuji_hertz(s, end_at_zero_overlap{})));
  const tsuji strong{s.tsuji_coefficient};
  BOOST_TEST(captured_at_rest(hertzian(s, jkr{}, strong))); // a work of adhesion of zero, which pulls to zero overlap
  BOOST_TEST(captured_at_rest(hertzian(s, dmt{}, strong)));
  BOOST_TEST(captured_at_rest(hertzian(s, line_force{}, strong)));
  s.tsuji_coefficient = 2;
  BOOST_TEST(!captured_at_rest(tsuji_hertz(s, end_at_zero_overlap{})));
  // A spring outgrows Tsuji's damping as the overlap vanishes: never certain, however large the coefficient.
  const linear spring{40.0 * newtons_per_metre};
  BOOST_TEST(!captured_at_rest(compose(s.pair, spring, tsuji{1e3}, end_at_zero_overlap{})));
  for (const double ratio : {0.99, 1., 3.}) {
    const linear_dashpot dashpot{closed_form::damping_coefficient_of(ratio, s.pair, spring)};
    BOOST_TEST(captured_at_rest(compose(s.pair, spring, dashpot, end_at_zero_overlap{})) == (ratio >= 1));
    BOOST_TEST(!captured_at_rest(compose(s.pair, spring, dashpot)));
  }
}

BOOST_AUTO_TEST_CASE(a_dashpot_captures_a_hertzian_contact_that_creeps_to_zero_overlap) {
  scenes source(84);
  const scene s = source.next();
  const scales unit = scales_of(s.pair, s.speed, energy_per_area{});
  // Near zero overlap any dashpot outweighs Hertz's stiffness; a weak one lets a fast rebound pass all the same.
  for (const double coefficient : {0.2, 2., 20.}) {
    const linear_dashpot dashpot{coefficient * unit.mass / unit.duration * units::newtons / units::metres_per_second};
    const auto out = collide(compose(s.pair, hertz{}, dashpot, end_at_zero_overlap{}), impact{s.speed});
    BOOST_TEST(name_of(out.ending) == (coefficient < 1 ? "separated" : "captured"));
    BOOST_TEST(out.ending_is_certain);
  }
}

BOOST_AUTO_TEST_CASE(a_slow_contact_that_does_not_turn_is_looked_at_after_many_steps) {
  scenes source(83);
  const scene s = source.next();
  const auto numbers = numbers_of(viscous_jkr(s), s.speed);
  ledger<std::remove_const_t<decltype(numbers)>> books(numbers);
  books.impact(1.0);
  capture<std::remove_const_t<decltype(numbers)>> captured(numbers);
  const auto first_look = [&](double rate, bool has_turned) {
    captured.look(numbers.at(numbers.touch(rate), 0).c, books);
    for (int step = 1; step <= 1000; ++step)
      if (captured.is_late(rate, has_turned, books))
        return step;
    return 0;
  };
  BOOST_TEST(first_look(1e-4, false) == 401);
  BOOST_TEST(first_look(0.5, true) == 401);
  BOOST_TEST(first_look(0.5, false) == 800); // still on its way in
}
