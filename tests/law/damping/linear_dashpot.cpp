#include <boost/test/unit_test.hpp>

#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {
const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
const linear_dashpot dashpot{2e-7 * newtons / metres_per_second};
} // namespace

BOOST_AUTO_TEST_CASE(the_coefficient_is_the_same_everywhere) {
  for (const double a : {0., 1e-8, 1e-6})
    for (const double approach : {-1e-8, 0., 1e-7})
      BOOST_TEST(in_si(dashpot.coefficient(pair, {approach * metres, metres_per_second, a * metres, {}})) == 2e-7);
}

// m delta'' = -K delta^{3/2} - c delta' in plain time: no code of the library.
BOOST_AUTO_TEST_CASE(on_a_hertzian_contact_it_does_what_plain_time_does) {
  const double E = 3e9, R = 1e-6, m = 1e-14, c = 2e-7, v = 1, K = 4 * E * std::sqrt(R) / 3;
  const auto rate_at_zero_force = [&](int steps) { // Runge-Kutta-Nystroem of order 4, stopped by linear interpolation
    const double h = 6e-7 / steps;
    double x = 0, u = v;
    const auto acceleration = [&](double at, double rate) {
      return -(K * at * std::sqrt(std::max(at, 0.)) + c * rate) / m;
    };
    for (;;) {
      const double k1 = acceleration(x, u), u2 = u + h / 2 * k1;
      const double k2 = acceleration(x + h / 2 * u, u2), u3 = u + h / 2 * k2;
      const double k3 = acceleration(x + h / 2 * u2, u3), u4 = u + h * k3;
      const double k4 = acceleration(x + h * u3, u4);
      const double next_x = x + h / 6 * (u + 2 * u2 + 2 * u3 + u4), next = u + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (next < 0 && acceleration(next_x, next) > 0) // pulled: the largest outward rate is passed between both
        return std::min(u, next);
      x = next_x;
      u = next;
    }
  };
  const auto out = integrate(compose(pair, hertz{}, dashpot), impact{v * metres_per_second}, {.tolerance = 1e-10});
  const double e = -rate_at_zero_force(1'600'000) / v;
  BOOST_TEST_MESSAGE("e " << *out.restitution << ", plain time " << e);
  // The rate is largest there, so that its error is quadratic in the step, (h/t)^2; the root at touch makes the order
  // 2.5. A quarter of the steps gives an error of 1.1e-9, a sixteenth one of 3e-8.
  BOOST_TEST(std::abs(*out.restitution - e) < 1e-10);
  BOOST_TEST(*out.restitution < 0.9);
}

BOOST_AUTO_TEST_CASE(none_is_elastic) {
  const auto model = compose(pair, hertz{}, linear_dashpot{});
  BOOST_TEST(std::abs(*collide(model, impact{metres_per_second}).restitution - 1) < 1e-8);
  const auto pulled = compose(pair, hertz{}, linear_dashpot{}, end_at_zero_overlap{});
  BOOST_TEST(std::abs(*collide(pulled, impact{metres_per_second}).restitution - 1) < 1e-8);
}

BOOST_AUTO_TEST_CASE(works_in_tension) {
  const auto out = collide(compose(pair, jkr{0.05 * joules_per_square_metre}, dashpot, hertz{}, energy_ledger{}),
                           impact{metres_per_second});
  BOOST_TEST(name_of(out.ending) == "separated");
  BOOST_TEST(std::abs(out.ledger_residual) < 1e-8);
  BOOST_TEST(out.bulk_loss > 0.01);
}
