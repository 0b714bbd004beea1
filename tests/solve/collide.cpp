#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/solve/stepper/steppers.hpp>

using namespace support;

namespace {
const ice_case ice;
const auto model = compose(ice.pair, hertz{}, ice.viscous);

void refused(const std::function<void()>& call, const std::string& sentence) {
  BOOST_CHECK_EXCEPTION(call(), bad_input, [&](const bad_input& error) {
    BOOST_TEST_MESSAGE(error.what());
    return error.what() == sentence;
  });
}
} // namespace

BOOST_AUTO_TEST_CASE(wrong_impacts_and_options_are_refused_by_name_value_and_range) {
  const auto at = [](double v) { return impact{v * metres_per_second}; };
  refused([&] { collide(model, at(0)); }, "speed = 0 m/s is outside (0, inf) m/s");
  refused([&] { collide(model, at(-1)); }, "speed = -1 m/s is outside (0, inf) m/s");
  refused([&] { collide(model, at(INFINITY)); }, "speed = inf m/s is outside (0, inf) m/s");
  refused([&] { collide(model, at(1), {.tolerance = 0.2}); }, "tolerance = 0.2 is outside [1e-12, 0.1]");
  refused([&] { collide(model, at(1), {.tolerance = 1e-13}); }, "tolerance = 1e-13 is outside [1e-12, 0.1]");
  BOOST_CHECK_THROW(collide(model, at(NAN)), bad_input);
  BOOST_CHECK_THROW(collide(compose(ice.pair, hertz{}), at(-1)), bad_input); // closed form
}

BOOST_AUTO_TEST_CASE(closed_forms_answer_where_they_can) {
  const impact fast{8.0 * metres_per_second};
  BOOST_TEST(collide(compose(ice.pair, hertz{}, ice.adhesive), fast).evaluations == 0);
  BOOST_TEST(collide(compose(ice.pair, hertz{}, ice.adhesive, energy_ledger{}), fast).evaluations > 0);
  BOOST_TEST(integrate(compose(ice.pair, hertz{}, ice.adhesive), fast).evaluations > 0);
  BOOST_TEST(collide(compose(ice.pair, hertz{}, ice.adhesive), fast, {}, stepper::dopri5{}).evaluations > 0);
}

BOOST_AUTO_TEST_CASE(restitution_never_exceeds_one) {
  scenes source(91);
  for (int i = 0; i < 100; ++i) {
    const scene s = source.next();
    BOOST_TEST(*integrate(hertzian(s), impact{s.speed}, {.tolerance = 1e-4}).restitution <= 1);
  }
}

BOOST_AUTO_TEST_CASE(next_to_the_threshold_the_estimate_grows_and_the_ending_turns_uncertain) {
  const auto sticky = compose(ice.pair, hertz{}, ice.adhesive);
  const double threshold = in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion));
  for (const double distance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto out = integrate(sticky, impact{threshold * (1 + distance) * metres_per_second}, {.tolerance = 1e-10});
    const double exact = std::sqrt(distance * (2 + distance)) / (1 + distance);
    BOOST_TEST_CONTEXT("v/v_c - 1 = " << distance) {
      // round-off of v/v_c itself moves e by 1.1e-16/e
      BOOST_TEST(std::abs(out.restitution.value_or(0) - exact) <= out.error_estimate + 2.3e-16 / exact);
      if (distance > 1e-11)
        BOOST_TEST(name_of(out.ending) == "separated");
    }
  }
  const auto on_it = integrate(sticky, impact{threshold * metres_per_second}, {.tolerance = 1e-10});
  BOOST_TEST(!on_it.ending_is_certain);
}

BOOST_AUTO_TEST_CASE(units_of_the_scene_do_not_matter) {
  // The same numbers through scales a million million times apart: e to round-off.
  const auto viscoelastic = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  const scales unit = scales_at(viscoelastic, 8.0 * metres_per_second);
  const double e = *integrate(viscoelastic, impact{8.0 * metres_per_second}, {.tolerance = 1e-11}).restitution;
  for (const double factor : {1e-3, 1e3}) { // lengths in units of a thousandth and a thousandfold of the usual
    scales other = unit;
    other.length *= factor;
    other.duration *= factor; // the speed's unit stays
    reduced_model<double, std::remove_const_t<decltype(viscoelastic)>> numbers(viscoelastic, other);
    collision<decltype(numbers), stepper::fehlberg78> solver(numbers, 1e-14, 10'000'000);
    BOOST_TEST(std::abs(*solver.solve(1.0).restitution - e) < 1e-10);
  }
}
