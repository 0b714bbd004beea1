#include <boost/test/unit_test.hpp>

#include <ricochet/batch/lane_solver.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {
using many = lanes<xsimd::batch<double>, 2>;
using model_type = decltype(viscous_jkr(std::declval<support::scene>()));

std::vector<lane_task<model_type>> tasks(std::size_t count) {
  scenes random(9);
  std::vector<lane_task<model_type>> all;
  for (std::size_t i = 0; i < count; ++i) {
    const auto s = random.next();
    all.push_back({laws_in_si<double>(viscous_jkr(s)), in_si(s.speed) * random.log_uniform(0.3, 2), 1e-8});
  }
  return all;
}

/// At the smaller of both step tolerances.
std::vector<lane_solution> solved(const std::vector<lane_task<model_type>>& all, long max_evaluations = 1'000'000) {
  scenes random(9);
  const auto model = viscous_jkr(random.next());
  std::vector<lane_solution> found(all.size()), rough(all.size());
  std::vector<int> told(all.size());
  lane_solver<model_type, many>(model, max_evaluations)
      .solve(
          all.size(), [&](std::size_t i) { return all[i]; },
          [&](std::size_t i, bool fine, const lane_solution& solution) {
            (fine ? found : rough)[i] = solution;
            told[i] += fine ? 10 : 1;
          });
  for (std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST(told[i] == 11);
    BOOST_TEST((found[i].fate == lane_fate::set_aside || found[i].steps > rough[i].steps));
  }
  return found;
}
} // namespace

BOOST_AUTO_TEST_CASE(every_task_is_solved_once_however_many_there_are) {
  const auto all = tasks(5 * many::size + 3);
  const auto expected = solved(all);
  for (const std::size_t count : {std::size_t(1), many::size - 1, many::size, many::size + 1}) {
    const auto some = solved({all.begin(), all.begin() + std::ptrdiff_t(count)});
    for (std::size_t i = 0; i < count; ++i) {
      BOOST_TEST(some[i].restitution == expected[i].restitution);
      BOOST_TEST(some[i].excess == expected[i].excess);
      BOOST_TEST(some[i].steps == expected[i].steps);
    }
  }
  bool some_captured = false, some_let_go = false;
  for (const auto& solution : expected) {
    BOOST_TEST((solution.fate == lane_fate::captured) == (solution.excess < 0));
    some_captured |= solution.fate == lane_fate::captured;
    some_let_go |= solution.fate == lane_fate::let_go;
    if (solution.fate == lane_fate::let_go) // all that is left is kinetic energy
      BOOST_TEST(std::abs(solution.excess - solution.restitution * solution.restitution) < 1e-12);
  }
  BOOST_TEST(some_captured);
  BOOST_TEST(some_let_go);
}

BOOST_AUTO_TEST_CASE(who_takes_too_long_is_set_aside) {
  for (const auto& solution : solved(tasks(many::size), 20))
    BOOST_TEST((solution.fate == lane_fate::set_aside));
}

BOOST_AUTO_TEST_CASE(edges_of_finite_speed_run_in_lanes) {
  const auto shared = std::make_shared<const greenwood_table>(0.02);
  const auto compose_from = [&](const support::scene& s) {
    return viscous_jkr(s, greenwood{.relaxation_time = 5.0 * s.relaxation_time,
                                    .modulus_ratio = 0.02,
                                    .interaction_range = s.interaction_range,
                                    .table = shared});
  };
  using edge_model = decltype(compose_from(std::declval<support::scene>()));
  scenes random(12);
  std::vector<edge_model> models;
  std::vector<double> speeds;
  for (int i = 0; i < 200; ++i) {
    const auto s = random.next();
    models.push_back(compose_from(s));
    speeds.push_back(in_si(s.speed));
  }
  int ended = 0, wrong = 0;
  lane_solver<edge_model, many>(models[0], 1'000'000)
      .solve(
          models.size(),
          [&](std::size_t i) {
            return lane_task<edge_model>{laws_in_si<double>(models[i]), speeds[i], 1e-8};
          },
          [&](std::size_t i, bool, const lane_solution& solution) {
            if (solution.fate == lane_fate::set_aside)
              return;
            ++ended;
            const speed v = speeds[i] * metres_per_second;
            const scales unit = scales_at(models[i], v);
            const reduced_model<double, edge_model> numbers(models[i], unit);
            collision<decltype(numbers), stepper::tsitouras_papakostas75> alone(numbers, 1e-9, 1'000'000);
            const auto expected = alone.solve(reduce<double>(v, unit));
            const double e = solution.fate == lane_fate::let_go ? solution.restitution : 0;
            wrong += !(std::abs(e - expected.restitution.value_or(0)) < 1e-8);
          });
  BOOST_TEST(ended > 380);
  BOOST_TEST(wrong == 0);
}
