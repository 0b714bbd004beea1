#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ricochet::closed_form::detail {

/// A function of y in [0, last] as Chebyshev series over equal pieces of ln(1 + y), or of ln(1 + sqrt y) where it goes
/// in powers of sqrt y.
template <std::size_t Pieces, std::size_t Terms>
struct chebyshev_pieces {
  static constexpr std::size_t pieces = Pieces, terms = Terms;
  double last;
  bool in_roots;
  std::array<std::array<double, Terms>, Pieces> coefficients{};

  double operator()(double y) const {
    const double place = position(y) * (Pieces / position(last));
    const std::size_t piece = std::min(std::size_t(place), Pieces - 1);
    const double x = 2 * (place - double(piece)) - 1;
    const std::array<double, Terms>& c = coefficients[piece];
    double later = 0, now = 0; // Clenshaw's recurrence
    for (std::size_t k = Terms - 1; k > 0; --k) {
      const double next = 2 * x * now - later + c[k];
      later = now;
      now = next;
    }
    return x * now - later + c[0];
  }

  /// y at x in [-1, 1] of this piece.
  double argument(std::size_t piece, double x) const {
    const double grown = std::expm1((double(piece) + (x + 1) / 2) / Pieces * position(last));
    return in_roots ? grown * grown : grown;
  }

private:
  double position(double y) const { return std::log1p(in_roots ? std::sqrt(y) : y); }
};

} // namespace ricochet::closed_form::detail
