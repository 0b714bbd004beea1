#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

// Every member of every law on Boost.Units quantities: a wrong exponent in any formula does not compile.
template struct ricochet::hertz_law<dimensional>;
template struct ricochet::jkr_law<dimensional>;
template struct ricochet::greenwood_law<dimensional>;
template struct ricochet::greenwood_fit_law<dimensional>;
template struct ricochet::kuwabara_kono_law<dimensional>;
template struct ricochet::hunt_crossley_law<dimensional>;
template struct ricochet::tsuji_law<dimensional>;

namespace {

using contact = configuration<dimensional>;
constexpr contact_pair pair{};
constexpr contact c{};

static_assert(std::same_as<force, decltype(hertz::force(pair, c))>);
static_assert(std::same_as<energy, decltype(hertz::stored_energy(pair, c))>);
static_assert(std::same_as<energy_per_area, decltype(hertz::energy_release_rate(pair, c))>);
static_assert(std::same_as<length, decltype(hertz::load_free_approach(pair, c.radius))>);
static_assert(std::same_as<double, decltype(hertz::load_free_slope(pair, c.radius))>);
static_assert(std::same_as<energy, decltype(jkr{}.surface_energy(c.radius))>);
static_assert(std::same_as<root_length, decltype(jkr{}.flattening(pair))>);
static_assert(std::same_as<length, decltype(jkr{}.touch_radius(pair))>);
static_assert(std::same_as<length, decltype(jkr{}.fold_radius(pair))>);
static_assert(std::same_as<length, decltype(jkr{}.equilibrium_radius(pair))>);
static_assert(std::same_as<length, decltype(jkr{}.contact_radius(pair, c.approach))>);
static_assert(std::same_as<force, decltype(jkr{}.pull_off_force(pair))>);
static_assert(std::same_as<energy, decltype(jkr{}.exit_energy(pair))>);
static_assert(std::same_as<speed, decltype(greenwood{}.speed_scale(pair, energy_per_area{}))>);
static_assert(std::same_as<speed, decltype(greenwood_fit{}.speed_scale(pair, energy_per_area{}))>);
static_assert(std::same_as<force, decltype(kuwabara_kono{}.coefficient(pair, c) * c.rate)>);
static_assert(std::same_as<force, decltype(hunt_crossley{}.coefficient(pair, c) * c.rate)>);
static_assert(std::same_as<force, decltype(tsuji{}.coefficient(pair, c) * c.rate)>);

// What must not be mixed up.
static_assert(!std::is_convertible_v<double, length>);
static_assert(!std::is_convertible_v<length, double>);
static_assert(!std::is_convertible_v<force, energy_per_area>);
static_assert(!std::is_convertible_v<modulus, energy_per_area>);
static_assert(std::same_as<root_length, decltype(boost::units::root<2>(length{}))>);

template <class Quantity>
void has_exponents(const Quantity& quantity, double l, double m, double t) {
  const exponents e = exponents_of(quantity);
  BOOST_TEST(e.length == l);
  BOOST_TEST(e.mass == m);
  BOOST_TEST(e.time == t);
}

template <class Quantity>
void is(const Quantity& quantity, double expected, const std::string& symbol) {
  BOOST_TEST(in_si(quantity) == expected);
  BOOST_TEST(unit_symbol(quantity) == symbol);
}

} // namespace

BOOST_AUTO_TEST_CASE(exponents_of_every_quantity) {
  has_exponents(1.0, 0, 0, 0);
  has_exponents(length{}, 1, 0, 0);
  has_exponents(root_length{}, 0.5, 0, 0);
  has_exponents(duration{}, 0, 0, 1);
  has_exponents(mass{}, 0, 1, 0);
  has_exponents(density{}, -3, 1, 0);
  has_exponents(modulus{}, -1, 1, -2);
  has_exponents(speed{}, 1, 0, -1);
  has_exponents(force{}, 1, 1, -2);
  has_exponents(energy{}, 2, 1, -2);
  has_exponents(energy_per_area{}, 0, 1, -2);
  has_exponents(inverse_speed{}, -1, 0, 1);
  has_exponents(damping{}, 0, 1, -1);
}

BOOST_AUTO_TEST_CASE(units_have_their_value_and_symbol) {
  is(2.5, 2.5, "");
  is(metres, 1, "m");
  is(millimetres, 1e-3, "m");
  is(micrometres, 1e-6, "m");
  is(nanometres, 1e-9, "m");
  is(seconds, 1, "s");
  is(kilograms, 1, "kg");
  is(kilograms_per_cubic_metre, 1, "kg/m^3");
  is(pascals, 1, "Pa");
  is(megapascals, 1e6, "Pa");
  is(gigapascals, 1e9, "Pa");
  is(metres_per_second, 1, "m/s");
  is(millimetres_per_second, 1e-3, "m/s");
  is(newtons, 1, "N");
  is(joules, 1, "J");
  is(joules_per_square_metre, 1, "J/m^2");
  is(seconds_per_metre, 1, "s/m");
  is(newtons / metres_per_second, 1, "N s/m");
  is(metres * metres, 1, "(SI)"); // a quantity without a symbol of its own
}

BOOST_AUTO_TEST_CASE(cube_root_of_a_quantity) {
  // 1e-15: pow with the exponent 1/3 rounds twice
  BOOST_TEST(std::abs(in_si(cube_root(27.0 * metres * metres * metres)) - 3) < 3e-15);
}

BOOST_AUTO_TEST_CASE(a_law_gives_the_same_in_both_number_systems) {
  const basic_pair<dimensional> ice{3.73e9 * pascals, 1e-6 * metres, 1.7e-14 * kilograms};
  const contact at{2e-8 * metres, 3.0 * metres_per_second, 1.2e-7 * metres, boost::units::root<2>(1.2e-7 * metres)};
  const basic_pair<reduced<double>> numbers{3.73e9, 1e-6, 1.7e-14};
  const configuration<reduced<double>> n{2e-8, 3, 1.2e-7, std::sqrt(1.2e-7)};
  // a few ulp: the same operations, but for the compiler's freedom and powers of quantities
  const auto same = [](double a, double b) { return std::abs(a / b - 1) < 1e-15; };
  using hertz_numbers = hertz_law<reduced<double>>;
  BOOST_TEST(same(in_si(hertz::force(ice, at)), hertz_numbers::force(numbers, n)));
  BOOST_TEST(same(in_si(hertz::stored_energy(ice, at)), hertz_numbers::stored_energy(numbers, n)));
  BOOST_TEST(same(in_si(hertz::energy_release_rate(ice, at)), hertz_numbers::energy_release_rate(numbers, n)));
  const jkr law{0.74 * joules_per_square_metre};
  const jkr_law<reduced<double>> law_numbers{0.74};
  BOOST_TEST(same(in_si(law.contact_radius(ice, at.approach)), law_numbers.contact_radius(numbers, n.approach)));
  BOOST_TEST(same(in_si(law.exit_energy(ice)), law_numbers.exit_energy(numbers)));
  BOOST_TEST(same(in_si(tsuji{0.5}.coefficient(ice, at)), tsuji_law<reduced<double>>{0.5}.coefficient(numbers, n)));
}
