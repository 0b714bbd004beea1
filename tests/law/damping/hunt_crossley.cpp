#include <boost/test/unit_test.hpp>

#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/elastic/hertz.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

const contact_pair pair{3e9 * pascals, 1e-6 * metres, 1e-14 * kilograms};
const hunt_crossley law{0.1 * seconds_per_metre};
bool same(double a, double b) { return std::abs(a / b - 1) < 2e-15; } // ten roundings

} // namespace

BOOST_AUTO_TEST_CASE(published_form_at_the_hertzian_radius) {
  const double K = 4. / 3 * 3e9 * std::sqrt(1e-6), rate = 3;
  for (const double approach : {1e-10, 4e-8}) {
    const configuration<dimensional> c{
        approach * metres, rate * metres_per_second, std::sqrt(1e-6 * approach) * metres, {}};
    const double elastic = K * std::pow(approach, 1.5); // F = K delta^{3/2}(1 + c rate)
    BOOST_TEST(same(in_si(law.coefficient(pair, c)) * rate, elastic * 0.1 * rate));
    BOOST_TEST(same(in_si(hertz::force(pair, c)) + in_si(law.coefficient(pair, c)) * rate, elastic * (1 + 0.1 * rate)));
  }
}

BOOST_AUTO_TEST_CASE(written_in_the_radius_it_does_not_see_the_approach) {
  const configuration<dimensional> pressed{1e-8 * metres, {}, 1e-7 * metres, {}},
      pulled{-1e-9 * metres, {}, 1e-7 * metres, {}};
  BOOST_TEST((law.coefficient(pair, pressed) == law.coefficient(pair, pulled)));
  BOOST_TEST(in_si(law.coefficient(pair, pulled)) > 0);
}
