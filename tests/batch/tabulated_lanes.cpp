#include <boost/test/unit_test.hpp>

#include <ricochet/batch/batch.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {

static_assert(closed_form::tabulated<decltype(viscous_hertz(std::declval<support::scene>()))>);
static_assert(closed_form::tabulated<decltype(hunt_crossley_hertz(std::declval<support::scene>()))>);
static_assert(!closed_form::tabulated<decltype(tsuji_hertz(std::declval<support::scene>()))>);
static_assert(!closed_form::tabulated<decltype(viscous_hertz(std::declval<support::scene>(), energy_ledger{}))>);

/// From no damping to more than the tables hold.
template <class Compose>
void agrees_one_by_one(const Compose& composed) {
  scenes random(21);
  std::vector<ricochet::scene<decltype(composed(random.next(), 1.))>> batch;
  for (const double times : {0., 1e-300, 1e-12, 1e-6, 1e-3, 0.1, 1., 10., 1e2, 1e3, 1e5})
    for (int i = 0; i < 37; ++i) {
      const auto s = random.next();
      batch.push_back({composed(s, times), impact{s.speed}});
    }
  const auto found = collide(batch, {.tolerance = 1e-8});
  int beyond = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto alone = collide(batch[i].model, batch[i].impact, {.tolerance = 1e-8});
    BOOST_TEST_REQUIRE((found[i].ending == alone.ending));
    beyond += alone.evaluations > 0;
    const double difference = std::abs(found[i].restitution.value_or(0) - alone.restitution.value_or(0));
    BOOST_TEST_REQUIRE(difference <= alone.error_estimate);
    BOOST_TEST_REQUIRE(found[i].error_estimate == alone.error_estimate);
  }
  using damping = decltype(batch[0].model.damping);
  constexpr bool solved_beyond = std::same_as<damping, hunt_crossley>;
  BOOST_TEST((beyond > 0) == !solved_beyond);
}

} // namespace

BOOST_AUTO_TEST_CASE(outcomes_are_those_of_lone_impacts) {
  agrees_one_by_one([](const auto& s, double times) { return hertzian(s, kuwabara_kono{times * s.bulk_time}); });
  agrees_one_by_one(
      [](const auto& s, double times) { return hertzian(s, hunt_crossley{times * s.hunt_crossley_coefficient}); });
}
