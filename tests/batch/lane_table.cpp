#include <boost/test/unit_test.hpp>

#include <ricochet/batch/lane_table.hpp>

#include <random>

using namespace ricochet;
using many = lanes<xsimd::batch<double>, 2>;

BOOST_AUTO_TEST_CASE(each_lane_reads_its_own_table) {
  std::vector<greenwood_table> tables;
  for (const double k : {1e-4, 0.02, 0.3, 0.98})
    tables.emplace_back(k);
  lane_greenwood_table<xsimd::batch<double>, 2> side_by_side;
  for (std::size_t lane = 0; lane < many::size; ++lane)
    side_by_side.put(lane, tables[lane % tables.size()]);
  std::mt19937 random(3);
  std::uniform_real_distribution<> logarithm(-30, 40), even(0, 1);
  for (int i = 0; i < 10'000; ++i) {
    many Q, side;
    for (std::size_t lane = 0; lane < many::size; ++lane) {
      const double ends[] = {0, -0.0, -1, -1e300, 1e15, 1e300, std::exp(logarithm(random)), 1 / 16., 1.};
      Q.put(lane, ends[i < 100 ? random() % std::size(ends) : 6]);
      side.put(lane, even(random));
    }
    const many found = side_by_side.value(side < many(0.5), Q);
    for (std::size_t lane = 0; lane < many::size; ++lane) {
      const auto& table = tables[lane % tables.size()];
      const double expected = (side[lane] < 0.5 ? table.closing : table.opening).value(Q[lane]);
      // products and sums may be fused here and not there
      BOOST_TEST_REQUIRE(std::abs(found[lane] - expected) <= 4e-16 * std::abs(expected));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_reads_nothing_beyond_the_table) {
  const greenwood_table table(0.02);
  lane_greenwood_table<xsimd::batch<double>, 2> side_by_side;
  for (std::size_t lane = 0; lane < many::size; ++lane)
    side_by_side.put(lane, table);
  const many found = side_by_side.value(many(0) < many(1), many(std::numeric_limits<double>::quiet_NaN()));
  BOOST_TEST(found[0] == table.closing.value(0.));
}
