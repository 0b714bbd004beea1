#include <boost/test/unit_test.hpp>

#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/number/autodiff.hpp>

#include <random>

using namespace ricochet;

namespace {

/// Models of the concept, each of which the axioms are tested for.
using elastic_laws = std::tuple<hertz, linear>;

// Non-models: each lacks one thing.
template <class S>
struct without_role : hertz_law<S> {
  using role = ricochet::role::damping;
  template <class Other>
  using in = without_role<Other>;
};
template <class S>
struct without_energy {
  using role = ricochet::role::elastic;
  template <class Other>
  using in = without_energy<Other>;
  static typename S::force force(const basic_pair<S>&, const configuration<S>&);
  static typename S::energy_per_area energy_release_rate(const basic_pair<S>&, const configuration<S>&);
  static typename S::length load_free_approach(const basic_pair<S>&, typename S::length);
  static typename S::number load_free_slope(const basic_pair<S>&, typename S::length);
};
template <class S>
struct with_coarse_force : hertz_law<S> {
  template <class Other>
  using in = with_coarse_force<Other>;
  static float force(const basic_pair<S>&, const configuration<S>&);
};
template <class S>
struct without_slope : hertz_law<S> {
  template <class Other>
  using in = without_slope<Other>;
  static double load_free_slope() = delete;
};
struct in_one_number_system_only {
  using role = ricochet::role::elastic;
};

static_assert(is_edgeless<linear> && !is_edgeless<hertz> && !is_edgeless<jkr>);
static_assert(elastic_law<hertz> && elastic_law<linear> && elastic_law<hertz_law<reduced<float>>>);
static_assert(!elastic_law<without_role<dimensional>>);
static_assert(!elastic_law<without_energy<dimensional>>);
static_assert(!elastic_law<with_coarse_force<dimensional>>);
static_assert(!elastic_law<without_slope<dimensional>>);
static_assert(!elastic_law<in_one_number_system_only>);
static_assert(!elastic_law<jkr> && !elastic_law<absent<role::elastic>> && !elastic_law<int>);

using D = dual<>;
using S = reduced<D>;

struct random_contact {
  basic_pair<S> pair;
  double approach, radius, length; ///< length: a^2/R + |delta|, which sets the sizes of the terms
};

/// Moduli, radii and contact radii over decades, in tension and in compression.
random_contact next(std::mt19937_64& generator) {
  std::uniform_real_distribution<> decade(-3, 3), part(-2, 2);
  const double E = std::pow(10, decade(generator)), R = std::pow(10, decade(generator)),
               a = std::pow(10, decade(generator));
  const double flat = a * a / R, approach = flat * part(generator);
  return {{D(E), D(R), D(1)}, approach, a, flat + std::abs(approach)};
}

/// A law for this contact; a spring as stiff as the contact is.
template <class Law>
auto law_for(const random_contact& at) {
  typename Law::template in<S> law{};
  if constexpr (requires { law.stiffness; })
    law.stiffness = at.pair.reduced_modulus * at.radius;
  return law;
}

// 1e-14: a dozen roundings of terms of the size that each check divides by.
constexpr double rounding = 1e-14;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(force_is_the_derivative_of_the_energy, Law, elastic_laws) {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 1000; ++i) {
    const auto at = next(generator);
    const auto law = law_for<Law>(at);
    const D energy = law.stored_energy(at.pair, {seeded(at.approach), D(0), D(at.radius), D(0)});
    const double force = value_of(law.force(at.pair, {D(at.approach), D(0), D(at.radius), D(0)}));
    const double size = value_of(at.pair.reduced_modulus) * at.radius * at.length;
    BOOST_TEST_REQUIRE(std::abs(static_cast<double>(energy.derivative(1)) - force) < rounding * size);
    BOOST_TEST_REQUIRE(std::abs(force) < 10 * size); // lest the check be empty
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(energy_release_rate_is_the_derivative_in_the_contact_area, Law, elastic_laws) {
  std::mt19937_64 generator(2);
  for (int i = 0; i < 1000; ++i) {
    const auto at = next(generator);
    const auto law = law_for<Law>(at);
    const D energy = law.stored_energy(at.pair, {D(at.approach), D(0), seeded(at.radius), D(0)});
    const double rate = value_of(law.energy_release_rate(at.pair, {D(at.approach), D(0), D(at.radius), D(0)}));
    const double per_area = 1 / (2 * pi<double>() * at.radius);
    const double size = value_of(at.pair.reduced_modulus) * at.length * at.length * per_area;
    BOOST_TEST_REQUIRE(std::abs(per_area * static_cast<double>(energy.derivative(1)) - rate) < rounding * size);
    BOOST_TEST_REQUIRE(rate >= 0);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(load_free_edge_releases_no_energy, Law, elastic_laws) {
  std::mt19937_64 generator(3);
  for (int i = 0; i < 1000; ++i) {
    const auto at = next(generator);
    const auto law = law_for<Law>(at);
    const D approach = law.load_free_approach(at.pair, seeded(at.radius));
    const double rate = value_of(law.energy_release_rate(at.pair, {D(value_of(approach)), D(0), D(at.radius), D(0)}));
    const double free = value_of(approach), E = value_of(at.pair.reduced_modulus);
    BOOST_TEST_REQUIRE(std::abs(rate) <= rounding * rounding * E * free * free / at.radius); // a square
    const double slope = value_of(law.load_free_slope(at.pair, D(at.radius)));
    BOOST_TEST_REQUIRE(std::abs(static_cast<double>(approach.derivative(1)) - slope) < rounding * slope);
  }
}
