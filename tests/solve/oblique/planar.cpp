#include <boost/test/unit_test.hpp>

#include <ricochet/solve/oblique/planar.hpp>

using namespace ricochet;
using detail::planar;
using Eigen::Vector3d;

namespace {
const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ(), zero = Vector3d::Zero();
constexpr double radius = 0.5, approach = 1;
} // namespace

BOOST_AUTO_TEST_CASE(slip_is_positive_and_spin_signed_along_it) {
  // normal x: a spin about -z rolls the sphere along y
  const auto pushed = planar(x, 3 * y, -2 * z, radius, approach);
  BOOST_TEST((pushed.forward - y).norm() == 0);
  BOOST_TEST(pushed.slip == 2);
  BOOST_TEST(pushed.spin == 2);
  const auto backspin = planar(x, 3 * y, 2 * z, radius, approach);
  BOOST_TEST((backspin.forward - y).norm() == 0);
  BOOST_TEST(backspin.slip == 4);
  BOOST_TEST(backspin.spin == -2);
  const auto spun = planar(x, 3 * y, -8 * z, radius, approach); // the contact point slides back
  BOOST_TEST((spun.forward + y).norm() == 0);
  BOOST_TEST(spun.slip == 1);
  BOOST_TEST(spun.spin == -8);
}

BOOST_AUTO_TEST_CASE(rolling_has_the_direction_of_the_motion_and_rest_has_none) {
  const auto rolling = planar(x, y, -2 * z, radius, approach);
  BOOST_TEST((rolling.forward - y).norm() == 0);
  BOOST_TEST(rolling.slip == 0);
  BOOST_TEST(rolling.spin == 2);
  const auto rest = planar(x, zero, zero, radius, approach);
  BOOST_TEST((rest.forward.norm() == 0 && rest.slip == 0 && rest.spin == 0));
}

BOOST_AUTO_TEST_CASE(only_round_off_may_leave_the_plane) {
  BOOST_CHECK_THROW(planar(x, y, -2 * z + 1e-9 * y, radius, approach), bad_input);
  BOOST_CHECK_THROW(planar(x, y, -2 * z + 1e-9 * x, radius, approach), bad_input);
  BOOST_CHECK_THROW(planar(x, zero, x, radius, approach), bad_input);
  BOOST_CHECK_NO_THROW(planar(x, y, -2 * z + 1e-15 * y + 1e-15 * x, radius, approach));
  BOOST_CHECK_NO_THROW(planar(x, 1e-16 * (y + z), -2 * z, radius, approach)); // of a velocity along the normal
}
