#pragma once
#include <ricochet/number.hpp>

#include <algorithm>
#include <array>
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

  double operator()(double y) const { return at(place(y)); }

  /// Where y lies on the pieces: piece 0 from 0 to 1, and so on.
  template <class T>
  T place(const T& y) const {
    return log1p(in_roots ? T(sqrt(y)) : y) * T(pieces_per_position);
  }

  double at(double place) const {
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
