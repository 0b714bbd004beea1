#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/solve/stepper/steppers.hpp>

using namespace support;

namespace {

const auto model = [] {
  scenes source(51);
  const scene s = source.next();
  return viscous_jkr(s);
}();
using model_type = std::remove_const_t<decltype(model)>;
using reduced_type = reduced_model<double, model_type>;

/// Error of one step of size h against many small ones.
template <class Stepper>
double step_error(double h) {
  const reduced_type numbers(model, scales_at(model, 1.0 * metres_per_second));
  flow<reduced_type> f{numbers};
  auto x = numbers.touch(1.0);
  typename Stepper::template method<flow<reduced_type>> method(1e3, numbers.typical());
  const auto one = method.try_step(f, x, h);
  BOOST_TEST(one.accepted); // whatever its error, at this tolerance
  stepper::fehlberg78::method<flow<reduced_type>> fine(1e3, numbers.typical());
  auto exact = x;
  for (int i = 0; i < 64; ++i) {
    exact = fine.try_step(f, exact, h / 64).x;
    fine.moved();
  }
  return std::abs(one.x[approach_rate] - exact[approach_rate]);
}

/// Measured order of the local error, which is one above that of the method.
template <class Stepper>
double local_order(double h) {
  return std::log2(step_error<Stepper>(h) / step_error<Stepper>(h / 2));
}

} // namespace

BOOST_AUTO_TEST_CASE(steps_have_their_order) {
  BOOST_TEST(std::abs(local_order<stepper::runge_kutta4>(0.4) - 5) < 0.7);
  BOOST_TEST(std::abs(local_order<stepper::runge_kutta_gill>(0.4) - 5) < 0.7);
  BOOST_TEST(std::abs(local_order<stepper::cash_karp54>(0.2) - 6) < 0.7);
  BOOST_TEST(std::abs(local_order<stepper::dopri5>(0.2) - 6) < 0.7);
  BOOST_TEST(local_order<stepper::fehlberg78>(0.8) > 7.5); // close to round-off soon
}

BOOST_AUTO_TEST_CASE(part_of_a_step_keeps_the_order) {
  const reduced_type numbers(model, scales_at(model, 1.0 * metres_per_second));
  flow<reduced_type> f{numbers};
  const auto x = numbers.touch(1.0);
  stepper::fehlberg78::method<flow<reduced_type>> method(1e-10, numbers.typical());
  method.try_step(f, x, 0.2);
  const auto part = method.within(f, x, 0.07);
  method.moved();
  const auto direct = method.try_step(f, x, 0.07).x;
  BOOST_TEST(part[approach_rate] == direct[approach_rate]);
}

BOOST_AUTO_TEST_CASE(a_step_out_of_the_domain_is_rejected) {
  scenes source(52);
  const scene s = source.next();
  const auto crack = viscoelastic_jkr(s);
  const reduced_model<double, decltype(crack)> numbers(crack, scales_at(crack, s.speed));
  flow<std::remove_const_t<decltype(numbers)>> f{numbers};
  auto x = numbers.touch(1.0);
  x[mutual_approach] = 1e3; // a^2 - delta R < 0
  stepper::dopri5::method<decltype(f)> method(1e-3, numbers.typical());
  const auto tried = method.try_step(f, x, 0.1);
  BOOST_TEST(!tried.accepted);
  BOOST_TEST(f.outside);
  BOOST_TEST(tried.next < 0.1);
}

BOOST_AUTO_TEST_CASE(step_sizes_follow_the_error) {
  using stepper::resized;
  BOOST_TEST(resized(1.0, 1.0, 5) == 0.9);
  BOOST_TEST(resized(1.0, 1e-30, 5) == 5);  // grows no faster
  BOOST_TEST(resized(1.0, 1e30, 5) == 0.1); // shrinks no faster
  BOOST_TEST(resized(1.0, std::numeric_limits<double>::infinity(), 5) == 0.25);
  BOOST_TEST(resized(1.0, 0.0, 5) == 5);
}
