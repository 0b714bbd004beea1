#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/dmt.hpp>

using namespace support;

namespace {

const scene s = scenes(1).next();
const double E = in_si(s.pair.reduced_modulus), R = in_si(s.pair.reduced_radius), w = in_si(s.work_of_adhesion);
bool same(double a, double b, double within = 1e-14) { return std::abs(a / b - 1) < within; } // dozens of roundings

template <class Model>
concept gives_damping_force = requires(const Model model) {
  model.damping_force(length{}, speed{}, length{});
};
static_assert(gives_damping_force<decltype(viscous_jkr(s))> && !gives_damping_force<decltype(static_jkr(s))>);

} // namespace

BOOST_AUTO_TEST_CASE(absent_laws_take_no_room) {
  BOOST_TEST(sizeof(hertzian(s)) == sizeof(contact_pair));
  BOOST_TEST(sizeof(static_jkr(s)) == sizeof(contact_pair) + sizeof(jkr));
  BOOST_TEST(sizeof(viscous_jkr(s)) == sizeof(contact_pair) + sizeof(jkr) + sizeof(kuwabara_kono));
  BOOST_TEST(sizeof(viscoelastic_jkr_fit(s)) ==
             sizeof(contact_pair) + sizeof(jkr) + sizeof(greenwood_fit) + sizeof(kuwabara_kono));
  BOOST_TEST(sizeof(yielding_hertz(s)) == sizeof(contact_pair) + sizeof(thornton_ning_contact));
}

BOOST_AUTO_TEST_CASE(what_a_model_says_about_itself) {
  using bare = decltype(hertzian(s));
  using full = decltype(viscoelastic_jkr(s));
  static_assert(!bare::adhesive && !bare::damped && !bare::has_crack_law);
  static_assert(full::adhesive && full::damped && full::has_crack_law);
  using yielding_by_motion = decltype(yielding_jkr(s));
  static_assert(!bare::flows && !bare::yields && yielding_by_motion::flows && !yielding_by_motion::yields);
  using still = decltype(viscoelastic_jkr(s, energy_ledger{}).with_static_edge());
  BOOST_TEST((std::same_as<still, decltype(viscous_jkr(s, energy_ledger{}))>));
}

BOOST_AUTO_TEST_CASE(forces_for_authors_of_their_own_loop) {
  const auto model = viscous_hertz(s);
  const length approach = 1e-4 * s.pair.reduced_radius;
  const double d = in_si(approach), rate = 3;
  BOOST_TEST(same(in_si(model.static_radius(approach)), std::sqrt(R * d)));
  const double elastic = 4. / 3 * E * std::sqrt(R) * std::pow(d, 1.5);
  BOOST_TEST(same(in_si(model.elastic_force(approach, model.static_radius(approach))), elastic));
  const double damping = 2 * in_si(s.bulk_time) * E * std::sqrt(R * d) * rate;
  BOOST_TEST(
      same(in_si(model.damping_force(approach, rate * metres_per_second, model.static_radius(approach))), damping));
  BOOST_TEST(
      same(in_si(model.damping_force(approach, -rate * metres_per_second, model.static_radius(approach))), -damping));
  // a law in sqrt(a) is given it
  const auto constant = tsuji_hertz(s);
  const double published =
      s.tsuji_coefficient * std::sqrt(in_si(s.pair.reduced_mass) * 4 / 3 * E * std::sqrt(R)) * std::pow(d, 0.25) * rate;
  BOOST_TEST(same(in_si(constant.damping_force(approach, rate * metres_per_second, constant.static_radius(approach))),
                  published));
}

BOOST_AUTO_TEST_CASE(no_contact_without_overlap) {
  const auto model = hertzian(s);
  BOOST_TEST((model.static_radius(-1e-9 * metres) == length{}));
  BOOST_TEST((model.static_radius(length{}) == length{}));
  BOOST_TEST((model.elastic_force(-1e-9 * metres, length{}) == force{}));
}

BOOST_AUTO_TEST_CASE(adhesive_contact_pulls_at_touch) {
  const auto model = static_jkr(s);
  const length a = model.static_radius(length{});
  BOOST_TEST(same(in_si(a), std::cbrt(2 * pi<double>() * w * R * R / E)));
  // F = 4E a^3/3R - sqrt(8 pi w E a^3) = -(4/3) pi w R at delta = 0
  BOOST_TEST(same(in_si(model.elastic_force(length{}, a)), -4. / 3 * pi<double>() * w * R));
}

BOOST_AUTO_TEST_CASE(scales_see_the_adhesion) {
  const speed slow = 1e-9 * metres_per_second;
  const scales with = scales_at(static_jkr(s), slow), without = scales_at(hertzian(s), slow);
  BOOST_TEST(with.length > 1e3 * without.length); // set by adhesion, not by the speed
  BOOST_TEST(same(without.length / without.duration, 1e-9));
  BOOST_TEST(with.mass == in_si(s.pair.reduced_mass));
}

BOOST_AUTO_TEST_CASE(the_pull_of_an_adhesion_without_an_edge_can_be_had_for_one_configuration) {
  const contact_pair bodies = between(sphere{materials::steel, 1.0 * micrometres}, flat_wall{materials::steel});
  const auto model = compose(bodies, hertz{}, dmt{.work_of_adhesion = 0.1 * joules_per_square_metre});
  const force pull = model.attraction(1.0 * nanometres, 30.0 * nanometres);
  BOOST_TEST(in_si(pull) == 2 * pi<double>() * 0.1 * 1e-6, boost::test_tools::tolerance(1e-14));
}
