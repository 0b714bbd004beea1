#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/fit/chi_square_grid.hpp>
#include <ricochet/study/sweep.hpp>

using namespace support;

namespace {
const ice_case ice;

const auto family = [](const std::array<double, 3>& p) {
  return compose(ice.pair, hertz{}, jkr{p[0] * joules_per_square_metre}, kuwabara_kono{p[1] * seconds},
                 thornton_ning{p[2] * pascals});
};
const std::array axes{logarithmic_axis("work_of_adhesion", 0.1, 1.6, 9), logarithmic_axis("bulk_time", 1e-11, 1e-9, 5),
                      logarithmic_axis("yield_strength", 1e8, 1e10, 7)};

std::vector<measurement> measured(const auto& model) {
  std::vector<measurement> data;
  for (const speed& v : logarithmic_speeds(0.5 * metres_per_second, 60.0 * metres_per_second, 12))
    data.push_back({v, collide(model, impact{v}, {.tolerance = 1e-9}).restitution});
  return data;
}
} // namespace

BOOST_AUTO_TEST_CASE(chi_square_is_the_mean_square_deviation_of_every_collision) {
  const auto data = measured(family({0.5, 2e-10, 6e8}));
  const auto grid = scan_chi_square(family, data, axes, {.tolerance = 1e-8});
  BOOST_TEST(grid.collisions == 9 * 5 * 12); // the yield strength needs none of its own
  for (std::size_t i = 0; i < 9; i += 4)
    for (std::size_t j = 0; j < 5; j += 2)
      for (std::size_t k = 0; k < 7; k += 3) {
        const auto model = family({axes[0].values[i], axes[1].values[j], axes[2].values[k]});
        double sum = 0;
        for (const measurement& each : data)
          sum += square(collide(model, impact{each.speed}).restitution.value_or(0) - each.restitution.value_or(0));
        BOOST_TEST(std::abs(grid.at({i, j, k}) - sum / 12) < 1e-7);
      }
  // The same when the yield strength is an axis like the others.
  const auto turned = scan_chi_square(
      [](const std::array<double, 3>& p) {
        return family({p[1], p[2], p[0]});
      },
      data, std::array{axes[2], axes[0], axes[1]}, {.tolerance = 1e-8});
  BOOST_TEST(turned.collisions == 7 * 9 * 5 * 12);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < 7; ++k)
      BOOST_TEST(std::abs(grid.at({i, 3, k}) - turned.at({k, i, 3})) < 1e-7);
}

BOOST_AUTO_TEST_CASE(losses_are_those_of_each_row) {
  // What is lost to plastic flow depends on the modulus too, or the yield strength is not the last axis.
  const auto stiffened = [](const std::array<double, 2>& p) {
    contact_pair pair = ice.pair;
    pair.reduced_modulus *= p[0];
    return compose(pair, hertz{}, ice.adhesive, kuwabara_kono{1e-10 * seconds}, thornton_ning{p[1] * pascals});
  };
  const auto held = [](const std::array<double, 2>& p) {
    return compose(ice.pair, hertz{}, ice.adhesive, kuwabara_kono{p[1] * seconds}, thornton_ning{p[0] * pascals});
  };
  const auto agrees = [](const auto& of, const std::array<grid_axis, 2>& of_axes, std::size_t collisions) {
    const auto data = measured(of({of_axes[0].values[1], of_axes[1].values[0]}));
    const auto grid = scan_chi_square(of, data, of_axes, {.tolerance = 1e-8});
    BOOST_TEST(grid.collisions == collisions);
    BOOST_TEST(grid.at({1, 0}) < 1e-15);
    for (std::size_t i = 0; i < of_axes[0].values.size(); ++i)
      for (std::size_t j = 0; j < of_axes[1].values.size(); ++j) {
        double sum = 0;
        for (const measurement& each : data)
          sum += square(
              collide(of({of_axes[0].values[i], of_axes[1].values[j]}), impact{each.speed}).restitution.value_or(0) -
              each.restitution.value_or(0));
        BOOST_TEST(std::abs(grid.at({i, j}) - sum / 12) < 1e-7);
      }
  };
  agrees(stiffened, {grid_axis{"stiffening", {1, 1.5, 2}}, grid_axis{"yield_strength", {2e8, 3e8, 4e8}}}, 3 * 12);
  agrees(held, {grid_axis{"yield_strength", {2e8, 3e8, 4e8}}, grid_axis{"bulk_time", {1e-10}}}, 3 * 12);
}

BOOST_AUTO_TEST_CASE(the_best_point_and_the_ranges) {
  const std::array<std::size_t, 3> truth{4, 2, 3};
  const auto data = measured(family({axes[0].values[4], axes[1].values[2], axes[2].values[3]}));
  // Scattered by hand, so that chi^2 has a least value of its own.
  auto scattered = data;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (scattered[i].restitution)
      *scattered[i].restitution += i % 2 ? 0.05 : -0.05;
  const auto grid = scan_chi_square(family, scattered, axes);
  BOOST_TEST((grid.best == truth));
  const double least = grid.at(grid.best);
  BOOST_TEST(std::abs(least - 0.05 * 0.05 *
                                  double(std::count_if(data.begin(), data.end(),
                                                       [](const auto& m) { return m.restitution.has_value(); })) /
                                  12) < 1e-4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const grid_range& found = grid.ranges[axis];
    BOOST_TEST(found.best == axes[axis].values[truth[axis]]);
    BOOST_TEST((found.low <= found.low_alone && found.low_alone <= found.best));
    BOOST_TEST((found.high >= found.high_alone && found.high_alone >= found.best));
    // One step further, with all others as they are, chi^2 is more than twice the least.
    auto beyond = truth;
    while (beyond[axis] + 1 < axes[axis].values.size() && axes[axis].values[beyond[axis]] <= found.high_alone)
      ++beyond[axis];
    if (axes[axis].values[beyond[axis]] > found.high_alone)
      BOOST_TEST(grid.at(beyond) > 2 * least);
  }
}

BOOST_AUTO_TEST_CASE(fine_grids_are_filled_in_from_fewer_collisions) {
  const auto with_edge = [](const std::array<double, 3>& p) {
    return compose(ice.pair, hertz{}, jkr{p[0] * joules_per_square_metre}, ice.exact(p[1] * seconds),
                   kuwabara_kono{bulk_time_of_krijt(p[1] * seconds, 0.25)}, thornton_ning{p[2] * pascals});
  };
  const std::array fine{logarithmic_axis("work_of_adhesion", 0.2, 2, 40),
                        logarithmic_axis("relaxation_time", 1e-12, 1e-10, 40),
                        logarithmic_axis("yield_strength", 1e8, 1e9, 3)};
  std::vector<measurement> data;
  for (const double v : {3., 8., 30.})
    data.push_back({v * metres_per_second, std::nullopt});
  std::size_t told = 0, of_all = 0;
  const auto grid =
      scan_chi_square(with_edge, data, fine, {.tolerance = 1e-6, .progress = [&](std::size_t done, std::size_t of) {
                                                told = done;
                                                of_all = of;
                                              }});
  BOOST_TEST(grid.collisions < 3 * 40 * 40 * 3 / 4);
  BOOST_TEST((told == 3 * 40 * 40 && of_all == told));
  // Of pairs that are all measured as stuck chi^2 is the mean of e^2.
  const std::size_t k = 2;
  double worst = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    std::vector<ricochet::scene<decltype(with_edge({}))>> scenes;
    for (std::size_t j = 0; j < 40; ++j)
      for (const measurement& each : data)
        scenes.push_back({with_edge({fine[0].values[i], fine[1].values[j], fine[2].values[k]}), impact{each.speed}});
    const auto outcomes = collide(scenes, {.tolerance = 1e-8});
    for (std::size_t j = 0; j < 40; ++j) {
      double sum = 0;
      for (std::size_t n = 0; n < 3; ++n)
        sum += square(outcomes[3 * j + n].restitution.value_or(0));
      worst = std::max(worst, std::abs(grid.at({i, j, k}) - sum / 3));
    }
  }
  BOOST_TEST(worst < 2e-6); // of e^2, with errors of 1e-6 in e
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(scan_chi_square(family, {}, axes), bad_input);
  BOOST_CHECK_THROW(logarithmic_axis("w", 1, 0.5, 3), bad_input);
  BOOST_CHECK_THROW(logarithmic_axis("w", 1, 2, 1), bad_input);
  auto none = axes;
  none[1].values.clear();
  BOOST_CHECK_THROW(scan_chi_square(family, measured(family({0.5, 2e-10, 6e8})), none), bad_input);
}
