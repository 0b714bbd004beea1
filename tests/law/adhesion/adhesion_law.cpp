#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <random>

using namespace ricochet;

namespace {

/// Models of the concept, each of which the axioms are tested for.
using adhesion_laws = std::tuple<jkr>;

// Non-models: each lacks one thing.
template <class S>
struct in_another_role : jkr_law<S> {
  using role = ricochet::role::crack;
  template <class Other>
  using in = in_another_role<Other>;
};
template <class S>
struct without_exit_energy : jkr_law<S> {
  template <class Other>
  using in = without_exit_energy<Other>;
  void exit_energy() const = delete;
};
template <class S>
struct with_coarse_pull_off : jkr_law<S> {
  template <class Other>
  using in = with_coarse_pull_off<Other>;
  float pull_off_force(const basic_pair<S>&) const;
};
template <class S>
struct without_work_of_adhesion {
  using role = ricochet::role::adhesion;
  template <class Other>
  using in = without_work_of_adhesion<Other>;
};

static_assert(adhesion_law<jkr> && adhesion_law<jkr_law<reduced<long double>>>);
static_assert(!adhesion_law<in_another_role<dimensional>>);
static_assert(!adhesion_law<without_exit_energy<dimensional>>);
static_assert(!adhesion_law<with_coarse_pull_off<dimensional>>);
static_assert(!adhesion_law<without_work_of_adhesion<dimensional>>);
static_assert(!adhesion_law<hertz> && !adhesion_law<absent<role::adhesion>> && !adhesion_law<double>);

using S = reduced<double>;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(axioms_over_random_pairs, Law, adhesion_laws) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<> decade(-3, 3);
  const auto random = [&] { return std::pow(10, decade(generator)); };
  for (int i = 0; i < 300; ++i) {
    const basic_pair<S> pair{random(), random(), 1};
    const typename Law::template in<S> law{random()};
    const double c = law.flattening(pair), fold = law.fold_radius(pair);
    const auto static_approach = [&](double a) { return hertz_law<S>::load_free_approach(pair, a) - c * std::sqrt(a); };
    const auto potential = [&](double a, double approach) {
      return hertz_law<S>::stored_energy(pair, {approach, 0, a, 0}) + law.surface_energy(a);
    };
    // U at the fold is the exit energy; 1e-13: three terms of its size that partly cancel
    BOOST_TEST_REQUIRE(std::abs(potential(fold, static_approach(fold)) / law.exit_energy(pair) - 1) < 1e-13);
    // the approach at touch is zero
    const double touch = law.touch_radius(pair);
    BOOST_TEST_REQUIRE(std::abs(static_approach(touch)) < 1e-14 * touch * touch / pair.reduced_radius);
    // the static branch is the stable one: the potential has a minimum in a there
    for (const double above : {1.05, 1.5, 3., 30.}) {
      const double a = above * fold, approach = static_approach(a), step = 0.01 * a;
      const double here = potential(a, approach);
      BOOST_TEST_REQUIRE(potential(a + step, approach) > here);
      BOOST_TEST_REQUIRE(potential(a - step, approach) > here);
      BOOST_TEST_REQUIRE(std::abs(law.contact_radius(pair, approach) / a - 1) < 1e-12); // ill-conditioned by 1/0.05
    }
    // no static contact pulls harder than the pull-off force, nor less at its strongest by more than the scan's step
    double strongest = 0;
    for (double a = fold; a < 10 * fold; a *= 1.01)
      strongest = std::max(strongest, -hertz_law<S>::force(pair, {static_approach(a), 0, a, 0}));
    BOOST_TEST_REQUIRE(strongest <= law.pull_off_force(pair) * (1 + 1e-14));
    BOOST_TEST_REQUIRE(strongest > law.pull_off_force(pair) * (1 - 1e-3));
  }
}
