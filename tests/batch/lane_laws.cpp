#include <boost/test/unit_test.hpp>

#include <ricochet/batch/lane_laws.hpp>

#include "support/random_scenes.hpp"

using namespace support;
using many = lanes<xsimd::batch<double>, 2>;

/// Each lane's laws in its own scales are those of the scene alone, but for rounding in powers.
BOOST_AUTO_TEST_CASE(lanes_have_their_own_bodies_parameters_and_scales) {
  scenes random(5);
  std::vector<decltype(viscous_jkr(random.next()))> models;
  std::vector<double> speeds;
  auto laws = laws_in_si<many>(viscous_jkr(random.next()));
  many speed;
  for (std::size_t i = 0; i < many::size; ++i) {
    const auto s = random.next();
    models.push_back(viscous_jkr(s));
    put_lane(laws, i, laws_in_si<double>(models.back()));
    speeds.push_back(in_si(s.speed));
    speed.put(i, speeds.back());
  }
  const auto unit = laws.scales_at(speed);
  const reduced_model<many, decltype(models)::value_type> numbers(in_scales(laws, models[0], unit));
  for (std::size_t i = 0; i < many::size; ++i) {
    const scales alone = scales_at(models[i], speeds[i] * metres_per_second);
    const reduced_model<double, decltype(models)::value_type> expected(models[i], alone);
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-13 * std::abs(b); };
    BOOST_TEST(same(unit.length[i], alone.length));
    BOOST_TEST(same(unit.duration[i], alone.duration));
    BOOST_TEST(same(numbers.pair.reduced_modulus[i], expected.pair.reduced_modulus));
    BOOST_TEST(same(numbers.pair.reduced_radius[i], expected.pair.reduced_radius));
    BOOST_TEST(same(numbers.pair.reduced_mass[i], expected.pair.reduced_mass));
    BOOST_TEST(same(numbers.adhesion.work_of_adhesion[i], expected.adhesion.work_of_adhesion));
    BOOST_TEST(same(numbers.damping.bulk_time[i], expected.damping.bulk_time));
    BOOST_TEST(same(numbers.exit_energy()[i], expected.exit_energy()));
    BOOST_TEST(same(numbers.fold_coordinate()[i], expected.fold_coordinate()));
  }
}
