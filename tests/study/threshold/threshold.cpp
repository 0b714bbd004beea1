#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/study/threshold/threshold.hpp>

using namespace support;

namespace {
const ice_case ice;
const speed low = 0.01 * metres_per_second, high = 100.0 * metres_per_second;
} // namespace

BOOST_AUTO_TEST_CASE(jkr_sticks_up_to_the_closed_form) {
  const auto found = sticking_speed(compose(ice.pair, hertz{}, ice.adhesive, energy_ledger{}), low, high);
  const speed exact = closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion);
  BOOST_TEST(std::abs(double(found.value() / exact) - 1) < 1e-9); // the width asked for
  BOOST_TEST((found.largest_captured < exact && exact < found.smallest_separated));
}

BOOST_AUTO_TEST_CASE(the_bracket_is_as_narrow_as_asked_and_its_ends_are_what_they_say) {
  const auto check = [&](const auto& model, double width) {
    const auto found = sticking_speed(model, low, high, width);
    BOOST_TEST(double(found.smallest_separated / found.largest_captured) - 1 <= width * 1.0001);
    BOOST_TEST(name_of(collide(model, impact{found.largest_captured}, {.tolerance = 1e-11}).ending) == "captured");
    BOOST_TEST(name_of(collide(model, impact{found.smallest_separated}, {.tolerance = 1e-11}).ending) == "separated");
    BOOST_TEST(found.collisions < 60);
  };
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), width);
    check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.fitted()), width);
    check(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(ice.relaxation_time)), width);
  }
}

BOOST_AUTO_TEST_CASE(brackets_that_hold_no_threshold_are_refused) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive);
  BOOST_CHECK_THROW(sticking_speed(model, 10.0 * metres_per_second, high), bad_input);
  BOOST_CHECK_THROW(sticking_speed(model, low, 0.1 * metres_per_second), bad_input);
  BOOST_CHECK_THROW(sticking_speed(model, high, low), bad_input);
  BOOST_CHECK_THROW(sticking_speed(model, low, high, 1e-13), bad_input);
  BOOST_CHECK_THROW(sticking_speed(compose(ice.pair, hertz{}), low, high), bad_input); // never sticks
}

BOOST_AUTO_TEST_CASE(two_solutions_captured_at_different_turning_points_are_both_believed) {
  // Their energies left differed by what is lost in between, which once passed for an error: the search stopped early.
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-14 * seconds), ice.viscous);
  const auto out = integrate(model, impact{1.794 * metres_per_second}, {.tolerance = 1e-7});
  BOOST_TEST(name_of(out.ending) == "captured");
  BOOST_TEST(out.ending_is_certain);
  BOOST_TEST(out.evaluations < 200'000);
  const auto found = sticking_speed(model, 0.1 * metres_per_second, 100.0 * metres_per_second, 1e-6);
  BOOST_TEST(in_si(found.smallest_separated) / in_si(found.largest_captured) - 1 < 1.1e-6);
}

BOOST_AUTO_TEST_CASE(a_first_guess_that_hits_the_threshold_is_looked_at_from_both_sides) {
  const speed exact = closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion);
  const auto found = sticking_speed(compose(ice.pair, hertz{}, ice.adhesive), 0.1 * exact, 10.0 * exact);
  BOOST_TEST(in_si(found.largest_captured) < in_si(exact));
  BOOST_TEST(in_si(found.smallest_separated) > in_si(exact));
  BOOST_TEST(in_si(found.smallest_separated) / in_si(found.largest_captured) - 1 < 1e-8);
}
