// Every number that the papers print about their own simulations, from tests/data/published.csv: within the printed
// digits, and within what an independent solution gives. Those of the rigid body are in closed_form/rigid_body.cpp.
#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/closed_form/independent_losses.hpp>
#include <ricochet/closed_form/regime.hpp>
#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/solve/oblique.hpp>
#include <ricochet/study/threshold.hpp>

#include <functional>

using namespace support;

namespace {

const ice_case ice;
const speed eight = 8.0 * metres_per_second;

auto full_model() {
  return compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous, energy_ledger{}, contact_duration{},
                 extremes{}, trajectory{});
}
const auto out = collide(full_model(), impact{eight}, {.tolerance = 1e-11});

/// What the papers' source, quantity and conditions name, computed here.
const std::map<std::string, std::function<double()>> ours{
    {"hertz contact time", [] { return in_si(closed_form::contact_time(ice.pair, eight)); }},
    {"contact duration", [] { return in_si(out.contact_duration); }},
    {"restitution e_A", [] { return *out.restitution; }},
    {"restitution e_I (independent losses)",
     [] {
       return *closed_form::independent_losses(ice.pair, ice.adhesive.work_of_adhesion, ice.viscous.bulk_time, eight);
     }},
    {"crack loss / initial kinetic energy (without the jump at touch)",
     [] {
       const auto& lost = out.trajectory.crack_loss; // without the jumps at touch, first row, and at the end, last row
       return (lost[lost.size() - 2] - lost.front()) / out.trajectory.kinetic_energy.front();
     }},
    {"bulk loss / initial kinetic energy", [] { return out.bulk_loss; }},
    {"largest elastic tension (F_E alone; 2.365 with F_D) / JKR pull-off force",
     [] {
       const auto& force = out.trajectory.elastic_force;
       return -*std::min_element(force.begin(), force.end()) / in_si(ice.adhesive.pull_off_force(ice.pair));
     }},
    {"Tabor parameter",
     [] { return closed_form::tabor_number(ice.pair, ice.adhesive.work_of_adhesion, ice.interaction_range); }},
    {"restitution e_JKR",
     [] { return *closed_form::restitution(ice.pair, ice.adhesive.work_of_adhesion, 4.0 * metres_per_second); }},
    {"restitution e_A at T_vis 1e-14 s",
     [] {
       auto edge = ice.fitted();
       edge.relaxation_time = 1e-14 * seconds;
       return *collide(compose(ice.pair, hertz{}, ice.adhesive, edge,
                               kuwabara_kono{bulk_time_of_krijt(edge.relaxation_time, 0.25)}),
                       impact{4.0 * metres_per_second})
                   .restitution;
     }},
    {"sticking velocity (largest speed that sticks)",
     [] {
       return in_si(sticking_speed(compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous),
                                   0.1 * metres_per_second, 100.0 * metres_per_second)
                        .value());
     }},
    {"constant in the JKR sticking velocity",
     [] {
       const double E = in_si(ice.pair.reduced_modulus), R = in_si(ice.pair.reduced_radius),
                    m = in_si(ice.pair.reduced_mass), w = 0.74;
       const double v = in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion));
       return v * v * m / std::cbrt(std::pow(w, 5) * std::pow(R, 4) / (E * E));
     }},
    {"constant in the Hertz contact time", [] { return closed_form::contact_time_factor(); }},
    {"constant in the weak-damping restitution",
     [] {
       const duration tiny = 1e-14 * seconds;
       return (1 - closed_form::weak_damping_restitution(ice.pair, tiny, eight)) *
              double(closed_form::contact_time(ice.pair, eight) / tiny);
     }},
    {"constant in the yield velocity", [] { return closed_form::yield_speed_factor(); }},
};

} // namespace

BOOST_AUTO_TEST_CASE(numbers_of_krijt_2013) {
  int compared = 0;
  for (const auto& row : read_rows("published.csv")) {
    const std::string& quantity = row.at("quantity");
    if (!row.at("source").starts_with("krijt2013") || !ours.contains(quantity))
      continue;
    ++compared;
    const double value = ours.at(quantity)();
    BOOST_TEST_MESSAGE(quantity << ": printed " << row.at("printed") << ", here " << value);
    BOOST_TEST_CONTEXT(quantity) {
      const std::string& independent = row.at("independent");
      // half a unit of the independent solution's last digit
      const auto dot = independent.find('.');
      const auto e = independent.find('e');
      const std::string mantissa = independent.substr(0, e);
      double unit = dot == std::string::npos ? 1 : std::pow(10., -double(mantissa.size() - dot - 1));
      if (e != std::string::npos)
        unit *= std::pow(10., std::stod(independent.substr(e + 1)));
      // The independent solution stops the edge at a finite fraction of its limiting ratio; what it has not lost at the
      // crack by then, 3e-6, it books at detachment.
      if (quantity.starts_with("crack loss"))
        unit = 1e-5;
      BOOST_TEST(std::abs(value - std::stod(independent)) <= 0.51 * unit);
    }
  }
  BOOST_TEST(compared == int(ours.size()));
}

BOOST_AUTO_TEST_CASE(ice_at_two_metres_per_second_sticks_and_its_contact_radius_jumps_to_a_tenth_of_a_micrometre) {
  const auto stuck = collide(full_model(), impact{2.0 * metres_per_second});
  BOOST_TEST(name_of(stuck.ending) == "captured");
  // [K 3.1]: "its radius increases to ~0.1 um with delta hardly changing": where delta reaches a hundredth of its
  // largest
  const auto& t = out.trajectory;
  std::size_t i = 0;
  while (t.mutual_approach[i] < 0.01 * in_si(out.max_approach))
    ++i;
  BOOST_TEST(t.contact_radius[i] > 0.5e-7);
  BOOST_TEST(t.contact_radius[i] < 1.5e-7);
}

namespace {

/// The simulation of Brach and Dunn, silver-coated glass on steel, f0 = 250 N/m, f = 0.1, without spin unless given.
auto brach_dunn(double diameter, double v, double zeta_h, double zeta_a, double spin = 0) {
  const material glass{72.0 * gigapascals, 0.21, 2600.0 * kilograms_per_cubic_metre},
      steel{207.0 * gigapascals, 0.27, 7800.0 * kilograms_per_cubic_metre};
  const contact_pair pair = between(sphere{glass, diameter / 2 * micrometres}, flat_wall{steel});
  const speed at = v * metres_per_second;
  const auto model =
      compose(pair, hertz{},
              line_force{250.0 * newtons_per_metre, closed_form::damping_coefficient_of_brach_dunn(zeta_a, pair, at)},
              hunt_crossley{closed_form::damping_coefficient_of_brach_dunn(zeta_h, pair, at)}, coulomb{0.1},
              energy_ledger{}, extremes{});
  return collide(model, oblique_impact{.speed = at, .spin_1 = spin * radians_per_second}, {.tolerance = 1e-10});
}

} // namespace

BOOST_AUTO_TEST_CASE(numbers_of_the_simulations_of_brach_and_dunn_1995) {
  // zeta_A = 12.5 is printed; half of it gives every result.
  const auto single = brach_dunn(10.12, 2.8, 10.54, 6.25, 1.4557e5);
  BOOST_TEST(std::abs(*single.normal.restitution - 0.746) < 0.0005);
  BOOST_TEST(std::abs(*single.normal.restitution - 0.7460) < 0.00005); // independent
  BOOST_TEST(std::abs(in_si(single.normal.max_approach) / 4.2467e-8 - 1) < 1e-4);
  BOOST_TEST(std::abs(in_si(single.normal.max_approach) / 4.243e-8 - 1) < 1e-3);
  const double kinetic = 1.41096e-12 * square(2.8) / 2;
  BOOST_TEST(std::abs(single.normal.crack_loss * kinetic / 4.815e-13 - 1) < 1e-3);
  BOOST_TEST(std::abs(*single.rebound_angle / degrees - 5.75) < 0.005);
  BOOST_TEST(std::abs(in_si(single.spin_1) / 4.16e4 - 1) < 1e-3);
  BOOST_TEST(std::abs(single.rotation_1 / degrees - 0.1235) < 5e-4);
  BOOST_TEST(single.rolls);
  BOOST_TEST(std::abs(*brach_dunn(8.6, 2.8, 10.45, 6.25).normal.restitution - 0.6220) < 0.0005);
  BOOST_TEST(name_of(brach_dunn(5, 5, 10.54, 6.25).normal.ending) == "captured");
  // and the printed ratio does not
  BOOST_TEST(std::abs(brach_dunn(10.12, 2.8, 10.54, 12.5).normal.restitution.value_or(0) - 0.746) > 0.05);
}
