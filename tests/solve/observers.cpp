#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

using namespace support;

BOOST_AUTO_TEST_CASE(extremes_of_elastic_impacts_are_those_of_the_closed_forms) {
  scenes source(81);
  for (int i = 0; i < 20; ++i) {
    const scene s = source.next();
    const auto out = integrate(hertzian(s, extremes{}), impact{s.speed}, {.tolerance = 1e-11});
    const length approach = closed_form::max_approach(s.pair, s.speed);
    const force compression = compose(s.pair, hertz{}).elastic_force(approach, sqrt(s.pair.reduced_radius * approach));
    const auto near = boost::test_tools::tolerance(1e-10);
    BOOST_TEST(double(out.max_approach / approach) == 1, near);
    BOOST_TEST(double(out.max_contact_radius / sqrt(s.pair.reduced_radius * approach)) == 1, near);
    BOOST_TEST(double(out.max_compression / compression) == 1, near);
    BOOST_TEST(in_si(out.max_tension) <= 1e-15 * in_si(out.max_compression));
    // Without other losses JKR's tension is the pull-off force, met inside a step.
    const auto sticky = integrate(static_jkr(s, extremes{}), impact{s.speed}, {.tolerance = 1e-11});
    const force pull_off = jkr{s.work_of_adhesion}.pull_off_force(s.pair);
    BOOST_TEST(double(sticky.max_tension / pull_off) == 1, near);
  }
}

BOOST_AUTO_TEST_CASE(the_trajectory_holds_the_motion) {
  const ice_case ice;
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous, energy_ledger{}, trajectory{},
                             extremes{}, contact_duration{});
  const auto out = collide(model, impact{8.0 * metres_per_second}, {.tolerance = 1e-9});
  const auto& t = out.trajectory;
  const std::size_t rows = t.time.size();
  BOOST_TEST(rows > 100);
  for (const auto* column :
       {&t.mutual_approach, &t.approach_rate, &t.contact_radius, &t.elastic_force, &t.damping_force, &t.kinetic_energy,
        &t.elastic_energy, &t.surface_energy, &t.crack_loss, &t.bulk_loss})
    BOOST_TEST(column->size() == rows);
  BOOST_TEST(t.time.front() == 0);
  BOOST_TEST(t.time.back() / in_si(out.contact_duration) == 1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(t.approach_rate.front() == 8, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(-t.approach_rate.back() / 8 == *out.restitution, boost::test_tools::tolerance(1e-9));
  const double kinetic = 0.5 * in_si(ice.pair.reduced_mass) * 64;
  double largest = 0, deepest = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (i)
      BOOST_TEST(t.time[i] >= t.time[i - 1]);
    const double sum =
        t.kinetic_energy[i] + t.elastic_energy[i] + t.surface_energy[i] + t.crack_loss[i] + t.bulk_loss[i];
    BOOST_TEST(std::abs(sum - kinetic) < 1e-8 * kinetic); // the balance of [K appendix C] at every row
    largest = std::max(largest, t.contact_radius[i]);
    deepest = std::max(deepest, t.mutual_approach[i]);
  }
  BOOST_TEST(t.contact_radius.back() == 0);
  BOOST_TEST(t.crack_loss.back() / kinetic == out.crack_loss, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(t.bulk_loss.back() / kinetic == out.bulk_loss, boost::test_tools::tolerance(1e-12));
  // rows lie closer than a part in a thousand to the extremes, which they do not exceed
  BOOST_TEST(largest / in_si(out.max_contact_radius) > 0.999);
  BOOST_TEST(largest / in_si(out.max_contact_radius) < 1 + 1e-9);
  BOOST_TEST(deepest / in_si(out.max_approach) > 0.999);
  BOOST_TEST(deepest / in_si(out.max_approach) < 1 + 1e-9);
}
