#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ricochet::closed_form::detail {

/// A function of y in [0, last] as polynomials in x from -1 to 1 over equal pieces of ln(1 + y), or of ln(1 + sqrt y)
/// where it goes in powers of sqrt y.
template <std::size_t Pieces, std::size_t Terms>
struct polynomial_pieces {
  static_assert(Terms % 2 == 0);
  static constexpr std::size_t pieces = Pieces, terms = Terms;
  double last;
  bool in_roots;
  double pieces_per_position; ///< Pieces over the position of `last`
  std::array<std::array<double, Terms>, Pieces> coefficients{};

  double operator()(double y) const {
    const double place = std::log1p(in_roots ? std::sqrt(y) : y) * pieces_per_position;
    const std::size_t piece = std::min(std::size_t(place), Pieces - 1);
    const double x = 2 * (place - double(piece)) - 1, square = x * x;
    const std::array<double, Terms>& c = coefficients[piece];
    double even = c[Terms - 2], odd = c[Terms - 1]; // two short chains instead of a long one
    for (std::size_t k = Terms - 2; k >= 2; k -= 2) {
      even = even * square + c[k - 2];
      odd = odd * square + c[k - 1];
    }
    return even + x * odd;
  }
};

} // namespace ricochet::closed_form::detail
