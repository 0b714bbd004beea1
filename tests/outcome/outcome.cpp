#include <boost/test/unit_test.hpp>

#include <ricochet/outcome/outcome.hpp>
#include <ricochet/units.hpp>

using namespace ricochet;

namespace {

template <requests Asked>
using outcome = basic_outcome<double, length, duration, force, speed, Asked>;
using plain = outcome<requests{}>;
using with_ledger = outcome<requests{.ledger = true}>;
using with_duration = outcome<requests{.duration = true}>;
using with_extremes = outcome<requests{.extremes = true}>;
using with_trajectory = outcome<requests{.trajectory = true}>;
using with_all = outcome<requests{true, true, true, true}>;

template <class T>
concept has_ledger = requires(T x) {
  x.crack_loss, x.bulk_loss, x.remaining_energy, x.ledger_residual;
};
template <class T>
concept has_duration = requires(T x) {
  x.contact_duration;
};
template <class T>
concept has_extremes = requires(T x) {
  x.max_approach, x.max_contact_radius, x.max_tension, x.max_compression;
};
template <class T>
concept has_trajectory = requires(T x) {
  x.trajectory.time, x.trajectory.bulk_loss;
};

// What was not asked for is not there, and what was is.
static_assert(!has_ledger<plain> && !has_duration<plain> && !has_extremes<plain> && !has_trajectory<plain>);
static_assert(has_ledger<with_ledger> && !has_duration<with_ledger> && !has_extremes<with_ledger>);
static_assert(has_duration<with_duration> && !has_ledger<with_duration> && !has_trajectory<with_duration>);
static_assert(has_extremes<with_extremes> && !has_ledger<with_extremes> && !has_duration<with_extremes>);
static_assert(has_trajectory<with_trajectory> && !has_ledger<with_trajectory> && !has_extremes<with_trajectory>);
static_assert(has_ledger<with_all> && has_duration<with_all> && has_extremes<with_all> && has_trajectory<with_all>);

// A motion with plastic flow has its loss and what it leaves, and no other has.
using flowing = basic_outcome<double, length, duration, force, speed, requests{}, false, true>;
using flowing_traced = basic_outcome<double, length, duration, force, speed, requests{.trajectory = true}, false, true>;
template <class T>
concept has_flow = requires(T x) {
  x.plastic_loss, x.residual_approach;
};
static_assert(has_flow<flowing> && !has_flow<with_all> && !has_trajectory<flowing>);
static_assert(std::same_as<length, decltype(flowing{}.residual_approach)>);

// Nothing unasked takes room; each part takes its own.
struct bare {
  ricochet::ending ending;
  std::optional<double> restitution;
  bool ending_is_certain;
  double error_estimate;
  int contacts;
  long evaluations, rejected_steps;
  std::string reason;
};
static_assert(sizeof(plain) == sizeof(bare));
static_assert(sizeof(with_ledger) == sizeof(bare) + 4 * sizeof(double));
static_assert(sizeof(with_duration) == sizeof(bare) + sizeof(double));
static_assert(sizeof(with_extremes) == sizeof(bare) + 4 * sizeof(double));
static_assert(sizeof(with_trajectory) == sizeof(bare) + 11 * sizeof(std::vector<double>));
static_assert(sizeof(flowing) == sizeof(bare) + 2 * sizeof(double));
static_assert(sizeof(flowing_traced) == sizeof(flowing) + 12 * sizeof(std::vector<double>));

// The quantities have their dimensions.
static_assert(std::same_as<length, decltype(with_all{}.max_approach)>);
static_assert(std::same_as<force, decltype(with_all{}.max_tension)>);
static_assert(std::same_as<duration, decltype(with_all{}.contact_duration)>);
static_assert(std::same_as<double, decltype(with_all{}.crack_loss)>);

} // namespace

BOOST_AUTO_TEST_CASE(names_of_endings) {
  BOOST_TEST(name_of(ending::separated) == std::string("separated"));
  BOOST_TEST(name_of(ending::captured) == std::string("captured"));
  BOOST_TEST(name_of(ending::unresolved) == std::string("unresolved"));
  BOOST_TEST(name_of(ending::failed) == std::string("failed"));
}

BOOST_AUTO_TEST_CASE(an_outcome_not_filled_in_has_failed) {
  const with_all out;
  BOOST_TEST((out.ending == ending::failed));
  BOOST_TEST(!out.restitution.has_value());
  BOOST_TEST(out.contacts == 1);
  BOOST_TEST((out.evaluations == 0 && out.rejected_steps == 0));
  BOOST_TEST((out.crack_loss == 0 && out.bulk_loss == 0 && out.remaining_energy == 0 && out.ledger_residual == 0));
  BOOST_TEST((out.max_approach == length{} && out.contact_duration == duration{} && out.max_tension == force{}));
  BOOST_TEST(out.trajectory.time.empty());
}
