#include <boost/test/unit_test.hpp>

#include <ricochet/closed_form/linear.hpp>
#include <ricochet/collide.hpp>

#include <random>

using namespace ricochet;
using namespace ricochet::units;
using closed_form::linear_impact;

namespace {

struct random_impact {
  contact_pair pair;
  linear spring;
  linear_dashpot dashpot;
  speed v;
};

random_impact next(std::mt19937_64& generator, double lowest_ratio, double highest_ratio) {
  const auto between = [&](double low, double high) {
    return low * std::exp(std::uniform_real_distribution<>(0, std::log(high / low))(generator));
  };
  const contact_pair pair{3e9 * pascals, between(1e-7, 1e-2) * metres, between(1e-16, 1) * kilograms};
  const linear spring{between(1, 1e7) * newtons_per_metre};
  const double ratio = between(lowest_ratio, highest_ratio);
  return {
      pair, spring, {closed_form::damping_coefficient_of(ratio, pair, spring)}, between(1e-6, 100) * metres_per_second};
}

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
const linear spring{25.0 * newtons_per_metre};
linear_impact at(double ratio) { return {pair, spring, {closed_form::damping_coefficient_of(ratio, pair, spring)}}; }
const double unit = std::sqrt(1e-14 / 25);

} // namespace

BOOST_AUTO_TEST_CASE(zero_force_agrees_with_integration) {
  std::mt19937_64 generator(1);
  double worst_e = 0, worst_time = 0;
  for (int i = 0; i < 60; ++i) {
    const auto s = next(generator, 1e-4, 10);
    const linear_impact closed(s.pair, s.spring, s.dashpot);
    const auto out =
        integrate(compose(s.pair, s.spring, s.dashpot, contact_duration{}), impact{s.v}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - closed.restitution_to_zero_force()));
    worst_time =
        std::max(worst_time, deviation(in_si(out.contact_duration), in_si(closed.contact_duration_to_zero_force())));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time);
  BOOST_TEST(worst_e < 1e-12);
  BOOST_TEST(worst_time < 1e-9); // the tolerance is one of e; time is carried along with it
}

BOOST_AUTO_TEST_CASE(zero_overlap_agrees_with_integration) {
  std::mt19937_64 generator(2);
  double worst_e = 0, worst_time = 0;
  for (int i = 0; i < 60; ++i) {
    const auto s = next(generator, 1e-4, 0.95);
    const linear_impact closed(s.pair, s.spring, s.dashpot);
    const auto out = integrate(compose(s.pair, s.spring, s.dashpot, end_at_zero_overlap{}, contact_duration{}),
                               impact{s.v}, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    worst_e = std::max(worst_e, std::abs(*out.restitution - *closed.restitution_to_zero_overlap()));
    worst_time =
        std::max(worst_time, deviation(in_si(out.contact_duration), in_si(*closed.contact_duration_to_zero_overlap())));
  }
  BOOST_TEST_MESSAGE("largest deviations: e " << worst_e << ", duration " << worst_time);
  BOOST_TEST(worst_e < 1e-12);
  BOOST_TEST(worst_time < 1e-9); // the tolerance is one of e; time is carried along with it
}

BOOST_AUTO_TEST_CASE(overdamped_contacts_pulled_to_zero_overlap_are_captured) {
  for (const double ratio : {1., 1.5, 30.}) {
    BOOST_TEST(!at(ratio).restitution_to_zero_overlap().has_value());
    BOOST_TEST(!at(ratio).contact_duration_to_zero_overlap().has_value());
    const linear_dashpot dashpot{closed_form::damping_coefficient_of(ratio, pair, spring)};
    const auto model = compose(pair, spring, dashpot, end_at_zero_overlap{});
    BOOST_TEST(name_of(integrate(model, impact{metres_per_second}).ending) == "captured");
    BOOST_TEST(name_of(collide(model, impact{metres_per_second}).ending) == "captured");
  }
}

// The force as it is: m v' = -k x - c v with x = exp(-zeta t) S(t), tried at the time at which it is said to vanish.
BOOST_AUTO_TEST_CASE(the_force_vanishes_when_it_is_said_to) {
  for (const double z : {0.01, 0.3, 0.9, 0.999, 1.001, 2., 5.}) {
    const double t = in_si(at(z).contact_duration_to_zero_force()) / unit, s2 = 1 - z * z, s = std::sqrt(std::abs(s2));
    const double S = s2 > 0 ? std::sin(s * t) / s : std::sinh(s * t) / s;
    const double C = s2 > 0 ? std::cos(s * t) : std::cosh(s * t);
    const double x = std::exp(-z * t) * S, rate = std::exp(-z * t) * (C - z * S);
    BOOST_TEST(std::abs(x + 2 * z * rate) < 1e-13 * (x + 2 * z)); // roundings of t in S and C, some 30 for zeta = 5
    BOOST_TEST(deviation(-rate, at(z).restitution_to_zero_force()) < 1e-11); // C - zeta S cancels, by 4 zeta^2 and s
  }
}

BOOST_AUTO_TEST_CASE(limits) {
  BOOST_TEST(at(0).restitution_to_zero_force() == 1);
  BOOST_TEST(*at(0).restitution_to_zero_overlap() == 1);
  BOOST_TEST(deviation(in_si(at(0).contact_duration_to_zero_force()), pi<double>() * unit) < 1e-15);
  BOOST_TEST(deviation(at(1).restitution_to_zero_force(), std::exp(-2.)) < 1e-15);
  BOOST_TEST(deviation(in_si(at(1).contact_duration_to_zero_force()), 2 * unit) < 1e-7); // acos near one: sqrt(eps)
  BOOST_TEST(deviation(at(1e6).restitution_to_zero_force(), 0.25e-12) < 1e-6);
  for (const double e : {1., 0.9, 0.3, 1e-3})
    BOOST_TEST(deviation(*at(closed_form::damping_ratio_for(e)).restitution_to_zero_overlap(), e) < 1e-13);
  BOOST_TEST(deviation(at(0.37).damping_ratio(), 0.37) < 1e-15);
}

BOOST_AUTO_TEST_CASE(what_it_can_answer_is_not_integrated) {
  const linear_dashpot dashpot{closed_form::damping_coefficient_of(0.4, pair, spring)};
  const auto solved = [](const auto& model) { return closed_form::solved<std::remove_cvref_t<decltype(model)>>; };
  BOOST_TEST(solved(compose(pair, spring)));
  BOOST_TEST(solved(compose(pair, spring, dashpot, contact_duration{})));
  BOOST_TEST(solved(compose(pair, spring, dashpot, end_at_zero_overlap{})));
  BOOST_TEST(!solved(compose(pair, spring, dashpot, end_at_zero_overlap{}, contact_duration{})));
  BOOST_TEST(!solved(compose(pair, spring, dashpot, energy_ledger{})));
  const auto out = collide(compose(pair, spring, dashpot, contact_duration{}), impact{metres_per_second});
  BOOST_TEST(out.evaluations == 0);
  BOOST_TEST(*out.restitution == at(0.4).restitution_to_zero_force());
  BOOST_TEST(in_si(out.contact_duration) == in_si(at(0.4).contact_duration_to_zero_force()));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const auto says = [](const char* name) {
    return [name](const bad_input& e) { return std::string(e.what()).find(name) == 0; };
  };
  BOOST_CHECK_EXCEPTION(linear_impact(pair, linear{}, {}), bad_input, says("stiffness = 0 "));
  BOOST_CHECK_EXCEPTION(linear_impact(pair, spring, {-1.0 * newtons / metres_per_second}), bad_input,
                        says("damping_coefficient = -1 N s/m"));
  BOOST_CHECK_EXCEPTION(closed_form::damping_coefficient_of(-1, pair, spring), bad_input, says("damping_ratio = -1"));
  BOOST_CHECK_EXCEPTION(compose(pair, linear{}), bad_input, says("stiffness = 0 "));
}
