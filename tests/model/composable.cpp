#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

#include <algorithm>
#include <utility>

using namespace support;

namespace {

/// What makes a contact: adhesion, how many of it are forces without an edge, crack law and end condition. Each goes
/// with or without bulk damping.
struct contact_kind {
  int adhesion, attraction, crack, end;
};
constexpr contact_kind legal[] = {{0, 0, 0, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}, {1, 0, 1, 0}, {1, 1, 0, 0}};

bool is_legal(const role_count& n) {
  const auto is_that_of = [&](const contact_kind& each) {
    return n.adhesion == each.adhesion && n.attraction == each.attraction && n.crack == each.crack && n.end == each.end;
  };
  const bool contact = std::any_of(std::begin(legal), std::end(legal), is_that_of);
  const bool beside = n.tangential + n.plasticity <= 1; // friction or plastic flow or neither
  return n.elastic == 1 && contact && n.damping <= 1 && beside && !(n.flow && (n.crack || n.attraction));
}

/// What is the matter with n, by name of the roles that the sentence has to mention.
bool explains(std::string_view sentence, const role_count& n) {
  const auto says = [&](std::string_view words) { return sentence.find(words) != sentence.npos; };
  return (says("needs an elastic law") && n.elastic == 0) || (says("two elastic laws") && n.elastic > 1) ||
         (says("two adhesion laws") && n.adhesion > 1) || (says("two crack-velocity laws") && n.crack > 1) ||
         (says("two bulk damping laws") && n.damping > 1) || (says("two end conditions") && n.end > 1) ||
         (says("two tangential laws") && n.tangential > 1) || (says("two plasticity laws") && n.plasticity > 1) ||
         (says("crack-velocity law needs an adhesion law") && n.crack && n.adhesion == n.attraction) ||
         (says("contacts without adhesion") && n.end && n.adhesion) ||
         (says("drop the tangential law or the plasticity law") && n.tangential && n.plasticity) ||
         (says("goes with a static edge") && n.flow && n.crack) ||
         (says("goes with an adhesion law with a surface energy") && n.flow && n.attraction);
}

// The predicate on the laws themselves.
using a = end_at_zero_overlap;
static_assert(composable<hertz> && composable<hertz, jkr> && composable<hertz, kuwabara_kono, a>);
static_assert(composable<hertz, jkr, greenwood> && composable<greenwood_fit, tsuji, jkr, hertz>);
static_assert(composable<hertz, energy_ledger, extremes, trajectory, contact_duration>);
static_assert(!composable<> && !composable<jkr> && !composable<hertz, hertz> && !composable<hertz, greenwood>);
static_assert(!composable<hertz, jkr, a> && !composable<hertz, tsuji, kuwabara_kono> && !composable<hertz, int>);
static_assert(composable<hertz, line_force, hunt_crossley> && composable<dmt, hertz>);
static_assert(!composable<hertz, line_force, greenwood> && !composable<hertz, dmt, a> && !composable<hertz, dmt, jkr>);
static_assert(!composable<hertz, jkr, greenwood, greenwood_fit> && !composable<hertz, jkr, jkr>);
static_assert(!composable<hertz, end_at_zero_force, end_at_zero_overlap>);
static_assert(composable<linear> && composable<linear, linear_dashpot, a> && composable<hertz, jkr, linear_dashpot>);
static_assert(composable<linear, dmt, tsuji> && composable<linear, line_force> && !composable<linear, hertz>);
static_assert(composable<linear, coulomb, linear_dashpot> && !composable<linear, mindlin>);
static_assert(!composable<linear, jkr> && !composable<linear, jkr, greenwood> && !composable<linear, thornton_ning>);
static_assert(composable<hertz, thornton_ning_contact, a> && composable<tsuji, thornton_ning_contact, jkr, hertz>);
static_assert(composable<hertz, jkr, greenwood, thornton_ning> && composable<hertz, dmt, thornton_ning>);
static_assert(!composable<hertz, jkr, greenwood, thornton_ning_contact>);
static_assert(!composable<hertz, dmt, thornton_ning_contact> && !composable<hertz, coulomb, thornton_ning_contact>);
static_assert(!composable<hertz, thornton_ning, thornton_ning_contact> && !composable<hertz, coulomb, thornton_ning>);
static_assert(composable<hertz, mindlin> && composable<hertz, dmt, mindlin, tsuji> && composable<hertz, jkr, coulomb>);
static_assert(!composable<hertz, jkr, mindlin> && !composable<hertz, jkr, greenwood, mindlin>);
static_assert(composable<hertz, line_force, coulomb_with_peeling, tsuji>);
static_assert(!composable<hertz, coulomb_with_peeling> && !composable<hertz, dmt, coulomb_with_peeling>);
static_assert(!composable<hertz, jkr, coulomb_with_peeling> &&
              !composable<hertz, jkr, greenwood, coulomb_with_peeling>);
static_assert(!composable<hertz, line_force, coulomb, coulomb_with_peeling>);
static_assert(!composable<hertz, line_force, coulomb_with_peeling, thornton_ning>);
static_assert(!composable<hertz, mindlin, coulomb> && !composable<hertz, mindlin, thornton_ning>);

static_assert(composable<hertz, maugis_dugdale> && composable<maugis_dugdale, tsuji, hertz, thornton_ning>);
static_assert(!composable<hertz, maugis_dugdale, coulomb> && !composable<hertz, maugis_dugdale, mindlin>);
static_assert(!composable<hertz, maugis_dugdale, greenwood> && !composable<linear, maugis_dugdale>);
static_assert(!composable<hertz, maugis_dugdale, thornton_ning_contact> && !composable<hertz, maugis_dugdale, a>);
static_assert(!composable<hertz, maugis_dugdale, jkr> && count_roles<maugis_dugdale>().cohesion == 1);

static_assert(count_roles<linear>().edgeless == 1 && count_roles<hertz, jkr>().edgeless == 0);
static_assert(count_roles<jkr, hertz, tsuji, extremes>().adhesion == 1);
static_assert(count_roles<jkr, hertz, tsuji, extremes>().crack == 0);
static_assert(count_roles<greenwood, greenwood_fit>().crack == 2);
static_assert(count_roles<thornton_ning, coulomb>().plasticity == 1 && count_roles<thornton_ning>().flow == 0);
static_assert(count_roles<thornton_ning_contact>().plasticity == 1 && count_roles<thornton_ning_contact>().flow == 1);
static_assert(count_roles<coulomb, mindlin>().tangential == 2 && count_roles<coulomb, mindlin>().stick_slip == 1);
static_assert(count_roles<coulomb_with_peeling>().tangential == 1 && count_roles<coulomb_with_peeling>().peeling == 1);
static_assert(count_roles<coulomb, mindlin>().peeling == 0 && count_roles<jkr, dmt>().rebounding == 0);
static_assert(count_roles<line_force>().attraction == 1 && count_roles<line_force>().rebounding == 1);
static_assert(count_roles<jkr, dmt>().adhesion == 2 && count_roles<jkr, dmt>().attraction == 1);

} // namespace

BOOST_AUTO_TEST_CASE(the_table_of_refusals) {
  int accepted = 0, failed = 0;
  for (int i = 0; i < 19683;
       ++i) { // none, one or two of each role, and how many of adhesion and plasticity are special
    int rest = i;
    const auto next = [&] { return std::exchange(rest, rest / 3) % 3; };
    role_count n{.elastic = next(), .adhesion = next(), .crack = next(), .damping = next(), .end = next()};
    n.tangential = next(), n.plasticity = next(), n.attraction = next(), n.flow = next();
    if (n.attraction > n.adhesion || n.flow > n.plasticity || rest != 0)
      continue;
    const std::string_view sentence = refusal(n);
    if (sentence.empty() != is_legal(n) || !(sentence.empty() || explains(sentence, n))) {
      BOOST_TEST_MESSAGE(n.elastic << n.adhesion << n.attraction << n.crack << n.damping << n.end << n.tangential
                                   << n.plasticity << n.flow << ": " << sentence);
      ++failed;
    }
    accepted += sentence.empty();
  }
  BOOST_TEST(failed == 0);
  BOOST_TEST(accepted ==
             2 * (3 * 5 + 3)); // each contact alone, with friction, with added plastic loss; three with flow
}

BOOST_AUTO_TEST_CASE(the_table_of_refusals_with_friction_and_plastic_flow) {
  int accepted = 0;
  // With one elastic law; adhesion: none, jkr, dmt, line_force, maugis_dugdale; friction: none, coulomb, mindlin, with
  // a peeling moment, two laws.
  for (int i = 0; i < 150; ++i) {
    const int adhesion = i % 5, crack = i / 5 % 2, friction = i / 10 % 5, plasticity = i / 50 % 3;
    const role_count n{.elastic = 1,
                       .adhesion = adhesion != 0,
                       .crack = crack,
                       .attraction = adhesion == 2 || adhesion == 3,
                       .tangential = friction == 4 ? 2 : friction != 0,
                       .plasticity = plasticity,
                       .stick_slip = friction == 2,
                       .peeling = friction >= 3,
                       .rebounding = adhesion == 3,
                       .cohesion = adhesion == 4};
    const std::string_view sentence = refusal(n);
    const auto says = [&](std::string_view words) { return sentence.find(words) != sentence.npos; };
    const bool surface_energy = adhesion == 1, peels = adhesion == 3, cohesive = adhesion == 4;
    const bool legal = (!crack || surface_energy) && friction < 4 && plasticity < 2 && !(friction && plasticity) &&
                       !(friction == 2 && surface_energy) && (friction != 3 || peels) && !(friction && cohesive);
    BOOST_TEST_CONTEXT(i << ": " << sentence) {
      BOOST_TEST(sentence.empty() == legal);
      BOOST_TEST((legal || (says("two tangential laws") && friction == 4) ||
                  (says("two plasticity laws") && plasticity == 2) ||
                  (says("plastic flow is added to the normal motion only") && friction && plasticity) ||
                  (says("moves along its normal only") && friction && cohesive) ||
                  (says("stick and slip needs a Hertzian contact") && friction == 2 && surface_energy) ||
                  (says("needs an adhesion law with a rebound coefficient") && friction == 3 && !peels) ||
                  (says("needs an adhesion law with a surface energy") && crack && !surface_energy)));
    }
    accepted += legal;
  }
  // five contacts: bare, with coulomb, with plastic loss; three with mindlin, one peels; maugis_dugdale bare, with loss
  BOOST_TEST(accepted == 21);
}
