#include <boost/test/unit_test.hpp>

#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/elastic/linear.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const linear spring{.stiffness = 40.0 * newtons_per_metre};

double over(double a, double b) { return std::abs(a / b - 1); }

} // namespace

BOOST_AUTO_TEST_CASE(force_energy_and_radius) {
  for (const double approach : {-1e-9, 1e-12, 3.7e-8}) {
    const configuration<dimensional> c{approach * metres, {}, 1e-7 * metres, {}};
    BOOST_TEST(over(in_si(spring.force(pair, c)), 40 * approach) < 1e-15); // one rounding
    BOOST_TEST(over(in_si(spring.stored_energy(pair, c)), 20 * approach * approach) < 1e-15);
    BOOST_TEST(in_si(spring.energy_release_rate(pair, c)) == 0);
  }
  const auto model = compose(pair, spring);
  BOOST_TEST(over(in_si(square(model.static_radius(1e-8 * metres))), 1e-8 * in_si(pair.reduced_radius)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(its_collisions_have_its_scales) {
  const double time = std::sqrt(in_si(pair.reduced_mass) / 40);
  for (const double v : {1e-6, 1., 300.}) {
    const auto out = integrate(compose(pair, spring, extremes{}, contact_duration{}), impact{v * metres_per_second},
                               {.tolerance = 1e-12});
    // to the tolerance, which is one of e: approach, radius and time are carried along with it
    BOOST_TEST(std::abs(*out.restitution - 1) < 1e-12);
    BOOST_TEST(over(in_si(out.max_approach), v * time) < 1e-11);
    BOOST_TEST(over(in_si(out.max_approach), in_si(spring.max_approach(pair, v * metres_per_second))) < 1e-11);
    BOOST_TEST(over(in_si(out.max_compression), 40 * v * time) < 1e-11);
    BOOST_TEST(over(in_si(out.contact_duration), pi<double>() * time) < 1e-11);
    BOOST_TEST(out.evaluations < 20'000);
  }
}

BOOST_AUTO_TEST_CASE(the_ledger_closes) {
  const linear_dashpot dashpot{0.3 * std::sqrt(40 * in_si(pair.reduced_mass)) * newtons / metres_per_second};
  const auto out = collide(compose(pair, spring, dashpot, energy_ledger{}), impact{metres_per_second});
  BOOST_TEST(std::abs(out.ledger_residual) < 1e-8);
  BOOST_TEST(out.crack_loss == 0);
  BOOST_TEST(std::abs(out.bulk_loss + square(*out.restitution) - 1) < 1e-8);
}

// m delta'' = P - k delta from delta = 0: a pull P of constant size shifts the oscillation, and takes nothing.
BOOST_AUTO_TEST_CASE(a_constant_pull_deepens_the_approach) {
  const dmt adhesion{0.1 * joules_per_square_metre};
  const double P = in_si(adhesion.pull_off_force(pair)), m = in_si(pair.reduced_mass);
  for (const double v : {1e-3, 1., 30.}) {
    const auto out = collide(compose(pair, spring, adhesion, extremes{}), impact{v * metres_per_second});
    BOOST_TEST(std::abs(out.restitution.value_or(0) - 1) < 1e-8);
    BOOST_TEST(over(in_si(out.max_approach), P / 40 + std::sqrt(square(P / 40) + m * v * v / 40)) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(a_pull_and_a_dashpot_capture) {
  const linear_dashpot dashpot{0.3 * std::sqrt(40 * in_si(pair.reduced_mass)) * newtons / metres_per_second};
  for (const double v : {1e-3, 0.1}) {
    BOOST_TEST(name_of(collide(compose(pair, spring, dashpot, dmt{0.1 * joules_per_square_metre}),
                               impact{v * metres_per_second})
                           .ending) == "captured");
    BOOST_TEST(name_of(collide(compose(pair, spring, dashpot, line_force{3.0 * newtons_per_metre}),
                               impact{v * metres_per_second})
                           .ending) == "captured");
  }
}
