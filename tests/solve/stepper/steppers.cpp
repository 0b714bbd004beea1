#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/solve/stepper/steppers.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

using namespace support;

namespace {

/// Every stepper that the README lists gives the same restitution, within its own error estimate.
template <class Stepper, class Compose>
void agrees(const Compose& compose_scene, double tolerance, int count) {
  scenes source(41);
  for (int i = 0; i < count; ++i) {
    const scene s = source.next();
    const auto model = compose_scene(s);
    const auto out =
        collide(model, impact{s.speed}, {.tolerance = tolerance, .max_evaluations = 20'000'000}, Stepper{});
    const auto fine = integrate(model, impact{s.speed}, {.tolerance = 1e-11});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(name_of(out.ending) == name_of(fine.ending));
      BOOST_TEST(out.error_estimate <= tolerance);
      BOOST_TEST(std::abs(out.restitution.value_or(0) - fine.restitution.value_or(0)) <= tolerance);
    }
  }
}

template <class Stepper>
void on_smooth_models(double tolerance) {
  agrees<Stepper>([](const scene& s) { return viscous_hertz(s); }, tolerance, 20);
  agrees<Stepper>([](const scene& s) { return tsuji_hertz(s); }, tolerance, 20);
  agrees<Stepper>([](const scene& s) { return viscous_jkr(s); }, tolerance, 20);
}

template <class Stepper>
void on_a_free_edge(double tolerance, int count) {
  agrees<Stepper>(
      [](scene s) { // not stiff
        s.relaxation_time *= 20;
        return viscoelastic_jkr(s);
      },
      tolerance, count);
}

} // namespace

BOOST_AUTO_TEST_CASE(fehlberg78) {
  on_smooth_models<stepper::fehlberg78>(1e-9);
  on_a_free_edge<stepper::fehlberg78>(1e-9, 10);
}
BOOST_AUTO_TEST_CASE(dopri5) {
  on_smooth_models<stepper::dopri5>(1e-8);
  on_a_free_edge<stepper::dopri5>(1e-7, 10);
}
BOOST_AUTO_TEST_CASE(cash_karp54) {
  on_smooth_models<stepper::cash_karp54>(1e-8);
  on_a_free_edge<stepper::cash_karp54>(1e-7, 10);
}
BOOST_AUTO_TEST_CASE(runge_kutta4_by_halved_steps) {
  on_smooth_models<stepper::runge_kutta4>(1e-6);
  on_a_free_edge<stepper::runge_kutta4>(1e-5, 5);
}
BOOST_AUTO_TEST_CASE(runge_kutta_gill_by_halved_steps) {
  on_smooth_models<stepper::runge_kutta_gill>(1e-7);
  on_a_free_edge<stepper::runge_kutta_gill>(1e-5, 5);
}
BOOST_AUTO_TEST_CASE(bulirsch_stoer) {
  on_smooth_models<stepper::bulirsch_stoer>(1e-8);
  on_a_free_edge<stepper::bulirsch_stoer>(1e-6, 5);
}
BOOST_AUTO_TEST_CASE(bulirsch_stoer_with_dense_output) {
  on_smooth_models<stepper::bulirsch_stoer_dense_out>(1e-7);
  on_a_free_edge<stepper::bulirsch_stoer_dense_out>(1e-5, 5);
}
BOOST_AUTO_TEST_CASE(radau_of_orders_five_and_nine) {
  on_smooth_models<stepper::radau<3>>(1e-6);
  on_a_free_edge<stepper::radau<3>>(1e-6, 5);
  on_smooth_models<stepper::radau<5>>(1e-9);
  on_a_free_edge<stepper::radau<5>>(1e-8, 5);
}
BOOST_AUTO_TEST_CASE(any_other_odeint_stepper_plugs_in) {
  agrees<stepper::embedded_of_odeint<boost::numeric::odeint::runge_kutta_dopri5>>(
      [](const scene& s) { return viscous_hertz(s); }, 1e-7, 3);
  agrees<stepper::doubled_of_odeint<boost::numeric::odeint::runge_kutta4>>(
      [](const scene& s) { return viscous_hertz(s); }, 1e-6, 3);
}
