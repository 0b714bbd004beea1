#pragma once
#include <ricochet/law/crack/cohesive_zone.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

namespace ricochet {

/// A function of Q >= 0 that is smooth on a logarithmic scale, as polynomials on the sixteenths of the octaves of
/// Q + Q0: which one is read off the bits of the number, without a logarithm. Below 0 its value at 0 is continued: the
/// law's slowness, Q times this, then runs on linearly.
class greenwood_curve {
public:
  static constexpr int degree = 7;
  static constexpr double last = 1e15; ///< Q of the last point; beyond it the edge stands still to round-off

  /// \param unit Q0, rounded down to a power of two. `shape(Q)` is called with ascending Q > 0 in long double.
  template <class Shape>
  greenwood_curve(double unit, Shape shape) : unit_(std::exp2(std::floor(std::log2(unit)))) {
    // The function is dear: it is interpolated on quarters of the octaves, and what comes of it on the pieces.
    constexpr int pieces_in_quarter = 1 << (piece_bits - 2);
    const std::size_t quarters = number_of(last + unit_) / pieces_in_quarter - number_of(unit_) / pieces_in_quarter + 1;
    coefficients_.reserve(quarters * pieces_in_quarter);
    double start = unit_;
    for (std::size_t i = 0; i < quarters; ++i) {
      const double half = pieces_in_quarter / per_half_piece(start);
      const auto quarter = interpolate<11>(
          [&](long double t) { return shape(static_cast<long double>(start - unit_) + (1 + t) * half); });
      for (int part = 0; part < pieces_in_quarter; ++part)
        coefficients_.push_back(rounded(interpolate<degree>([&](long double t) {
          const long double at = (2 * part + 1 + t) / pieces_in_quarter - 1;
          return std::accumulate(quarter.rbegin(), quarter.rend(), 0.0L,
                                 [at](long double sum, long double c) { return sum * at + c; });
        })));
      start += 2 * half;
    }
  }

  /// value and d(value)/dQ at Q.
  template <class T>
  T value(const T& Q) const {
    const auto [piece, t] = locate(Q);
    const T square = t * t;
    T even = T((*piece)[degree - 1]), odd = T((*piece)[degree]); // two short chains instead of a long one
    for (std::size_t j = degree - 1; j >= 2; j -= 2) {
      even = even * square + T((*piece)[j - 2]);
      odd = odd * square + T((*piece)[j - 1]);
    }
    return even + t * odd;
  }
  double slope(double Q) const {
    if (Q <= 0)
      return 0;
    const auto [piece, t] = locate(Q);
    double sum = 0;
    for (int j = degree; j >= 1; --j)
      sum = sum * t + j * (*piece)[std::size_t(j)];
    return sum * per_half_piece(Q + unit_);
  }

  using polynomial = std::array<double, degree + 1>; ///< powers of t in [-1, 1]
  static constexpr int mantissa_bits = 52, piece_bits = 4;

  double unit() const { return unit_; }
  const std::vector<polynomial>& polynomials() const { return coefficients_; }

private:
  static_assert(std::numeric_limits<double>::is_iec559 && degree % 2 == 1);
  static constexpr std::uint64_t within_piece = (std::uint64_t(1) << (mantissa_bits - piece_bits)) - 1;

  static std::size_t number_of(double x) {
    return std::size_t(std::bit_cast<std::uint64_t>(x) >> (mantissa_bits - piece_bits));
  }
  /// One over half the width of the piece in which x lies.
  static double per_half_piece(double x) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) >> mantissa_bits;
    return std::bit_cast<double>((2 * 1023 + piece_bits + 1 - exponent) << mantissa_bits);
  }

  template <class T>
  std::pair<const polynomial*, T> locate(const T& Q) const {
    const T clamped = Q > T(0) ? std::min(Q, T(last)) : T(0); // of what is no number too: there is no piece for it
    const double x = static_cast<double>(clamped) + unit_;
    const double start = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~within_piece);
    const T t = (clamped - (T(start) - T(unit_))) * T(per_half_piece(x)) - T(1);
    return {&coefficients_[number_of(x) - number_of(unit_)], t};
  }

  /// Chebyshev's nodes, ascending, and the powers of t in the polynomial that is one at node i and zero at the others.
  template <std::size_t n>
  struct interpolation {
    std::array<long double, n> nodes{};
    std::array<std::array<long double, n>, n> powers{};

    interpolation() {
      std::array<std::array<long double, n>, n> chebyshev{}; // powers of T_j
      chebyshev[0][0] = chebyshev[1][1] = 1;
      for (std::size_t j = 2; j < n; ++j)
        for (std::size_t m = 0; m < n; ++m)
          chebyshev[j][m] = (m ? 2 * chebyshev[j - 1][m - 1] : 0) - chebyshev[j - 2][m];
      for (std::size_t i = 0; i < n; ++i) {
        const long double angle = (static_cast<long double>(n - i) - 0.5L) * pi<long double>() / n;
        nodes[i] = std::cos(angle);
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t m = 0; m < n; ++m)
            powers[i][m] += (j ? 2 : 1) * std::cos(static_cast<long double>(j) * angle) / n * chebyshev[j][m];
      }
    }
  };

  /// Interpolation in ascending nodes, so that `f` may start from its last result.
  template <std::size_t Degree, class F>
  static std::array<long double, Degree + 1> interpolate(const F& f) {
    static const interpolation<Degree + 1> at;
    std::array<long double, Degree + 1> c{};
    for (std::size_t i = 0; i < c.size(); ++i) {
      const long double y = f(at.nodes[i]);
      for (std::size_t m = 0; m < c.size(); ++m)
        c[m] += y * at.powers[i][m];
    }
    return c;
  }
  static polynomial rounded(const std::array<long double, degree + 1>& c) {
    polynomial result;
    std::transform(c.begin(), c.end(), result.begin(), [](long double x) { return static_cast<double>(x); });
    return result;
  }

  double unit_;
  std::vector<polynomial> coefficients_;
};

/// The exact law for one modulus ratio k, inverted once: slowness/Q of the closing edge, and 4 alpha/Q of the opening
/// one, as functions of Q. Immutable; share it among all models of the same k.
struct greenwood_table {
  double modulus_ratio;
  greenwood_curve closing, opening;

  explicit greenwood_table(double k)
      : modulus_ratio(k),
        closing(k * k / 200,
                [k, alpha = 1e-6L * k](long double Q) mutable {
                  const auto curve = [k](long double a) { return cohesive_zone::closing<long double>(a, k); };
                  alpha = cohesive_zone::invert<long double>(curve, Q, alpha);
                  return curve(alpha).slowness / Q;
                }),
        opening(0.1, [alpha = 1e-3L](long double Q) mutable {
          alpha = cohesive_zone::invert<long double>(cohesive_zone::opening<long double>, Q, alpha);
          return 4 * alpha / Q;
        }) {}
};

/// How a law on numbers of this type holds its table.
template <class T>
struct greenwood_table_of {
  using type = std::shared_ptr<const greenwood_table>;
};

} // namespace ricochet
