#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>

using namespace support;

namespace {

/// Numbers of adhesion, crack, damping and end laws that go with one elastic law.
constexpr role_count legal[] = {
    {1, 0, 0, 0, 0}, {1, 0, 0, 0, 1}, {1, 0, 0, 1, 0}, {1, 0, 0, 1, 1}, // without adhesion: an end condition, no crack
    {1, 1, 0, 0, 0}, {1, 1, 0, 1, 0}, {1, 1, 1, 0, 0}, {1, 1, 1, 1, 0}, // with adhesion: a crack law, no end condition
};

bool is_legal(const role_count& n) {
  for (const role_count& each : legal)
    if (each.elastic == n.elastic && each.adhesion == n.adhesion && each.crack == n.crack &&
        each.damping == n.damping && each.end == n.end)
      return true;
  return false;
}

/// What is the matter with n, by name of the roles that the sentence has to mention.
bool explains(std::string_view sentence, const role_count& n) {
  const auto says = [&](std::string_view words) { return sentence.find(words) != sentence.npos; };
  return (says("needs an elastic law") && n.elastic == 0) || (says("two elastic laws") && n.elastic > 1) ||
         (says("two adhesion laws") && n.adhesion > 1) || (says("two crack-velocity laws") && n.crack > 1) ||
         (says("two bulk damping laws") && n.damping > 1) || (says("two end conditions") && n.end > 1) ||
         (says("needs an adhesion law") && n.crack && !n.adhesion) || (says("without adhesion") && n.end && n.adhesion);
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
static_assert(!composable<linear, jkr> && !composable<linear, jkr, greenwood> && !composable<linear, thornton_ning>);

static_assert(count_roles<linear>().edgeless == 1 && count_roles<hertz, jkr>().edgeless == 0);
static_assert(count_roles<jkr, hertz, tsuji, extremes>().adhesion == 1);
static_assert(count_roles<jkr, hertz, tsuji, extremes>().crack == 0);
static_assert(count_roles<greenwood, greenwood_fit>().crack == 2);
static_assert(count_roles<jkr, dmt>().adhesion == 2 && count_roles<jkr, dmt>().attraction == 1);

} // namespace

BOOST_AUTO_TEST_CASE(the_table_of_refusals) {
  int accepted = 0;
  for (int i = 0; i < 243; ++i) { // none, one or two of each role
    const role_count n{i % 3, i / 3 % 3, i / 9 % 3, i / 27 % 3, i / 81 % 3};
    const std::string_view sentence = refusal(n);
    BOOST_TEST_CONTEXT(n.elastic << n.adhesion << n.crack << n.damping << n.end << ": " << sentence) {
      BOOST_TEST(sentence.empty() == is_legal(n));
      BOOST_TEST((sentence.empty() || explains(sentence, n)));
    }
    accepted += sentence.empty();
  }
  BOOST_TEST(accepted == 8);
}
