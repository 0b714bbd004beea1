#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>

using namespace support;

namespace {

const contact_pair on_wall = between(sphere{materials::quartz, 5 * micrometres}, flat_wall{materials::steel});
auto numbers_of(const auto& tangential) {
  const auto model = compose(on_wall, hertz{}, line_force{1 * newtons_per_metre, 0.5 * seconds_per_metre}, tangential);
  return reduced_model<double, std::remove_const_t<decltype(model)>>(model, scales_at(model, 1 * metres_per_second));
}
const auto peeling = numbers_of(coulomb_with_peeling{0.2, 3e-9 * joules});
const auto plain = numbers_of(coulomb{0.2});
using state_type = decltype(peeling)::state_type;

state_type in_contact(double slip_now, double surface_speed_now) {
  state_type x = peeling.touch(1);
  x[contact_radius] = 0.4;
  x[slip] = slip_now;
  x[surface_speed] = surface_speed_now;
  return x;
}
state_type slope_at(const state_type& x, int direction) {
  state_type dx{};
  BOOST_TEST_REQUIRE(peeling.derivative(x, dx, 0, direction));
  return dx;
}
bool same(double a, double b) { return std::abs(a - b) <= 1e-14 * std::max(std::abs(a), std::abs(b)); }

} // namespace

BOOST_AUTO_TEST_CASE(work_is_what_the_motion_loses) {
  for (const double u : {-0.7, 0.3, 1.5})
    for (const int direction : {-1, 0, 1}) {
      const double s = direction * 0.6, m = peeling.pair.reduced_mass;
      const state_type x = in_contact(s, u), dx = slope_at(x, direction);
      const double v = s + u, v_rate = dx[slip] + dx[surface_speed]; // m v^2/2 + (2/5) m u^2/2
      BOOST_TEST(same(-m * (v * v_rate + 0.4 * u * dx[surface_speed]), dx[friction_loss] + dx[peeling_loss]));
      BOOST_TEST((dx[friction_loss] >= 0 && dx[peeling_loss] > 0));
      BOOST_TEST(dx[surface_distance] == u * peeling.at(x, 0).clock);
    }
}

BOOST_AUTO_TEST_CASE(a_rolling_contact_slows_with_the_moment_over_seven_fifths_of_the_inertia) {
  const double u = 0.8;
  const state_type x = in_contact(0, u), dx = slope_at(x, 0);
  const double moment = peeling.tangential.peeling_moment * peeling.adhesion.rebound_coefficient * 0.4 * u; // times R
  BOOST_TEST(dx[slip] == 0);
  BOOST_TEST(same(dx[surface_speed], -5. / 7 * moment * peeling.at(x, 0).clock /
                                         (peeling.pair.reduced_mass * square(double(peeling.pair.reduced_radius)))));
}

BOOST_AUTO_TEST_CASE(friction_lacks_at_the_ends_of_a_contact) {
  const auto excess = [&](double radius, double u) {
    state_type x = in_contact(0, u);
    x[contact_radius] = radius;
    return peeling.excess_of_friction(peeling.at(x, 0).c, u);
  };
  const double lack = -5. / 7 * peeling.resistance_per_radius(0.8);
  BOOST_TEST(excess(0, 0.8) == lack);
  BOOST_TEST(excess(0, -0.8) == lack);
  BOOST_TEST(excess(-1e-3, 0.8) == lack);                    // past the end
  BOOST_TEST(std::abs(excess(1e-6, 0.8) / lack - 1) < 1e-6); // smooth down to it
  BOOST_TEST(excess(1, 1e-6) > 0);
  BOOST_TEST(excess(0, 0) == 1); // what does not turn, needs none
}

BOOST_AUTO_TEST_CASE(without_turning_it_slides_as_coulombs) {
  const state_type x = in_contact(0.6, 0), dx = slope_at(x, 1);
  decltype(plain)::state_type y = plain.touch(1), dy{};
  y[contact_radius] = 0.4;
  y[slip] = 0.6;
  BOOST_TEST_REQUIRE(plain.derivative(y, dy, 0, 1));
  BOOST_TEST(same(dx[slip], dy[slip]));
  BOOST_TEST(dx[slip_distance] == dy[slip_distance]);
}
