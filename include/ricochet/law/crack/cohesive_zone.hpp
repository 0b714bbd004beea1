// The exact crack law's own mathematics: a Dugdale zone closing or opening in a three-element solid.
#pragma once
#include <ricochet/number.hpp>

namespace ricochet::cohesive_zone {

/// N(alpha) = D(sqrt alpha)/sqrt alpha with Dawson's integral D, its mean I(alpha) = (1/alpha) int_0^alpha N, and their
/// complements n = 1 - N, i = 1 - I, each to full precision for any scalar; alpha > -1.
template <class T>
struct integrals {
  T N, I, n, i;
};

/// For alpha < 1 the alternating series, beyond it one of positive terms,
/// N = e^-alpha sum alpha^j/(j!(2j+1)), alpha I = e^-alpha sum (alpha^j/j!) sum_{l<j} 1/(2l+1),
/// and where e^-alpha is below round-off the asymptotic one.
template <class T>
integrals<T> evaluate_integrals(const T& alpha) {
  const T eps = std::numeric_limits<T>::epsilon();
  const T one = 1;
  if (alpha < one) {
    T term = 1, n = 0, i = 0; // term = (-alpha)^m/(3/2)_m
    for (int m = 1; m < 400; ++m) {
      term *= -alpha / (T(m) + one / 2);
      n -= term;
      i -= term / T(m + 1);
      if (term * term <= eps * eps * n * n)
        break;
    }
    return {one - n, one - i, n, i};
  }
  T N = 0, I = 0;
  if (alpha < T(8) - T(6) / T(5) * log(eps)) {
    T term = 1, odd = 0;
    for (int j = 0; j < 2000; ++j) {
      N += term / T(2 * j + 1);
      I += term * odd;
      odd += one / T(2 * j + 1);
      term *= alpha / T(j + 1);
      if (T(j) > alpha && term * odd <= eps * I / T(8))
        break;
    }
    const T decay = exp(-alpha);
    N *= decay;
    I *= decay / alpha;
  } else {
    T c = one / 2, power = one / alpha; // c_m = (2m-1)!!/2^{m+1}, power = alpha^-(m+1)
    N = c * power;
    I = (log(T(4) * alpha) + number_traits<T>::euler_gamma()) / T(2);
    for (int m = 1; m < 300; ++m) {
      c *= T(2 * m - 1) / T(2);
      power /= alpha;
      N += c * power;
      I -= c * power * alpha / T(m);
      if (c * power <= eps * N / T(8))
        break;
    }
    I /= alpha;
  }
  return {N, I, one - N, one - I};
}

/// One point of the law: Q and its derivative in alpha, and the slowness 1/v.
template <class T>
struct point {
  T ratio, slope, slowness;
};

/// Opening edge: Q = (1 - k beta)/(beta - 1) = i/I, the same for every k; slowness here is 4 alpha = pi beta/v.
template <class T>
point<T> opening(const T& alpha) {
  const auto z = evaluate_integrals(alpha);
  const T I_slope = alpha == T(0) ? T(-1) / T(3) : T((z.i - z.n) / alpha);
  return {z.i / z.I, -I_slope / (z.I * z.I), T(4) * alpha};
}

/// Closing edge: Q = (beta - k)/(1 - beta), slowness 1/v.
template <class T>
point<T> closing(const T& alpha, const T& k) {
  const auto z = evaluate_integrals(alpha);
  const T l = T(1) - k;
  const T N_slope = alpha == T(0) ? T(-2) / T(3) : T(z.n / (T(2) * alpha) - z.N);
  const T I_slope = alpha == T(0) ? T(-1) / T(3) : T((z.i - z.n) / alpha);
  const T above = k * z.i + l * z.n * z.n;
  const T below = alpha < T(1) ? T(k + l * z.n * (T(2) - z.n) - z.i) : T(z.I - l * z.N * z.N);
  const T above_slope = -k * I_slope - T(2) * l * z.n * N_slope;
  const T below_slope = I_slope - T(2) * l * z.N * N_slope;
  const T denominator = k + l * (T(2) * z.n - z.i); // 1-(1-k)(2N-I)
  return {above / below, (above_slope - above / below * below_slope) / below,
          T(4) / number_traits<T>::pi() * alpha * denominator};
}

/// alpha at which curve(alpha).ratio = Q, by Newton's method in log-log coordinates from a starting value; Q, alpha >
/// 0.
template <class T, class Curve>
T invert(const Curve& curve, const T& Q, T alpha) {
  for (int i = 0; i < 100; ++i) {
    const auto p = curve(alpha);
    T step = log(Q / p.ratio) * p.ratio / (alpha * p.slope);
    step = step > T(3) ? T(3) : step < T(-3) ? T(-3) : step;
    alpha *= exp(step);
    if (step * step <= T(16) * std::numeric_limits<T>::epsilon())
      break;
  }
  return alpha;
}

} // namespace ricochet::cohesive_zone
