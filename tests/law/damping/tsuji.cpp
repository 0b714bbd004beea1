#include <boost/test/unit_test.hpp>

#include <ricochet/law/damping/tsuji.hpp>

using namespace ricochet;
using namespace ricochet::units;

BOOST_AUTO_TEST_CASE(published_form_at_the_hertzian_radius) {
  const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
  const tsuji law{0.7};
  const double K = 4. / 3 * 3e9 * std::sqrt(1e-6);
  for (const double approach : {1e-10, 4e-8}) {
    const double a = std::sqrt(1e-6 * approach);
    const configuration<dimensional> c{approach * metres, {}, a * metres, boost::units::root<2>(a * metres)};
    const double published = 0.7 * std::sqrt(1e-14 * K) * std::pow(approach, 0.25); // alpha sqrt(m K) delta^{1/4}
    BOOST_TEST(std::abs(in_si(law.coefficient(pair, c)) / published - 1) < 2e-15);  // ten roundings
  }
}

BOOST_AUTO_TEST_CASE(asks_for_the_root_of_the_radius) {
  static_assert(tsuji::uses_root_radius);
  const basic_pair<reduced<double>> pair{3, 1, 1}; // 4 m E/3 = 4
  BOOST_TEST((tsuji_law<reduced<double>>{0.5}.coefficient(pair, {0, 0, 9, 3}) == 0.5 * 2 * 3));
}
