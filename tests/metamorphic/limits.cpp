// Limits in which a law drops out of a collision, and what is conserved where nothing is lost.
// RICOCHET_SCENES sets the number of random scenes of each relation (60 unless given).
#include <boost/test/unit_test.hpp>

#include "metamorphic/relation.hpp"

#include <ricochet/closed_form/maugis_dugdale.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>

using namespace metamorphic;

namespace {

constexpr double tight = 1e-10;
const std::string dampings[] = {"", "+kuwabara_kono", "+hunt_crossley", "+tsuji"};

/// Restitutions of `laws` tend to those of `limit` as `weaken(scene, factor)` takes a law's parameter to zero, and they
/// do so with at least this power of it.
template <class Weaken>
void tends(const std::string& laws, const std::string& limit, double power, const Weaken& weaken,
           double tolerance = tight) {
  double furthest = 0, nearest = 0;
  for_random_scenes(11, 60, [&](const scene& s) {
    const summary end = composed_of(limit).integrate(s, tolerance);
    if (!end.ended() || end.restitution < 0.1) // near sticking e has an infinite slope
      return;
    const auto apart = [&](double factor) {
      scene weaker = s;
      weaken(weaker, factor);
      const summary out = composed_of(laws).integrate(weaker, tolerance);
      BOOST_TEST(out.ended(), name_of(out.ending));
      BOOST_TEST(out.error_estimate <= tolerance);
      return std::abs(out.restitution - end.restitution);
    };
    const double weak = apart(1e-3), weaker = apart(1e-5);
    furthest = std::max(furthest, weak), nearest = std::max(nearest, weaker);
    BOOST_TEST_CONTEXT(laws << ", apart by " << weak << " and " << weaker)
    BOOST_TEST(weaker <= 1.5 * weak * std::pow(1e-2, power) + 2 * tolerance);
  });
  BOOST_TEST_MESSAGE(laws << " to " << limit << ": apart by " << furthest << ", then " << nearest);
  BOOST_TEST(furthest > 10 * tolerance); // else nothing was tested
}

} // namespace

BOOST_AUTO_TEST_CASE(weak_adhesion_leaves_hertz) {
  for (const std::string& damping : dampings) {
    // Bodies that adhere, however little, pull until their overlap has gone.
    const std::string limit = "hertz" + damping + "+end_at_zero_overlap";
    const auto weaker = [](scene& s, double factor) { s.work_of_adhesion *= factor, s.force_per_length *= factor; };
    // JKR's pull goes with the root of w; without damping, what it gives in one half it takes in the other.
    tends("jkr" + damping, limit, damping.empty() ? 5. / 3 : 0.5, weaker);
    tends("maugis_dugdale" + damping, limit, 1, weaker);
    if (!damping.empty())
      tends("dmt" + damping, limit, 1, weaker);
    tends("line_force" + damping, limit, 1, weaker);
  }
}

BOOST_AUTO_TEST_CASE(weak_damping_leaves_the_adhesion) {
  for (const std::string laws : {"hertz", "jkr", "dmt", "line_force", "maugis_dugdale"})
    for (const std::string& damping : dampings)
      if (!damping.empty())
        tends(laws + damping, laws, 1, [](scene& s, double factor) {
          s.bulk_time *= factor, s.hunt_crossley_coefficient *= factor, s.tsuji_coefficient *= factor;
        });
  tends("greenwood+kuwabara_kono", "greenwood", 1, [](scene& s, double factor) { s.bulk_time *= factor; });
}

BOOST_AUTO_TEST_CASE(fast_edges_leave_jkr) {
  const auto faster = [](scene& s, double factor) { s.relaxation_time *= factor, s.edge_speed /= factor; };
  // The edge lags where JKR's lets go: an opening speed ~ (G/w - 1)^(1/n) loses ~ T^(2n/(n + 2)), here with n = 1 but
  // for logarithms, or n >= 0.3.
  tends("greenwood", "jkr", 0.6, faster);
  for (const std::string edge : {"greenwood", "greenwood_fit"})
    tends(edge + "+kuwabara_kono", "jkr+kuwabara_kono", 0.6, faster);
  // At 1e-10 one in a hundred of these edges, 1e8 times faster than the bodies, is given up, and says so.
  tends("maugis_barquins+kuwabara_kono", "jkr+kuwabara_kono", 0.26, faster, 1e-8);
}

BOOST_AUTO_TEST_CASE(a_solid_that_hardly_creeps_has_no_slow_edge) {
  // G stays between k w and w/k: what the edge takes goes with 1 - k where it is at these limits, and with the power of
  // 2/3 where it lags but a little behind JKR's; 0.2^{2/3} = 0.34.
  for_random_scenes(12, 60, [](scene s) {
    const double jkr = composed_of("jkr").integrate(s, tight).restitution;
    if (jkr < 0.1)
      return;
    const auto lost = [&](double k) {
      s.modulus_ratio = k;
      return jkr - composed_of("greenwood").integrate(s, tight).restitution;
    };
    const double at_90 = lost(0.9), at_98 = lost(0.98);
    BOOST_TEST_CONTEXT("lost at k = 0.9 " << at_90 << ", at 0.98 " << at_98) {
      BOOST_TEST(at_98 > 0);
      BOOST_TEST(at_98 < 0.36 * at_90);
    }
  });
}

BOOST_AUTO_TEST_CASE(strong_solids_do_not_yield) {
  for_random_scenes(13, 60, [](scene s) {
    s.yield_strength *= 1e6;
    for (const auto& [laws, limit] : {std::pair("jkr+thornton_ning", "jkr"),
                                      {"hertz+thornton_ning_contact", "hertz"},
                                      {"jkr+thornton_ning_contact", "jkr"},
                                      {"jkr+kuwabara_kono+thornton_ning_contact", "jkr+kuwabara_kono"}}) {
      const summary out = composed_of(laws).integrate(s, tight), elastic = composed_of(limit).integrate(s, tight);
      BOOST_TEST_CONTEXT(laws) {
        BOOST_TEST(out.plastic_loss == 0);
        BOOST_TEST(std::abs(out.restitution - elastic.restitution) * elastic.restitution <= 2e-14); // same steps
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(conservative_contacts_give_all_back_in_the_time_that_they_took) {
  const auto check = [](const auto& model, speed v) {
    const auto out = integrate(model, impact{v}, {.tolerance = tight});
    BOOST_TEST(std::abs(out.restitution.value_or(0) - 1) <= out.error_estimate);
    BOOST_TEST(out.error_estimate <= tight);
    const auto& rows = out.trajectory;
    const auto deepest = std::max_element(rows.mutual_approach.begin(), rows.mutual_approach.end());
    const double turning = rows.time[std::size_t(deepest - rows.mutual_approach.begin())];
    BOOST_TEST(std::abs(2 * turning / in_si(out.contact_duration) - 1) < 1e-9);
  };
  for_random_scenes(14, 60, [&](const scene& s) {
    check(hertzian(s, contact_duration{}, trajectory{}), s.speed);
    check(hertzian(s, dmt{s.work_of_adhesion}, contact_duration{}, trajectory{}), s.speed);
    check(hertzian(s, line_force{s.force_per_length, {}}, contact_duration{}, trajectory{}), s.speed);
  });
}

BOOST_AUTO_TEST_CASE(static_edges_lose_their_jumps_only) {
  // The energies of JKR's and of Maugis' branches where they begin and end, whatever happens between.
  for_random_scenes(15, 60, [](const scene& s) {
    const auto check = [&](const char* laws, const std::optional<double>& balance) {
      const summary out = composed_of(laws).integrate(s, tight);
      BOOST_TEST_CONTEXT(laws) {
        BOOST_TEST((balance.has_value() == (out.ending == ending::separated)));
        BOOST_TEST(std::abs(out.restitution - balance.value_or(0)) <= out.error_estimate + 1e-14);
      }
    };
    check("jkr", closed_form::restitution(s.pair, s.work_of_adhesion, s.speed));
    const maugis_dugdale cohesive{s.work_of_adhesion, s.interaction_range};
    check("maugis_dugdale", closed_form::maugis_dugdale_contact(s.pair, cohesive).restitution(s.speed));
  });
}
