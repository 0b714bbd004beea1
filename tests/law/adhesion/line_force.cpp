#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/number/autodiff.hpp>

using namespace support;

namespace {
using S = reduced<dual<>>;
const basic_pair<S> pair{dual<>(2), dual<>(3), dual<>(1)};
const line_force_law<S> ring{dual<>(0.7), dual<>(0.2)};

configuration<S> at(const dual<>& approach, double rate) {
  return {approach, dual<>(rate), sqrt(approach * pair.reduced_radius), dual<>(0)};
}
} // namespace

BOOST_AUTO_TEST_CASE(the_attraction_derives_from_its_potential) {
  for (const double approach : {0.01, 0.1, 1.}) {
    const auto c = at(seeded(approach), 0);
    BOOST_TEST(ring.potential_energy(pair, c).derivative(1) == -value_of(ring.attraction(pair, c)),
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST(value_of(ring.attraction(pair, c)) == 2 * pi<double>() * 0.7 * std::sqrt(approach * 3),
               boost::test_tools::tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_CASE(it_opposes_the_rebound_only) {
  const auto closing = at(dual<>(0.1), 0.5), opening = at(dual<>(0.1), -0.5);
  BOOST_TEST(value_of(ring.rebound_damping(pair, closing)) == 0);
  // (B1) on the rebound: the ring force grows by the factor 1 + c_A |rate|
  BOOST_TEST(value_of(ring.rebound_damping(pair, opening)) * 0.5 ==
                 value_of(ring.attraction(pair, opening)) * 0.2 * 0.5,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(without_losses_it_gives_back_what_it_took) {
  scenes source(91);
  for (int i = 0; i < 20; ++i) {
    const scene s = source.next();
    const auto model =
        compose(s.pair, hertz{}, line_force{.force_per_length = 50.0 * newtons_per_metre}, energy_ledger{});
    const auto out = collide(model, impact{s.speed}, {.tolerance = 1e-10});
    BOOST_TEST(name_of(out.ending) == "separated");
    BOOST_TEST(std::abs(*out.restitution - 1) < 1e-10);
    BOOST_TEST(std::abs(out.crack_loss) < 1e-30); // what is stored at a radius of round-off
  }
}

BOOST_AUTO_TEST_CASE(more_of_it_sticks_and_certainly) {
  scenes source(92);
  const scene s = source.next();
  double last = 1;
  for (const double f : {0., 1., 10., 100., 1000., 1e4}) {
    const auto model = compose(s.pair, hertz{}, line_force{.force_per_length = f * newtons_per_metre},
                               hunt_crossley{s.hunt_crossley_coefficient}, energy_ledger{});
    const auto out = collide(model, impact{s.speed}, {.tolerance = 1e-9});
    const double e = out.restitution.value_or(0);
    BOOST_TEST_CONTEXT("f0 = " << f) {
      BOOST_TEST(e <= last);
      BOOST_TEST(out.ending_is_certain);
      BOOST_TEST(std::abs(out.ledger_residual) < 1e-8);
      if (!out.restitution)
        BOOST_TEST(out.remaining_energy < 0);
    }
    last = e;
  }
  BOOST_TEST(last == 0);
}

BOOST_AUTO_TEST_CASE(brach_dunn_simulations_of_the_reference) {
  for (const auto& row : read_rows("brach_dunn.csv")) {
    const contact_pair pair = bodies(row);
    const speed v = number(row, "speed") * metres_per_second;
    const auto coefficient = [&](const char* zeta) {
      return closed_form::damping_coefficient_of_brach_dunn(number(row, zeta), pair, v);
    };
    const auto model = compose(pair, hertz{},
                               line_force{.force_per_length = number(row, "line_force") * newtons_per_metre,
                                          .rebound_coefficient = coefficient("zeta_a")},
                               hunt_crossley{.damping_coefficient = coefficient("zeta_h")}, energy_ledger{},
                               contact_duration{}, extremes{});
    const auto out = collide(model, impact{v}, {.tolerance = 1e-10});
    BOOST_TEST_CONTEXT("v = " << row.at("speed")) {
      BOOST_TEST(name_of(out.ending) == row.at("ending"));
      BOOST_TEST(std::abs(out.restitution.value_or(0) - number(row, "restitution")) < 1e-9);
      BOOST_TEST(in_si(out.max_approach) / number(row, "max_approach") == 1, boost::test_tools::tolerance(1e-9));
      if (!row.at("contact_duration").empty())
        BOOST_TEST(in_si(out.contact_duration) / number(row, "contact_duration") == 1,
                   boost::test_tools::tolerance(1e-9));
      BOOST_TEST(std::abs(out.ledger_residual) < 1e-9);
      BOOST_TEST(out.crack_loss >= 0);
    }
  }
}
