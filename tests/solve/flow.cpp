#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

BOOST_AUTO_TEST_CASE(a_flow_is_an_odeint_system_that_counts_and_tells_when_it_is_outside) {
  scenes source(61);
  const scene s = source.next();
  const auto model = viscoelastic_jkr(s);
  using reduced_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
  const reduced_type numbers(model, scales_at(model, s.speed));
  flow<reduced_type> f{numbers};
  auto x = numbers.touch(1.0);
  reduced_type::state_type dx{};
  f(x, dx, 0.0);
  BOOST_TEST(f.evaluations == 1);
  BOOST_TEST(!f.outside);
  BOOST_TEST(dx[root_contact_radius] > 0); // the contact grows from touch on
  BOOST_TEST(dx[mutual_approach] > 0);
  x[mutual_approach] = 1e3;
  f(x, dx, 0.0);
  BOOST_TEST(f.outside);
  for (const double component : dx)
    BOOST_TEST(component == 0);
}
