#include <boost/test/unit_test.hpp>

#include <ricochet/closed_form/polynomial_pieces.hpp>

namespace {
using pieces = ricochet::closed_form::detail::polynomial_pieces<2, 4>;
} // namespace

/// A table of 1 + x + x^2 + x^3 on its first piece and of 10 times that on its second.
BOOST_AUTO_TEST_CASE(each_piece_has_its_polynomial_in_minus_one_to_one) {
  for (const bool in_roots : {false, true}) {
    const double last = in_roots ? 9 : 3, position = std::log(4.); // of both
    const pieces table{.last = last,
                       .in_roots = in_roots,
                       .pieces_per_position = 2 / position,
                       .coefficients = {{{1, 1, 1, 1}, {10, 10, 10, 10}}}};
    const auto argument = [&](double place) { // 0 to 2, a piece each
      const double grown = std::expm1(place * position / 2);
      return in_roots ? grown * grown : grown;
    };
    for (const double place : {0.0, 0.25, 0.5, 0.875, 1.125, 1.75, 2.0}) {
      const double x = 2 * (place < 1 ? place : place - 1) - 1;
      const double expected = (place < 1 ? 1 : 10) * (1 + x * (1 + x * (1 + x)));
      BOOST_TEST(std::abs(table(argument(place)) - expected) < 1e-13); // x to some roundings, times slope 60
    }
  }
}
