#include <boost/test/unit_test.hpp>

#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <random>

using namespace ricochet;

namespace {

/// Models of the concept, each of which the axiom is tested for.
using damping_laws = std::tuple<kuwabara_kono, hunt_crossley, tsuji, linear_dashpot>;

// Non-models: each lacks one thing.
template <class S>
struct without_coefficient {
  using role = ricochet::role::damping;
  template <class Other>
  using in = without_coefficient<Other>;
};
template <class S>
struct with_a_force_only : without_coefficient<S> {
  template <class Other>
  using in = with_a_force_only<Other>;
  typename S::force force(const basic_pair<S>&, const configuration<S>&) const;
};
template <class S>
struct with_coarse_coefficient : kuwabara_kono_law<S> {
  template <class Other>
  using in = with_coarse_coefficient<Other>;
  float coefficient(const basic_pair<S>&, const configuration<S>&) const;
};
template <class S>
struct in_another_role : kuwabara_kono_law<S> {
  using role = ricochet::role::elastic;
  template <class Other>
  using in = in_another_role<Other>;
};

static_assert(bulk_damping_law<kuwabara_kono> && bulk_damping_law<hunt_crossley> && bulk_damping_law<tsuji>);
static_assert(bulk_damping_law<linear_dashpot>);
static_assert(!bulk_damping_law<without_coefficient<dimensional>>);
static_assert(!bulk_damping_law<with_a_force_only<dimensional>>);
static_assert(!bulk_damping_law<with_coarse_coefficient<dimensional>>);
static_assert(!bulk_damping_law<in_another_role<dimensional>>);
static_assert(!bulk_damping_law<hertz> && !bulk_damping_law<absent<role::damping>> && !bulk_damping_law<int>);

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(power_never_is_negative, Law, damping_laws) {
  using S = reduced<double>;
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<> decade(-3, 3), part(-2, 2);
  const auto random = [&] { return std::pow(10, decade(generator)); };
  for (int i = 0; i < 1000; ++i) {
    const basic_pair<S> pair{random(), random(), random()};
    const typename Law::template in<S> law{random()}, none{0};
    const double a = random(), rate = part(generator);
    const configuration<S> c{part(generator) * a * a / pair.reduced_radius, rate, a, std::sqrt(a)}; // in tension too
    BOOST_TEST_REQUIRE(law.coefficient(pair, c) > 0);
    BOOST_TEST_REQUIRE(law.coefficient(pair, c) * rate * rate >= 0);
    BOOST_TEST_REQUIRE(none.coefficient(pair, c) == 0);
    if (!std::same_as<Law, linear_dashpot>) // no contact, no force
      BOOST_TEST_REQUIRE(law.coefficient(pair, {c.approach, rate, 0, 0}) == 0);
  }
}
