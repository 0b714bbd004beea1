#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/map/restitution_map.hpp>

#include <random>

using namespace support;

namespace {
const ice_case ice;
const speed low = 0.01 * metres_per_second, high = 100.0 * metres_per_second;

/// Largest error at random speeds; within a millionth of the sticking speed that of e^2.
void is_right(const auto& model, const restitution_map& map, double max_error, std::size_t count = 2000) {
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> uniform(std::log(map.low()), std::log(map.high())), decades(-12, 0);
  std::vector<impact> impacts;
  for (std::size_t i = 0; i < count; ++i)
    impacts.push_back({std::exp(uniform(source)) * metres_per_second});
  for (std::size_t i = 0; map.sticking_speed() > 0 && i < count / 2; ++i) // close to the threshold
    impacts.push_back({map.sticking_speed() * (1 + std::pow(10, decades(source))) * metres_per_second});
  const auto outcomes = collide(model, std::span<const impact>(impacts), {.tolerance = 1e-12});
  double worst = 0, worst_near = 0;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const double v = in_si(impacts[i].speed);
    if (!(v <= map.high()))
      continue;
    const double e = outcomes[i].restitution.value_or(0), mapped = map(v);
    BOOST_TEST_REQUIRE((mapped >= 0 && mapped <= 1 + 1e-9));
    if (std::abs(v / map.sticking_speed() - 1) < 1e-6)
      worst_near = std::max(worst_near, std::abs(mapped * mapped - e * e));
    else
      worst = std::max(worst, std::abs(mapped - e));
  }
  BOOST_TEST_MESSAGE(map.pieces().size() << " pieces, largest error " << worst << ", next to the threshold of e^2 "
                                         << worst_near);
  BOOST_TEST((worst <= max_error && worst_near <= max_error));
}
} // namespace

BOOST_AUTO_TEST_CASE(maps_are_right_to_their_error) {
  for (const double max_error : {1e-4, 1e-8}) {
    const auto check = [&](const auto& model) {
      is_right(model, make_restitution_map(model, low, high, {.max_error = max_error}), max_error);
    };
    check(compose(ice.pair, hertz{}, ice.viscous));
    check(compose(ice.pair, hertz{}, ice.adhesive));
    check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous));
    check(
        compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, thornton_ning{3e8 * pascals})); // kink at the yield speed
    check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.exact(1e-11 * seconds)));
  }
}

BOOST_AUTO_TEST_CASE(the_sticking_speed_of_jkr) {
  const auto map = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive), low, high);
  const double exact = in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion));
  BOOST_TEST(std::abs(map.sticking_speed() / exact - 1) < 1e-11);
  BOOST_TEST(map(exact * (1 - 1e-9)) == 0);
  BOOST_TEST(map(exact * (1 + 1e-6)) > 0);
  BOOST_TEST(restitution_map::restitution(&map, 5.0) == map(5.0 * metres_per_second));
  BOOST_TEST((std::isnan(map(0.009)) && std::isnan(map(101.)) && std::isnan(map(std::nan("")))));
}

BOOST_AUTO_TEST_CASE(a_pair_that_sticks_everywhere) {
  const auto map = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive), low, 0.5 * metres_per_second);
  BOOST_TEST((map(0.1) == 0 && map(0.5) == 0));
}

BOOST_AUTO_TEST_CASE(what_is_saved_is_what_is_loaded) {
  const auto map = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), low, high);
  const auto file = std::filesystem::temp_directory_path() / "ricochet_restitution_map_test.txt";
  map.save(file);
  const auto loaded = restitution_map::load(file);
  for (double v = 0.011; v < 100; v *= 1.01)
    BOOST_TEST(loaded(v) == map(v));
  std::ofstream(file, std::ios::app) << "";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  BOOST_CHECK_THROW(restitution_map::load(file), std::runtime_error);
  std::ofstream(file) << "speed,restitution\n";
  BOOST_CHECK_THROW(restitution_map::load(file), std::runtime_error);
  std::filesystem::remove(file);
  BOOST_CHECK_THROW(restitution_map::load(file), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  const auto model = compose(ice.pair, hertz{}, ice.viscous);
  BOOST_CHECK_THROW(make_restitution_map(model, high, low), bad_input);
  BOOST_CHECK_THROW(make_restitution_map(model, 0.0 * metres_per_second, high), bad_input);
  BOOST_CHECK_THROW(make_restitution_map(model, low, high, {.max_error = 0}), bad_input);
  BOOST_CHECK_THROW((restitution_map(1, 2, 0, 0, {{1, 1.5, false, {}}})), bad_input);
}
