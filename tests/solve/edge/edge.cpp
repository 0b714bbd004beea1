#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

using namespace support;

namespace {

const ice_case ice;
const auto fitted = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted());
using fitted_model = reduced_model<double, std::remove_const_t<decltype(fitted)>>;
using fitted_edge = edge_pieces<fitted_model>;

/// A state of this model with sqrt(beta) = b at contact radius y^2 and this approach rate.
fitted_model::state_type state_at(const fitted_model& numbers, double y, double b, double rate) {
  fitted_model::state_type x{};
  x[root_contact_radius] = y;
  x[approach_rate] = rate;
  const double flat = numbers.elastic.load_free_approach(numbers.pair, y * y);
  x[mutual_approach] = flat - b * numbers.adhesion.flattening(numbers.pair) * y;
  return x;
}

} // namespace

BOOST_AUTO_TEST_CASE(steps_are_graded_towards_a_kink_and_away_from_it) {
  kink_grading<double> kink{.closest = 1e-5};
  BOOST_TEST(kink.graded(0.1, std::numeric_limits<double>::infinity()) == 0.1);
  BOOST_TEST(std::abs(kink.graded(0.1, 0.04) - 0.016) < 1e-12); // two fifths of the way
  BOOST_TEST(kink.graded(0.1, 1e-6) == 2e-5);                   // over it
  kink.crossed();
  BOOST_TEST(kink.graded(0.1, 1.0) == 1e-5);
  kink.since = 1e-2;
  BOOST_TEST(std::abs(kink.graded(0.1, 1.0) - 12e-3) < 1e-12);
  for (int i = 0; i < 8; ++i)
    kink.crossed();
  BOOST_TEST(kink.closest < 1e-7); // crossed again and again: an edge that relaxes fast
}

BOOST_AUTO_TEST_CASE(pieces_know_their_joints) {
  // joints at 0.29, 1, 3.7: pieces 0 and 1 close, 2 and 3 open
  BOOST_TEST(!fitted_edge::has_kink(0, true));
  BOOST_TEST(fitted_edge::has_kink(1, true));
  BOOST_TEST(fitted_edge::has_kink(2, false));
  BOOST_TEST(!fitted_edge::has_kink(2, true));
  BOOST_TEST(!fitted_edge::has_kink(0, false));
  BOOST_TEST(!fitted_edge::has_kink(3, true));
  BOOST_TEST(!fitted_edge::has_kink(fitted_model::sliding(0), true));
  BOOST_TEST(fitted_edge::grows(0));
  BOOST_TEST(fitted_edge::grows(1));
  BOOST_TEST(!fitted_edge::grows(2));
  BOOST_TEST(!fitted_edge::grows(3));
  BOOST_TEST(fitted_edge::grows(fitted_model::sliding(0)));
  BOOST_TEST(!fitted_edge::grows(fitted_model::sliding(2)));
}

BOOST_AUTO_TEST_CASE(an_edge_that_both_sides_push_back_is_held_at_the_joint) {
  const fitted_model numbers(fitted, scales_at(fitted, 8.0 * metres_per_second));
  const fitted_edge edge(numbers);
  const double y = 1.2 * numbers.typical()[root_contact_radius], b = std::sqrt(0.29);
  // The approach rate that keeps beta at the joint lies between what the two pieces ask for.
  int held = 0, passed = 0;
  for (double rate = 0.05; rate < 20; rate *= 1.001) {
    const auto x = state_at(numbers, y, b, rate);
    const bool below_pushes_up = numbers.root_ratio_rate(x, 0) > 0, above_pushes_up = numbers.root_ratio_rate(x, 1) > 0;
    if (below_pushes_up && !above_pushes_up) {
      ++held;
      BOOST_TEST(edge.beyond(x, 0, true) == fitted_model::sliding(0));
      BOOST_TEST(edge.beyond(x, 1, false) == fitted_model::sliding(0));
    } else if (below_pushes_up) {
      ++passed;
      BOOST_TEST(edge.beyond(x, 0, true) == 1);
    }
  }
  BOOST_TEST((held > 0 || passed > 0));
  const auto x = state_at(numbers, y, b, 1.0);
  BOOST_TEST(edge.beyond(x, fitted_model::sliding(0), true) == 1);
  BOOST_TEST(edge.beyond(x, fitted_model::sliding(0), false) == 0);
}

BOOST_AUTO_TEST_CASE(only_past_the_fold_and_opening_may_the_edge_let_go) {
  const fitted_model numbers(fitted, scales_at(fitted, 8.0 * metres_per_second));
  const fitted_edge edge(numbers);
  const double y = numbers.fold_coordinate();
  const auto before = state_at(numbers, 1.5 * y, 1.2, -1), past = state_at(numbers, 0.8 * y, 2.5, -1);
  BOOST_TEST(!edge.may_let_go(before, 3));
  BOOST_TEST(edge.may_let_go(past, 3));
  BOOST_TEST(!edge.may_let_go(past, 0));
}

BOOST_AUTO_TEST_CASE(time_to_kink_is_finite_only_on_the_way_to_it) {
  const fitted_model numbers(fitted, scales_at(fitted, 8.0 * metres_per_second));
  const fitted_edge edge(numbers);
  const double y = 1.2 * numbers.typical()[root_contact_radius];
  const auto slow = state_at(numbers, y, 0.9, 0.0); // at rest, the closing edge relaxes towards beta = 1
  BOOST_TEST(std::isfinite(edge.time_to_kink(slow, 1)));
  const auto away = state_at(numbers, y, 0.9, 100.0); // compression drives it away
  BOOST_TEST(std::isinf(edge.time_to_kink(away, 1)));
}
