#include <boost/test/unit_test.hpp>

#include <ricochet/model/configuration.hpp>

using namespace ricochet;

BOOST_AUTO_TEST_CASE(a_configuration_holds_quantities_at_the_door_and_numbers_in_the_loop) {
  using door = configuration<dimensional>;
  static_assert(std::same_as<decltype(door::approach), length>);
  static_assert(std::same_as<decltype(door::rate), speed>);
  static_assert(std::same_as<decltype(door::root_radius), root_length>);
  static_assert(std::same_as<decltype(configuration<reduced<float>>::radius), float>);
  const contact_instant<double> now{
      .c = {1, 2, 9, 3}, .clock = 0, .coordinate_rate = 0, .root_ratio = 1, .slowness = 0, .inside = true};
  BOOST_TEST(now.c.root_radius * now.c.root_radius == now.c.radius);
}
