#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {

static_assert(plays<energy_ledger, role::request> && plays<contact_duration, role::request>);
static_assert(plays<extremes, role::request> && plays<trajectory, role::request>);
static_assert(requests{} == requests{false, false, false, false});
static_assert(requests{.ledger = true} != requests{.duration = true});

template <class... Asked>
constexpr requests asked = decltype(hertzian(scene{}, Asked{}...))::asked;

static_assert(asked<> == requests{});
static_assert(asked<energy_ledger> == requests{.ledger = true});
static_assert(asked<contact_duration> == requests{.duration = true});
static_assert(asked<extremes> == requests{.extremes = true});
static_assert(asked<regime_warnings> == requests{.warnings = true});
static_assert(asked<trajectory> == requests{.trajectory = true});
static_assert(asked<trajectory, contact_duration> == asked<contact_duration, trajectory>);
static_assert(asked<trajectory, extremes, contact_duration, energy_ledger> == requests{true, true, true, true});

} // namespace

BOOST_AUTO_TEST_CASE(a_request_adds_its_part_to_the_outcome_and_nothing_to_the_model) {
  const scene s = scenes(1).next();
  const auto plain = hertzian(s);
  const auto full = hertzian(s, energy_ledger{}, contact_duration{}, extremes{}, trajectory{});
  BOOST_TEST(sizeof(plain) == sizeof(full));
  BOOST_TEST(sizeof(outcome_of<decltype(plain)>) < sizeof(outcome_of<decltype(full)>));
  BOOST_TEST(sizeof(outcome_of<decltype(plain)>) < sizeof(outcome_of<decltype(hertzian(s, contact_duration{}))>));
  BOOST_TEST(std::is_empty_v<energy_ledger>);
}

BOOST_AUTO_TEST_CASE(a_request_named_twice_is_named_once) {
  const scene s = scenes(1).next();
  BOOST_TEST((std::same_as<decltype(hertzian(s, extremes{}, extremes{})), decltype(hertzian(s, extremes{}))>));
}
