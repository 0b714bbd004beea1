#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/model/physical_system.hpp>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>

using namespace support;

namespace {

// The two rows with a modulus ratio near one and a slow edge: the reference lets it go at the fold, before it has come
// to its limiting ratio 1/k (see the last test).
bool stops_early(const std::map<std::string, std::string>& row) {
  const auto k = row.find("modulus_ratio");
  return k != row.end() && (k->second == "0.9" || k->second == "0.5");
}

void compare(const std::string& file) {
  for (const auto& row : read_rows(file))
    compose_row(
        row,
        [&](const auto& model) {
          const auto out = integrate(model, impact{number(row, "speed") * metres_per_second}, {.tolerance = 1e-10});
          BOOST_TEST_CONTEXT(file << ", v = " << row.at("speed")) {
            BOOST_TEST(name_of(out.ending) == row.at("ending"));
            if (row.contains("max_approach") && !row.at("max_approach").empty())
              BOOST_TEST(in_si(out.max_approach) / number(row, "max_approach") == 1,
                         boost::test_tools::tolerance(1e-8));
            if (stops_early(row)) {
              BOOST_TEST(std::abs(*out.restitution - number(row, "restitution")) < 1e-6);
              return;
            }
            BOOST_TEST(std::abs(out.restitution.value_or(0) - number(row, "restitution")) < 1e-9);
            if (!row.at("contact_duration").empty())
              BOOST_TEST(in_si(out.contact_duration) / number(row, "contact_duration") == 1,
                         boost::test_tools::tolerance(1e-8));
            if (row.contains("bulk_loss") && !row.at("bulk_loss").empty())
              BOOST_TEST(std::abs(out.bulk_loss - number(row, "bulk_loss")) < 1e-8);
          }
        },
        energy_ledger{}, contact_duration{}, extremes{});
}

} // namespace

BOOST_AUTO_TEST_CASE(viscoelastic_jkr_of_the_reference) { compare("viscoelastic_jkr.csv"); }

BOOST_AUTO_TEST_CASE(other_compositions_of_the_reference) { compare("other_compositions.csv"); }

BOOST_AUTO_TEST_CASE(viscoelastic_hertz_at_both_ends) {
  // Any scene with the wanted y = (3/2) A rho^{2/5} v^{1/5} will do.
  const ice_case ice;
  const speed v = 1.0 * metres_per_second;
  const double E = in_si(ice.pair.reduced_modulus), R = in_si(ice.pair.reduced_radius),
               m = in_si(ice.pair.reduced_mass);
  const double rho = 4. / 3 * E * std::sqrt(R) / m;
  for (const auto& row : read_rows("viscoelastic_hertz_e.csv")) {
    const double y = number(row, "y");
    const kuwabara_kono viscous{y / (1.5 * std::pow(rho, 0.4)) * seconds};
    const auto force_end = collide(compose(ice.pair, hertz{}, viscous), impact{v}, {.tolerance = 1e-11});
    const auto overlap_end =
        collide(compose(ice.pair, hertz{}, viscous, end_at_zero_overlap{}), impact{v}, {.tolerance = 1e-11});
    BOOST_TEST_CONTEXT("y = " << y) {
      BOOST_TEST(std::abs(*force_end.restitution - number(row, "e_end_zero_force")) < 1e-11);
      // The reference leaves y = 5 open; the pair separates all the same, with very little speed.
      if (row.at("e_end_zero_overlap") == "nan")
        BOOST_TEST((*overlap_end.restitution > 0 && *overlap_end.restitution < 0.0206825069607));
      else
        BOOST_TEST(std::abs(*overlap_end.restitution - number(row, "e_end_zero_overlap")) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(constant_of_the_jkr_sticking_speed_from_integration) {
  const ice_case ice;
  const auto model = compose(ice.pair, hertz{}, ice.adhesive);
  const speed v = 3.0 * metres_per_second;
  const auto out = integrate(model, impact{v}, {.tolerance = 1e-12});
  const double lost = (1 - square(*out.restitution)) * square(in_si(v)); // v_c^2
  const double unit = std::pow(0.74, 5. / 3) * std::pow(in_si(ice.pair.reduced_radius), 4. / 3) /
                      std::pow(in_si(ice.pair.reduced_modulus), 2. / 3) / in_si(ice.pair.reduced_mass);
  BOOST_TEST(std::abs(lost / unit - 14.184391943728) < 1e-10);
}

BOOST_AUTO_TEST_CASE(where_the_edge_lets_go_an_independent_loop_in_time_agrees) {
  // The physical equations in time with odeint's dopri5, stopped at beta = (1 - left)/k past the fold: however large
  // `left` is, no earlier than at the fold. As left -> 0 its restitution falls to that of collide(). The reference is
  // that of the fold itself: it lets go as soon as the end condition allows for any `left`.
  for (const auto& row : read_rows("other_compositions.csv")) {
    if (!stops_early(row) || row.at("modulus_ratio") != "0.5")
      continue;
    compose_row(row, [&](const auto& model) {
      if constexpr (std::remove_cvref_t<decltype(model)>::has_crack_law) {
        const speed v = number(row, "speed") * metres_per_second;
        const double k = 0.5, here = *collide(model, impact{v}, {.tolerance = 1e-11}).restitution;
        const physical_system system(model);
        const auto restitution_stopped_at = [&](double left) {
          namespace odeint = boost::numeric::odeint;
          auto x = system.touch(v);
          double t = 0, dt = 1e-18;
          auto stepper = odeint::make_controlled(1e-20, 1e-11, odeint::runge_kutta_dopri5<decltype(x)>());
          while (!(system.past_fold(x) && system.energy_release_ratio(x) >= (1 - left) / k)) {
            auto next = x;
            double t_next = t, step = std::min(dt, 1e-12);
            const bool accepted = stepper.try_step(system, next, t_next, step) == odeint::success;
            const bool outside = !(next[contact_radius] > 0) || !(system.energy_release_ratio(next) < 1 / k);
            dt = outside ? std::min(dt, 1e-12) / 4 : step;
            if (accepted && !outside) {
              x = next;
              t = t_next;
            }
          }
          return -x[approach_rate] / in_si(v);
        };
        const double at_fold = restitution_stopped_at(1e-2), later = restitution_stopped_at(1e-5),
                     last = restitution_stopped_at(1e-7);
        BOOST_TEST_MESSAGE("e - collide(): at the fold " << at_fold - here << ", left 1e-5 " << later - here
                                                         << ", left 1e-7 " << last - here << "; reference "
                                                         << number(row, "restitution") - here);
        BOOST_TEST(number(row, "restitution") > at_fold); // stopped by up to a step of 1e-12 s later
        BOOST_TEST(number(row, "restitution") < at_fold + 1.5e-8);
        BOOST_TEST(at_fold > later + 1e-7);
        BOOST_TEST(later > here + 1e-8);
        BOOST_TEST(std::abs(last - here) < 5e-11); // the loop's own accuracy
      }
    });
  }
}
