#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {
template <class Model>
auto numbers_of(const Model& model, speed v) {
  return reduced_model<double, Model>(model, model.scales_at(v));
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
  s.tsuji_coefficient = 2;
  BOOST_TEST(!captured_at_rest(tsuji_hertz(s, end_at_zero_overlap{})));
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
      if (captured.may_creep(rate, has_turned, books))
        return step;
    return 0;
  };
  BOOST_TEST(first_look(1e-4, false) == 401);
  BOOST_TEST(first_look(0.5, true) == 401);
  BOOST_TEST(first_look(0.5, false) == 0); // still on its way in
}
