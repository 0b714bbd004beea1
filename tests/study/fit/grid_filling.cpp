#include <boost/test/unit_test.hpp>

#include <ricochet/number.hpp>
#include <ricochet/study/fit/grid_filling.hpp>

#include <numeric>

using ricochet::detail::grid_filling;

namespace {

std::vector<double> evenly(double low, double high, std::size_t n) {
  std::vector<double> all(n);
  for (std::size_t i = 0; i < n; ++i)
    all[i] = low + (high - low) * double(i) / double(n - 1);
  return all;
}

struct filling {
  double worst = 0; ///< error of a square root
  std::size_t evaluated = 0, all = 0;
};

/// Functions f(i, x, y), squares, on the grid of these positions.
template <class Function>
filling filled(const std::vector<std::vector<double>>& positions, std::size_t count, double allowed,
               const Function& f) {
  grid_filling grid(positions, count);
  const std::size_t rows = positions[0].size(), columns = positions[1].size();
  const auto value = [&](std::size_t element) {
    const std::size_t point = element % (rows * columns);
    return f(element / (rows * columns), positions[0][point / columns], positions[1][point % columns]);
  };
  filling result;
  std::size_t last_told = 0;
  grid.fill(
      allowed,
      [&](const std::vector<std::size_t>& wanted, std::vector<double>& found) {
        result.evaluated += wanted.size();
        std::transform(wanted.begin(), wanted.end(), found.begin(), value);
      },
      [&](std::size_t known) {
        BOOST_TEST(known >= last_told);
        last_told = known;
      });
  result.all = count * rows * columns;
  BOOST_TEST(last_told == result.all);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < rows * columns; ++j)
      result.worst =
          std::max(result.worst, std::abs(std::sqrt(grid.at(i, j)) - std::sqrt(value(i * rows * columns + j))));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(smooth_functions_take_few_values) {
  const auto smooth = [](std::size_t i, double x, double y) { return std::exp(-x - double(i) * y) + 0.1 * x * y; };
  const auto found = filled({evenly(0, 1, 60), evenly(0, 2, 80)}, 3, 1e-6, smooth);
  BOOST_TEST(found.worst < 1e-6);
  BOOST_TEST(found.evaluated < found.all / 10);
  const auto descending = filled({evenly(1, 0, 60), evenly(0, 2, 80)}, 3, 1e-6, smooth);
  BOOST_TEST(descending.worst < 1e-6);
  BOOST_TEST(descending.evaluated < found.all / 10);
}

BOOST_AUTO_TEST_CASE(a_threshold_is_followed) {
  // Zero beyond a curve, as of pairs that stick: with a square that goes to zero linearly, and with one that jumps.
  for (const double jump : {0., 0.01})
    for (const double bend : {-3., 0., 0.5, 3.}) {
      const auto sticking = [&](std::size_t, double x, double y) {
        const double left = 1.1 - x - 0.3 * std::sin(bend * y);
        return left > 0 ? left * (1 + 0.2 * y * y) + jump : 0;
      };
      const auto found = filled({evenly(0, 2, 100), evenly(-1, 1, 100)}, 1, 1e-6, sticking);
      BOOST_TEST(found.worst < 1e-6, "jump " << jump << ", bend " << bend << ": " << found.worst);
      BOOST_TEST(found.evaluated < found.all / 2);
    }
}

BOOST_AUTO_TEST_CASE(an_island_that_reaches_the_border_is_followed_along_it) {
  const auto island = [](std::size_t, double x, double y) {
    const double left = 0.09 - ricochet::square(x - 0.5) - ricochet::square(y);
    return left > 0 ? left : 0;
  };
  const auto found = filled({evenly(0, 1, 100), evenly(0, 1, 100)}, 1, 1e-6, island);
  BOOST_TEST(found.worst < 1e-6);
}

BOOST_AUTO_TEST_CASE(without_order_or_with_few_points_all_are_evaluated) {
  const auto smooth = [](std::size_t, double x, double y) { return 1 + x * y; };
  std::vector<double> mixed = evenly(0, 1, 40);
  std::swap(mixed[3], mixed[30]);
  const auto found = filled({mixed, evenly(0, 1, 10)}, 1, 1e-6, smooth);
  BOOST_TEST(found.worst == 0);
  BOOST_TEST(found.evaluated == found.all);
  BOOST_TEST(!grid_filling({mixed, evenly(0, 1, 10)}, 1).fills_in());
  BOOST_TEST(grid_filling({mixed, evenly(0, 1, 11)}, 1).fills_in());
  const auto twice = filled({std::vector<double>(20, 0.5), evenly(0, 1, 5)}, 1, 1e-6, smooth); // all the same
  BOOST_TEST(twice.evaluated == twice.all);
}
