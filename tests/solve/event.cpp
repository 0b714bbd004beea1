#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

BOOST_AUTO_TEST_CASE(an_event_is_located_to_round_off_on_the_side_before_it) {
  const auto value = [](double t) { return std::cos(t); };
  const double h = 2.0, found = locate_event(value, h, value(0), value(h));
  BOOST_TEST(std::abs(found - pi<double>() / 2) < 4 * std::numeric_limits<double>::epsilon() * h);
  BOOST_TEST(value(found) >= -1e-15);
}

BOOST_AUTO_TEST_CASE(events_exist_only_for_the_laws_present) {
  scenes source(71);
  const scene s = source.next();
  const auto check = [&](const auto& model, bool zero_force, bool joints) {
    const reduced_model<double, std::remove_cvref_t<decltype(model)>> numbers(model, model.scales_at(s.speed));
    const event_values<std::remove_const_t<decltype(numbers)>> events(numbers);
    auto x = numbers.touch(1.0);
    x[numbers.coordinate] *= 1.01;
    x[numbers.coordinate] += 0.01;
    BOOST_TEST(events.value(event::turning, x, 0, true) == 1);
    BOOST_TEST(events.value(event::turning, x, 0, false) == -1);
    BOOST_TEST(events.value(event::letting_go, x, 0, true) > 0);
    BOOST_TEST((events.value(event::zero_force, x, 0, true) != 1) == zero_force);
    BOOST_TEST((events.value(event::leaving_above, x, 0, true) != 1) == joints);
    BOOST_TEST(events.value(event::leaving_below, x, 0, true) == 1); // the lowest piece has no lower joint
  };
  check(hertzian(s), false, false);
  check(viscous_hertz(s), true, false);
  check(viscous_hertz(s, end_at_zero_overlap{}), false, false);
  check(static_jkr(s), false, false);
  check(viscous_jkr(s), false, false);
  check(viscoelastic_jkr(s), false, true);
  check(viscoelastic_jkr_fit(s), false, true);
}

BOOST_AUTO_TEST_CASE(the_zero_force_of_a_weakly_damped_contact_is_not_stepped_over) {
  // Next to zero overlap the force changes sign twice within one step: it was once missed there, e off by 1e-6.
  scenes source(72);
  const scene s = source.next();
  for (const double A : {1e-4, 1e-3, 1e-2}) {
    scene weak = s;
    weak.bulk_time = s.bulk_time * A;
    const auto force_end = integrate(viscous_hertz(weak), impact{weak.speed}, {.tolerance = 1e-6});
    const double exact = reference_restitution(viscous_hertz(weak), weak.speed);
    BOOST_TEST(std::abs(*force_end.restitution - exact) < 1e-7); // a tenth of the tolerance
  }
}
