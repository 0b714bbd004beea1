#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

using namespace support;

namespace {
template <class Model>
constexpr bool is_solved = closed_form::solved<std::remove_cvref_t<Model>>;

/// The closed outcome against the integration: ending and restitution.
template <class Compose>
void agrees(const Compose& compose_scene) {
  scenes source(101);
  for (int i = 0; i < 30; ++i) {
    scene s = source.next();
    if (i % 5 == 4)
      s.speed *= 0.5;
    const auto model = compose_scene(s);
    static_assert(is_solved<decltype(model)>);
    const auto closed = closed_form::solve(model, s.speed).value();
    const auto solved = integrate(model, impact{s.speed}, {.tolerance = 1e-11});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(name_of(closed.ending) == name_of(solved.ending));
      BOOST_TEST(std::abs(closed.restitution.value_or(0) - solved.restitution.value_or(0)) <=
                 solved.error_estimate + closed.error_estimate);
    }
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(closed_outcomes_are_those_of_the_integration) {
  agrees([](const scene& s) { return hertzian(s); });
  agrees([](const scene& s) { return static_jkr(s); });
  agrees([](const scene& s) { return hertzian(s, dmt{s.work_of_adhesion}); });
  agrees([](const scene& s) { return hunt_crossley_hertz(s); });
  agrees([](const scene& s) { return viscous_hertz(s); });
  agrees([](const scene& s) { return viscous_hertz(s, end_at_zero_overlap{}); });
  agrees([](const scene& s) { return tsuji_hertz(s); });
}

BOOST_AUTO_TEST_CASE(hertzian_duration_is_that_of_the_integration) {
  scenes source(103);
  const scene s = source.next();
  const auto model = hertzian(s, contact_duration{});
  const auto closed = collide(model, impact{s.speed});
  const auto solved = integrate(model, impact{s.speed}, {.tolerance = 1e-11});
  BOOST_TEST(closed.evaluations == 0);
  BOOST_TEST(double(closed.contact_duration / solved.contact_duration) == 1, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(only_what_a_closed_form_can_answer_is_solved_by_it) {
  scenes source(102);
  const scene s = source.next();
  static_assert(is_solved<decltype(hertzian(s))>);
  static_assert(is_solved<decltype(tsuji_hertz(s, end_at_zero_overlap{}))>);
  static_assert(!is_solved<decltype(hertzian(s, energy_ledger{}))>);
  static_assert(is_solved<decltype(hertzian(s, contact_duration{}))>);
  static_assert(!is_solved<decltype(static_jkr(s, contact_duration{}))>);
  static_assert(!is_solved<decltype(hertzian(s, extremes{}))>);
  static_assert(!is_solved<decltype(hertzian(s, trajectory{}))>);
  static_assert(is_solved<decltype(viscous_hertz(s))>);
  static_assert(!is_solved<decltype(viscous_hertz(s, contact_duration{}))>);
  static_assert(!is_solved<decltype(viscous_jkr(s))>);
  static_assert(!is_solved<decltype(viscoelastic_jkr(s))>);
  // Overdamped, to zero overlap: captured without any work.
  scene overdamped = s;
  overdamped.tsuji_coefficient = 3;
  const auto stuck = collide(tsuji_hertz(overdamped, end_at_zero_overlap{}), impact{s.speed});
  BOOST_TEST(name_of(stuck.ending) == "captured");
  BOOST_TEST(stuck.evaluations == 0);
}
