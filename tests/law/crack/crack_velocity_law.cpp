#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

// Non-models: each lacks one thing.
template <class S>
struct without_rate : greenwood_fit_law<S> {
  template <class Other>
  using in = without_rate<Other>;
  void rate(double) const = delete;
};
template <class S>
struct with_a_plain_speed : greenwood_fit_law<S> {
  template <class Other>
  using in = with_a_plain_speed<Other>;
  double rate(double, int) const;
};
template <class S>
struct without_joints : greenwood_fit_law<S> {
  template <class Other>
  using in = without_joints<Other>;
  static constexpr int joints = 0;
};
template <class S>
struct in_another_role : greenwood_fit_law<S> {
  using role = ricochet::role::damping;
  template <class Other>
  using in = in_another_role<Other>;
};

static_assert(crack_velocity_law<greenwood> && crack_velocity_law<greenwood_fit>);
static_assert(crack_velocity_law<maugis_barquins> && opens_without_bound<maugis_barquins>);
static_assert(!opens_without_bound<greenwood> && !opens_without_bound<greenwood_fit>);
static_assert(!crack_velocity_law<without_rate<dimensional>>);
static_assert(!crack_velocity_law<with_a_plain_speed<dimensional>>);
static_assert(!crack_velocity_law<without_joints<dimensional>>);
static_assert(!crack_velocity_law<in_another_role<dimensional>>);
static_assert(!crack_velocity_law<jkr> && !crack_velocity_law<absent<role::crack>> && !crack_velocity_law<int>);

using S = reduced<double>;

greenwood_law<S> exact(double k) {
  greenwood made{seconds, k, metres};
  made.tabulate();
  return {1, k, 1, 1.01, made.table};
}
const greenwood_fit_law<S> fit{.relaxation_time = 1, .interaction_range = 1};

/// Axioms of the concept on k < beta < 1/k. `jump`: what the law may step back by at a joint, relative.
template <class Law>
void satisfies_axioms(const Law& law, double k, double jump) {
  const auto speed = [&](double beta) {
    const auto edge = rate_anywhere<double>(law, std::sqrt(beta));
    BOOST_TEST_REQUIRE(edge.slowness > 0);
    return edge.advance / edge.slowness;
  };
  // speed(1) = 0: the law keeps |beta - 1| above 1e-18, or x above 1e-30, where the speed is below 1e-17
  BOOST_TEST(std::abs(rate_anywhere<double>(law, 1.0).advance / rate_anywhere<double>(law, 1.0).slowness) < 1e-17);
  double last = std::numeric_limits<double>::infinity(), last_beta = k;
  for (int i = 1; i < 4000; ++i) {
    const double beta = k * std::pow(k, -2 * i / 4000.);
    const double now = speed(beta);
    bool over_joint = false;
    for (const double joint : Law::joints)
      over_joint |= last_beta <= joint && beta > joint;
    BOOST_TEST_REQUIRE((now < last || (over_joint && now < last + jump * std::abs(last))));
    BOOST_TEST_REQUIRE((beta - 1) * -now >= 0); // (G - w) times the opening speed
    last = now;
    last_beta = beta;
  }
  if (opens_without_bound<Law>) {
    BOOST_TEST(rate_anywhere<double>(law, 1e40).slowness < 1e-70); // it vanishes with 1/beta
    BOOST_TEST(rate_anywhere<double>(law, 1e-40).slowness < 1e-70);
    return;
  }
  // slowness 0 where the speed is unbounded; a rounding of beta, 12 times what the slowness makes of it and k/(1-k)
  BOOST_TEST(std::abs(rate_anywhere<double>(law, std::sqrt(1 / k)).slowness) < 1e-14 / (1 - k));
  BOOST_TEST(std::abs(law.rate(std::sqrt(k), 0).slowness) < 1e-14 / (1 - k));
}

} // namespace

BOOST_AUTO_TEST_CASE(axioms) {
  for (const double k : {1e-4, 1e-3, 0.02, 0.1, 0.5, 0.9, 0.98})
    BOOST_TEST_CONTEXT("greenwood, k " << k) { satisfies_axioms(exact(k), k, 0); }
  for (const double n : {0.1, 0.3, 0.6, 1.})
    BOOST_TEST_CONTEXT("maugis_barquins, n " << n) {
      satisfies_axioms(maugis_barquins_law<S>{.reference_speed = 1, .exponent = n}, 1e-6, 0);
    }
  BOOST_TEST_CONTEXT("greenwood_fit") { satisfies_axioms(fit, 0.02, 0.01); } // its printed jumps: 0.8 % and 0.6 %
}

BOOST_AUTO_TEST_CASE(speed_scale) {
  const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
  const greenwood law{1e-11 * seconds, 0.02, 0.3 * nanometres};
  const greenwood_fit other{.relaxation_time = 1e-11 * seconds, .interaction_range = 0.3 * nanometres};
  const double expected = 3e9 * 0.3e-9 * 0.3e-9 / (0.74 * 1e-11);                               // E z0^2/(w T)
  const auto same = [&](speed found) { return std::abs(in_si(found) / expected - 1) < 1e-15; }; // four roundings
  BOOST_TEST(same(law.speed_scale(pair, 0.74 * joules_per_square_metre)));
  BOOST_TEST(same(other.speed_scale(pair, 0.74 * joules_per_square_metre)));
  BOOST_TEST(law.first_ratio() == 1.01 * 0.02);
  BOOST_TEST(other.first_ratio() == 1.01 * 0.02);
}

BOOST_AUTO_TEST_CASE(rate_anywhere_takes_the_piece_by_hand) {
  const auto by_hand = [](double beta) { return beta <= 0.29 ? 0 : beta <= 1 ? 1 : beta <= 3.7 ? 2 : 3; };
  for (const double beta : {0.021, 0.1, 0.289, 0.291, 0.6, 0.99, 1.01, 2., 3.69, 3.71, 20., 49.}) {
    const auto found = rate_anywhere<double>(fit, std::sqrt(beta)), expected = fit.rate(std::sqrt(beta), by_hand(beta));
    BOOST_TEST(found.advance == expected.advance);
    BOOST_TEST(found.slowness == expected.slowness);
  }
}
