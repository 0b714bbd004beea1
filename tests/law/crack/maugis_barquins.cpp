#include <boost/test/unit_test.hpp>

#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

const sphere grain{materials::water_ice, 2.0 * micrometres};
const contact_pair pair = between(grain, grain);
const jkr adhesion{0.74 * joules_per_square_metre};
const double E = in_si(pair.reduced_modulus), R = in_si(pair.reduced_radius), m = in_si(pair.reduced_mass), w = 0.74;

maugis_barquins edge(double speed, double exponent) { return {speed * metres_per_second, exponent}; }

double speed_of(double n, double beta) {
  const maugis_barquins_law<reduced<double>> law{1, n};
  const auto rate = rate_anywhere<double>(law, std::sqrt(beta));
  return rate.advance / rate.slowness;
}

/// The same collision as the papers write it, in plain time, by odeint's dopri5 and its own step control: -(final
/// rate).
double restitution_in_plain_time(double v0, double n, double v, double A, double precision) {
  using point = std::array<double, 3>; // approach, rate, radius in the units below
  const double a0 = std::cbrt(2 * std::numbers::pi * R * R * w / E), time = a0 / v;
  const auto motion = [&](const point& x, point& dx, double) {
    const double approach = x[0] * v * time, rate = x[1] * v, a = x[2] * a0;
    const double beta = E * std::pow(a * a - approach * R, 2) / (2 * std::numbers::pi * a * R * R * w);
    const double force = 2 * E / (3 * R) * (3 * a * approach * R - a * a * a) + 2 * A * E * a * rate;
    dx[0] = x[1];
    dx[1] = -force / m * time / v;
    dx[2] = (beta < 1 ? std::pow(1 / beta - 1, 1 / n) : -std::pow(beta - 1, 1 / n)) * v0 * time / a0;
  };
  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_controlled(precision, precision, odeint::runge_kutta_dopri5<point>());
  point x{0, 1, 1e-4};
  double t = 0, h = 1e-60;
  while (!(x[2] < 1e-5 && x[1] < 0)) {
    const point before = x;
    if (stepper.try_step(motion, x, t, h) == odeint::success && !(x[2] > 0)) { // a step beyond the end
      x = before;
      h /= 8;
    }
    if (h < 1e-80)
      break;
  }
  return -x[1];
}

} // namespace

BOOST_AUTO_TEST_CASE(the_formulas_as_published) {
  for (const double n : {0.1, 0.25, 0.6, 1.})
    for (const double beta : {1e-3, 0.2, 0.9, 1.1, 5., 1e3}) {
      const double v = std::abs(speed_of(n, beta));
      const double back = beta > 1 ? 1 + std::pow(v, n) : 1 / (1 + std::pow(v, n));
      BOOST_TEST(std::abs(back / beta - 1) < 1e-14); // a few roundings, of v^n too
      BOOST_TEST((speed_of(n, beta) < 0) == (beta > 1));
    }
  BOOST_TEST(speed_of(1, 3) == -2, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(speed_of(0.5, 0.5) == 1, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(plain_time_gives_the_same) {
  struct {
    double v0, n, v, A;
  } const cases[] = {{100, 1, 8, 0}, {100, 0.6, 6, 0}, {1e3, 0.5, 8, 1e-10}, {1, 0.3, 8, 0}, {30, 0.8, 12, 5e-11}};
  for (const auto& c : cases) {
    const kuwabara_kono bulk{c.A * seconds};
    const auto out = integrate(compose(pair, hertz{}, adhesion, edge(c.v0, c.n), bulk), impact{c.v * metres_per_second},
                               {.tolerance = 1e-11});
    BOOST_TEST_REQUIRE(out.restitution.has_value());
    BOOST_TEST(out.error_estimate <= 1e-11);
    const double fine = restitution_in_plain_time(c.v0, c.n, c.v, c.A, 1e-12);
    BOOST_TEST_MESSAGE("v0 " << c.v0 << ", n " << c.n << ": e " << *out.restitution << ", off by "
                             << *out.restitution - fine);
    BOOST_TEST(std::abs(*out.restitution - fine) < 1e-11); // the tolerance; dopri5 at 1e-12 is off by as much
  }
}

BOOST_AUTO_TEST_CASE(the_ledger_closes_and_every_loss_is_positive) {
  for (const double n : {0.1, 0.4, 1.})
    for (const double v0 : {1., 100., 1e4}) {
      const auto out = collide(
          compose(pair, hertz{}, adhesion, edge(v0, n), kuwabara_kono{5e-11 * seconds}, energy_ledger{}, trajectory{}),
          impact{8.0 * metres_per_second});
      BOOST_TEST(std::abs(out.ledger_residual) < 1e-8);
      const auto& lost = out.trajectory.crack_loss;
      for (std::size_t i = 1; i < lost.size(); ++i) // 1e-12: roundings within the sum
        BOOST_TEST_REQUIRE(lost[i] >= lost[i - 1] - 1e-12 * lost.back());
      if (out.restitution) // it lets go with no radius: nothing is stored, nothing jumps
        BOOST_TEST(*(out.trajectory.contact_radius.end() - 2) < 1e-6 * in_si(grain.radius));
    }
}

BOOST_AUTO_TEST_CASE(a_fast_edge_is_static) {
  const impact fall{8.0 * metres_per_second};
  const double limit = *collide(compose(pair, hertz{}, adhesion), fall).restitution;
  for (const double n : {1., 0.6}) {
    double last = 1;
    for (const double v0 : {1e2, 1e3, 1e4, 1e5}) {
      const double off = limit - *collide(compose(pair, hertz{}, adhesion, edge(v0, n)), fall).restitution;
      BOOST_TEST(off > 0);
      BOOST_TEST(off < last * std::pow(10, -n) * 1.8); // the excess of G goes as v0^-n where the edge is quick
      last = off;
    }
  }
}

BOOST_AUTO_TEST_CASE(the_ratio_at_touch_does_not_matter) {
  for (const double n : {1., 0.7})
    for (const double v0 : {1., 100., 1e4}) {
      std::vector<double> e;
      for (const double ratio : {1e-9, 1e-12, 1e-16}) {
        maugis_barquins law = edge(v0, n);
        law.ratio_at_touch = ratio;
        e.push_back(
            integrate(compose(pair, hertz{}, adhesion, law), impact{20.0 * metres_per_second}, {.tolerance = 1e-12})
                .restitution.value_or(0));
      }
      BOOST_TEST_MESSAGE("n " << n << ", v0 " << v0 << ": " << e[0] - e[2] << " and " << e[1] - e[2]);
      BOOST_TEST(std::abs(e[1] - e[2]) < 2e-12); // two tolerances of the integrations
    }
}

BOOST_AUTO_TEST_CASE(sticks_below_a_speed_above_that_of_a_static_edge) {
  const auto model = compose(pair, hertz{}, adhesion, edge(100, 0.6), energy_ledger{});
  const auto slow = collide(model, impact{2.0 * metres_per_second});
  BOOST_TEST(name_of(slow.ending) == "captured");
  BOOST_TEST(slow.ending_is_certain);
  BOOST_TEST(slow.remaining_energy < 0);
}

BOOST_AUTO_TEST_CASE(every_stepper_comes_to_the_same) {
  const auto model = compose(pair, hertz{}, adhesion, edge(100, 0.6));
  const impact fall{8.0 * metres_per_second};
  const auto expected = integrate(model, fall, {.tolerance = 1e-11});
  const auto check = [&](auto stepper) {
    const auto out = integrate(model, fall, {.tolerance = 1e-7}, stepper);
    BOOST_TEST(std::abs(*out.restitution - *expected.restitution) <= out.error_estimate + expected.error_estimate);
    BOOST_TEST(out.error_estimate <= 1e-7);
  };
  check(stepper::dopri5{});
  check(stepper::fehlberg78{});
  check(stepper::runge_kutta_gill{});
  check(stepper::radau<5>{});
}

BOOST_AUTO_TEST_CASE(parameters_have_ranges) {
  const auto refuses = [](const maugis_barquins& law, const std::string& name) {
    BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, adhesion, law), bad_input,
                          [&](const bad_input& e) { return std::string(e.what()).find(name) == 0; });
  };
  refuses(edge(0, 0.5), "reference_speed = 0 m/s");
  refuses(edge(1, 0.05), "exponent = 0.05");
  refuses(edge(1, 1.5), "exponent = 1.5");
  maugis_barquins law = edge(1, 0.5);
  law.ratio_at_touch = 0.1;
  refuses(law, "ratio_at_touch = 0.1");
}
