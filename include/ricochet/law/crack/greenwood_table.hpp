#pragma once
#include <ricochet/law/crack/cohesive_zone.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace ricochet {

/// A smooth function of asinh(Q/Q0) as polynomials on pieces of equal width, from Q = 0 upward.
/// Below 0 its value at 0 is continued: the law's slowness, Q times this, then runs on linearly.
class greenwood_curve {
public:
  static constexpr int degree = 12;
  static constexpr double width = 0.5;
  static constexpr double last = 1e18; ///< Q of the last point; beyond it the edge stands still to round-off

  /// `shape(Q)` is called with ascending Q > 0 in long double.
  template <class Shape>
  greenwood_curve(double unit, Shape shape) : unit_(unit) {
    const int pieces = int(std::asinh(last / unit) / width) + 1;
    coefficients_.resize(std::size_t(pieces));
    for (int p = 0; p < pieces; ++p)
      coefficients_[std::size_t(p)] = interpolate([&](long double t) {
        return shape(unit * std::sinh((static_cast<long double>(p) + (1 + t) / 2) * static_cast<long double>(width)));
      });
  }

  /// value and d(value)/dQ at Q.
  template <class T>
  T value(const T& Q) const {
    const auto [piece, t] = locate(Q);
    T sum = 0;
    for (int j = degree; j >= 0; --j)
      sum = sum * t + T((*piece)[std::size_t(j)]);
    return sum;
  }
  double slope(double Q) const {
    if (Q <= 0)
      return 0;
    const auto [piece, t] = locate(Q);
    double sum = 0;
    for (int j = degree; j >= 1; --j)
      sum = sum * t + j * (*piece)[std::size_t(j)];
    return sum * (2 / width) / std::hypot(unit_, Q);
  }

private:
  using polynomial = std::array<double, degree + 1>; // powers of t in [-1, 1]

  template <class T>
  std::pair<const polynomial*, T> locate(const T& Q) const {
    const T clamped = std::clamp(Q, T(0), T(last));
    const T x = std::asinh(clamped / T(unit_)) / T(width);
    const std::size_t p = std::min(std::size_t(x), coefficients_.size() - 1);
    return {&coefficients_[p], 2 * (x - T(p)) - 1};
  }

  /// Chebyshev's nodes, ascending, and the powers of t in the polynomial that is one at node i and zero at the others.
  struct interpolation {
    static constexpr std::size_t n = degree + 1;
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
  template <class F>
  static polynomial interpolate(const F& f) {
    static const interpolation at;
    std::array<long double, interpolation::n> c{};
    for (std::size_t i = 0; i < interpolation::n; ++i) {
      const long double y = f(at.nodes[i]);
      for (std::size_t m = 0; m < interpolation::n; ++m)
        c[m] += y * at.powers[i][m];
    }
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

} // namespace ricochet
