#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/compose.hpp>

using namespace ricochet;
using namespace ricochet::units;

static_assert(plays<end_at_zero_force, role::end> && plays<end_at_zero_overlap, role::end>);
static_assert(!std::same_as<end_at_zero_force, end_at_zero_overlap>);

BOOST_AUTO_TEST_CASE(the_default_is_zero_force) {
  const sphere body{materials::water_ice, micrometres};
  const auto unsaid = compose(between(body, body), hertz{}, kuwabara_kono{1e-11 * seconds});
  const auto said = compose(between(body, body), hertz{}, kuwabara_kono{1e-11 * seconds}, end_at_zero_force{});
  const auto other = compose(between(body, body), hertz{}, kuwabara_kono{1e-11 * seconds}, end_at_zero_overlap{});
  static_assert(std::same_as<decltype(unsaid), decltype(said)>);
  static_assert(std::same_as<decltype(unsaid)::end_condition, end_at_zero_force>);
  static_assert(std::same_as<decltype(other)::end_condition, end_at_zero_overlap>);
  BOOST_TEST(sizeof(unsaid) == sizeof(other)); // an end condition takes no room
}
