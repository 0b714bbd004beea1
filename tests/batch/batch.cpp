#include <boost/test/unit_test.hpp>

#include <ricochet/batch/batch.hpp>

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>

#include "support/random_scenes.hpp"

#include <cstring>

using namespace support;

namespace {

auto ring_of(const support::scene& s) {
  // As strong as a JKR contact of this work of adhesion, as far as powers go: w = f sqrt(f/(E* R)).
  const double w = in_si(s.work_of_adhesion), ER = in_si(s.pair.reduced_modulus) * in_si(s.pair.reduced_radius);
  return line_force{.force_per_length = std::cbrt(w * w * ER) * newtons_per_metre,
                    .rebound_coefficient = s.hunt_crossley_coefficient};
}

/// Random collisions of one kind, from some that stick to some that hardly notice adhesion.
template <class Compose>
auto random_batch(const Compose& composed, std::size_t count, unsigned seed = 1) {
  scenes random(seed);
  std::vector<ricochet::scene<decltype(composed(random.next()))>> batch;
  for (std::size_t i = 0; i < count; ++i) {
    const auto s = random.next();
    batch.push_back({composed(s), impact{random.log_uniform(0.4, 2) * s.speed}});
  }
  return batch;
}

/// As stiff as a Hertzian contact is at the deepest.
linear spring_of(const support::scene& s) {
  const auto unit = scales_of(s.pair, s.speed, energy_per_area{});
  return {.stiffness = unit.mass / (unit.duration * unit.duration) * newtons_per_metre};
}
linear_dashpot dashpot_of(const support::scene& s) {
  const auto unit = scales_of(s.pair, s.speed, energy_per_area{});
  return {.damping_coefficient = 0.2 * s.tsuji_coefficient * unit.mass / unit.duration * newtons / metres_per_second};
}

/// No faster than 1e-3 of the contact time, from where on lanes give up the more of them the smaller the tolerance is.
greenwood edge_of(const support::scene& s) { return {10.0 * s.relaxation_time, s.modulus_ratio, s.interaction_range}; }

/// Yields at about the speed of the scene.
thornton_ning yielding_loss_of(const support::scene& s) {
  const thornton_ning_contact flowing = yielding(s);
  return {flowing.yield_strength};
}

template <class Function>
void for_each_kind(const Function& f) {
  f("viscous Hertz", [](const auto& s) { return viscous_hertz(s); });
  f("viscous Hertz to zero overlap", [](const auto& s) { return viscous_hertz(s, end_at_zero_overlap{}); });
  f("viscous JKR", [](const auto& s) { return viscous_jkr(s); });
  f("JKR with Hunt and Crossley's damping",
    [](const auto& s) { return static_jkr(s, hunt_crossley{s.hunt_crossley_coefficient}); });
  f("JKR with Tsuji's damping", [](const auto& s) { return static_jkr(s, tsuji{s.tsuji_coefficient}); });
  f("DMT", [](const auto& s) { return viscous_hertz(s, dmt{s.work_of_adhesion}); });
  f("Hertz with a dashpot", [](const auto& s) { return hertzian(s, dashpot_of(s)); });
  f("spring with a dashpot and DMT",
    [](const auto& s) { return compose(s.pair, spring_of(s), dashpot_of(s), dmt{s.work_of_adhesion}); });
  f("ring force", [](const auto& s) { return hunt_crossley_hertz(s, ring_of(s)); });
  f("viscoelastic JKR", [](const auto& s) { return viscous_jkr(s, edge_of(s)); });
  f("JKR with an edge of finite speed and Tsuji's damping",
    [](const auto& s) { return static_jkr(s, edge_of(s), tsuji{s.tsuji_coefficient}); });
}

template <class Outcome>
bool identical(const Outcome& a, const Outcome& b) {
  const auto same = [](double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return a.ending == b.ending && a.restitution.has_value() == b.restitution.has_value() &&
         same(a.restitution.value_or(0), b.restitution.value_or(0)) && same(a.error_estimate, b.error_estimate) &&
         a.evaluations == b.evaluations;
}

} // namespace

BOOST_AUTO_TEST_CASE(outcomes_are_those_of_lone_impacts_and_errors_below_their_estimates) {
  for_each_kind([](const char* name, const auto& composed) {
    const auto batch = random_batch(composed, 300);
    for (const double tolerance : {1e-3, 2e-4, 1e-5, 3e-6, 1e-7, 5e-8, 1e-9, 1e-11}) {
      const auto found = collide(batch, {.tolerance = tolerance});
      double worst = 0;
      long evaluations = 0;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const auto expected = integrate(batch[i].model, batch[i].impact, {.tolerance = 1e-12});
        BOOST_TEST_CONTEXT(name << ", tolerance " << tolerance << ", row " << i) {
          BOOST_TEST_REQUIRE((found[i].ending == expected.ending || !found[i].ending_is_certain));
          BOOST_TEST_REQUIRE(found[i].error_estimate <= tolerance);
          const double error = std::abs(found[i].restitution.value_or(0) - expected.restitution.value_or(0));
          BOOST_TEST(error <= found[i].error_estimate + expected.error_estimate);
          worst = std::max(worst, error);
        }
        evaluations += found[i].evaluations;
      }
      BOOST_TEST_MESSAGE(name << ", tolerance " << tolerance << ": largest error " << worst << ", "
                              << double(evaluations) / double(batch.size()) << " evaluations each");
    }
  });
}

BOOST_AUTO_TEST_CASE(wells_far_deeper_than_the_impact_are_allowed_for) {
  // Undamped, a contact without an edge gives back all; its well may be a million times as deep as the impact's energy.
  const contact_pair pair = between(sphere{materials::water_ice, 10 * micrometres}, flat_wall{materials::water_ice});
  const auto model = compose(pair, hertz{}, dmt{.work_of_adhesion = 0.74 * joules_per_square_metre});
  std::vector<impact> impacts;
  for (double v = 1e-4; v < 1; v *= 1.03)
    impacts.push_back({v * metres_per_second});
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto found = collide(model, impacts, {.tolerance = tolerance});
    for (std::size_t i = 0; i < impacts.size(); ++i)
      for (const auto& out : {found[i], integrate(model, impacts[i], {.tolerance = tolerance})})
        BOOST_TEST_CONTEXT("tolerance " << tolerance << ", speed " << in_si(impacts[i].speed)) {
          BOOST_TEST((out.ending == ending::separated || !out.ending_is_certain));
          BOOST_TEST(std::abs(1 - out.restitution.value_or(0)) <= out.error_estimate);
        }
  }
}

BOOST_AUTO_TEST_CASE(the_kink_of_a_rebound_that_is_pulled_harder_is_not_stepped_over) {
  const contact_pair pair{.reduced_modulus = 102871434.50456361 * pascals,
                          .reduced_radius = 5.5671503528674942e-05 * metres,
                          .reduced_mass = 3.4106468738939059e-09 * kilograms};
  const auto model = compose(pair, hertz{}, hunt_crossley{6.4972322938125433e-05 * seconds_per_metre},
                             line_force{.force_per_length = 2.3529522713092046 * newtons_per_metre,
                                        .rebound_coefficient = 8.4834728472334469 * seconds_per_metre});
  const std::vector<impact> impacts{{0.041823857687308105 * metres_per_second}};
  const auto found = collide(model, impacts, {.tolerance = 1e-9})[0];
  const auto expected = integrate(model, impacts[0], {.tolerance = 1e-12});
  BOOST_TEST(found.error_estimate <= 1e-9);
  BOOST_TEST(std::abs(*found.restitution - *expected.restitution) <= found.error_estimate + expected.error_estimate);
}

BOOST_AUTO_TEST_CASE(company_order_and_threads_do_not_change_a_bit) {
  for_each_kind([](const char* name, const auto& composed) {
    const auto batch = random_batch(composed, 1000, 2);
    const auto expected = collide(batch, {.threads = 1});
    const auto threaded = collide(batch, {.threads = 3});
    const std::remove_const_t<decltype(batch)> backwards(batch.rbegin(), batch.rend());
    const auto reversed = collide(backwards, {.threads = 1});
    const std::remove_const_t<decltype(batch)> some(batch.begin() + 7, batch.begin() + 20);
    const auto few = collide(some);
    for (std::size_t i = 0; i < batch.size(); ++i)
      BOOST_TEST_CONTEXT(name << ", row " << i) {
        BOOST_TEST(identical(expected[i], threaded[i]));
        BOOST_TEST(identical(expected[i], reversed[batch.size() - 1 - i]));
      }
    for (std::size_t i = 0; i < some.size(); ++i)
      BOOST_TEST(identical(few[i], expected[i + 7]));
    const auto alone = collide(batch[3].model, std::vector{batch[3].impact});
    BOOST_TEST(identical(alone[0], expected[3]));
  });
}

BOOST_AUTO_TEST_CASE(what_does_not_run_in_lanes_is_the_same_as_alone) {
  const auto check = [](const auto& batch) {
    const auto found = collide(batch);
    for (std::size_t i = 0; i < batch.size(); ++i)
      BOOST_TEST(identical(found[i], collide(batch[i].model, batch[i].impact)));
  };
  check(random_batch([](const auto& s) { return static_jkr(s); }, 20));          // closed form
  check(random_batch([](const auto& s) { return viscoelastic_jkr_fit(s); }, 3)); // four pieces with jumps between
  check(random_batch([](const auto& s) { return viscous_jkr(s, energy_ledger{}, contact_duration{}); }, 20));
}

BOOST_AUTO_TEST_CASE(plastic_loss_is_added_to_what_lanes_give) {
  const auto batch =
      random_batch([](const auto& s) { return viscous_jkr(s, yielding_loss_of(s), regime_warnings{}); }, 300);
  const auto found = collide(batch, {.tolerance = 1e-8});
  int yielded = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto alone = integrate(batch[i].model, batch[i].impact, {.tolerance = 1e-10});
    BOOST_TEST((found[i].ending == alone.ending || !found[i].ending_is_certain));
    BOOST_TEST(std::abs(found[i].restitution.value_or(0) - alone.restitution.value_or(0)) <=
               found[i].error_estimate + alone.error_estimate);
    BOOST_TEST((found[i].plastic_loss == alone.plastic_loss && found[i].warnings == alone.warnings));
    yielded += found[i].plastic_loss > 0;
  }
  BOOST_TEST((yielded > 50 && yielded < 300));
}

BOOST_AUTO_TEST_CASE(progress_is_told_until_all_is_done) {
  const auto batch = random_batch([](const auto& s) { return viscous_jkr(s); }, 1000);
  std::vector<std::size_t> told;
  collide(batch, {.threads = 2, .progress = [&](std::size_t done, std::size_t of) {
                    BOOST_TEST(of == 1000U);
                    told.push_back(done);
                  }});
  BOOST_TEST(std::is_sorted(told.begin(), told.end()));
  BOOST_TEST(told.size() > 2U);
  BOOST_TEST(told.back() == 1000U);
}

BOOST_AUTO_TEST_CASE(a_spent_budget_is_unresolved_in_batches_too) {
  const auto batch = random_batch([](const auto& s) { return viscous_jkr(s); }, 20);
  for (const auto& out : collide(batch, {.max_evaluations = 50})) {
    BOOST_TEST(name_of(out.ending) == "unresolved");
    BOOST_TEST(out.reason == "the budget of evaluations was spent");
  }
}

BOOST_AUTO_TEST_CASE(what_progress_throws_ends_the_batch) {
  const auto batch = random_batch([](const auto& s) { return viscous_jkr(s); }, 1000);
  struct enough {};
  BOOST_CHECK_THROW(collide(batch, {.threads = 2, .progress = [](std::size_t, std::size_t) { throw enough{}; }}),
                    enough);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_before_anything_is_computed) {
  auto batch = random_batch([](const auto& s) { return viscous_hertz(s); }, 100);
  bool told = false;
  const batch_options watched{.progress = [&](std::size_t, std::size_t) { told = true; }};
  batch[70].impact.speed = -1 * metres_per_second;
  BOOST_CHECK_EXCEPTION(collide(batch, watched), bad_input, [](const bad_input& e) {
    return std::string(e.what()).find("impact 70: speed = -1 m/s") != std::string::npos;
  });
  batch[70].impact.speed = 1 * metres_per_second;
  BOOST_CHECK_THROW(collide(batch, {.tolerance = 0}), bad_input);
  BOOST_TEST(!told);
  batch.clear();
  BOOST_TEST(collide(batch).empty());
}

BOOST_AUTO_TEST_CASE(outcomes_carry_warnings_where_asked_for) {
  const support::scene s = scenes(1).next();
  const auto model = viscous_hertz(s, regime_warnings{});
  const std::vector<impact> impacts{{0.01 * metres_per_second}, {1000.0 * metres_per_second}};
  const auto outcomes = collide(model, impacts);
  for (std::size_t i = 0; i < impacts.size(); ++i)
    BOOST_TEST(outcomes[i].warnings == regime_of(model, impacts[i].speed).warnings());
  BOOST_TEST(!outcomes[1].warnings.empty());
}
