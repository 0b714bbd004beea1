#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>

using namespace support;

namespace {

const contact_pair on_wall = between(sphere{materials::quartz, 5 * micrometres}, flat_wall{materials::steel});

template <class Tangential>
struct contact {
  using model_type =
      decltype(compose(on_wall, hertz{}, line_force{1 * newtons_per_metre, 0.5 * seconds_per_metre}, Tangential{}));
  using numbers_type = reduced_model<double, model_type>;
  model_type model;
  numbers_type numbers{model, scales_at(model, 1 * metres_per_second)};
  flow<numbers_type> motion{numbers};
  sliding<numbers_type> slides{numbers, 1e-10};
  typename numbers_type::state_type x = numbers.touch(1);

  explicit contact(const Tangential& tangential)
      : model(compose(on_wall, hertz{}, line_force{1 * newtons_per_metre, 0.5 * seconds_per_metre}, tangential)) {}
  contact(const contact&) = delete;

  int direction_at_touch(double slip_at_touch, double surface_spin) {
    slides.start(x, slip_at_touch, surface_spin / numbers.pair.reduced_radius);
    slides.touched(motion, x);
    return motion.direction;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(at_touch_friction_holds_nothing_that_a_moment_turns) {
  contact<coulomb_with_peeling> c({0.2, 1e-9 * joules});
  BOOST_TEST(c.direction_at_touch(0.5, -1) == 1);
  BOOST_TEST(c.direction_at_touch(0, 1) == 1);
  BOOST_TEST(c.direction_at_touch(0, -1) == -1);
  BOOST_TEST(c.direction_at_touch(0, 0) == 0);
  BOOST_TEST(c.direction_at_touch(0, 1e-20) == 0); // so soon held that it hardly would have begun to slide
}

BOOST_AUTO_TEST_CASE(without_a_moment_what_stands_still_rolls) {
  contact<coulomb> plain({0.2});
  BOOST_TEST(plain.direction_at_touch(0.5, 0) == 1);
  BOOST_TEST(plain.direction_at_touch(0, 1) == 0);
  contact<coulomb_with_peeling> c({0.2, 0 * joules});
  BOOST_TEST(c.direction_at_touch(0.5, 1) == 1);
  BOOST_TEST(c.direction_at_touch(0, 1) == 0);
}

BOOST_AUTO_TEST_CASE(a_contact_that_presses_enough_is_held) {
  contact<coulomb_with_peeling> c({0.2, 1e-11 * joules});
  c.direction_at_touch(0.5, -1);
  c.x[contact_radius] = 1;
  c.slides.halted(c.motion, c.x);
  BOOST_TEST(c.motion.direction == 0);
  BOOST_TEST(c.x[slip] == 0);
  c.x[contact_radius] = 1e-3;
  c.x[approach_rate] = -1;
  c.slides.halted(c.motion, c.x);
  BOOST_TEST(c.motion.direction == -1); // backspin
}

BOOST_AUTO_TEST_CASE(in_flight_slip_and_spin_stay) {
  contact<coulomb_with_peeling> c({0.2, 1e-9 * joules});
  c.direction_at_touch(0.5, 2);
  c.x[peeling_loss] = 0.25;
  auto next = c.numbers.touch(1);
  next[elapsed_time] = 3;
  c.slides.flew(c.x, next);
  BOOST_TEST((next[slip] == 0.5 && next[surface_speed] == 2 && next[peeling_loss] == 0.25));
  BOOST_TEST((next[slip_distance] == 1.5 && next[surface_distance] == 6));
}

BOOST_AUTO_TEST_CASE(errors_are_measured_by_the_faster_motion) {
  contact<coulomb_with_peeling> c({0.2, 1e-9 * joules});
  c.direction_at_touch(0.5, -40);
  const auto typical = c.slides.sized(c.numbers.typical());
  BOOST_TEST((typical[slip] == 40 && typical[friction_loss] == 1600 && typical[approach_rate] == 1));
}
