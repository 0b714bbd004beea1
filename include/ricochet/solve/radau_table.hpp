#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace ricochet::stepper {

/// Coefficients of the collocation method at the right Radau points with this many stages, order 2 stages - 1, made
/// from their definition [Hairer & Wanner, Solving ODEs II, IV.5, IV.8; their code RADAU].
template <int stages>
struct radau_table {
  using vector = Eigen::Matrix<double, stages, 1>;
  using square_matrix = Eigen::Matrix<double, stages, stages>;
  template <class Shape>
  struct complex {
    Shape real, imaginary;
  };
  static constexpr int spectrum = (stages + 1) / 2; ///< the real eigenvalue of A^-1 and one of each conjugate pair

  vector node;                                           ///< the last is 1
  square_matrix a, inverse;                              ///< A, A^-1
  std::array<std::complex<double>, spectrum> eigenvalue; ///< of A^-1, the real one first
  std::array<complex<vector>, spectrum> to_modes;        ///< A^-1 = Re sum of from eigenvalue to
  std::array<complex<Eigen::Matrix<double, 1, stages>>, spectrum> from_modes;
  vector error;                                         ///< weights of the increments in the error estimate
  vector quadrature_error;                              ///< the same of the slopes of quadratures
  double error_slope;                                   ///< and of the slope at the step's beginning
  Eigen::Matrix<double, stages + 1, stages + 1> powers; ///< of the polynomial through 0 and the nodes

  static const radau_table& get() {
    static const radau_table table;
    return table;
  }

private:
  radau_table() {
    find_nodes();
    square_matrix vandermonde, integrals; // of the powers 0 ... stages - 1 at the nodes, and from zero up to them
    for (int i = 0; i < stages; ++i)
      for (int j = 0; j < stages; ++j) {
        vandermonde(i, j) = std::pow(node[i], j);
        integrals(i, j) = std::pow(node[i], j + 1) / (j + 1);
      }
    a = integrals * vandermonde.inverse();
    inverse = a.inverse();
    find_modes();
    error_slope = 1 / eigenvalue[0].real();
    vector first = vector::Zero();
    first[0] = -error_slope;
    quadrature_error = vandermonde.transpose().partialPivLu().solve(first);
    error = inverse.transpose() * vandermonde.transpose().partialPivLu().solve(first);
    Eigen::Matrix<double, stages + 1, stages + 1> values;
    for (int i = 0; i <= stages; ++i)
      for (int j = 0; j <= stages; ++j)
        values(i, j) = i == 0 ? (j == 0) : std::pow(node[i - 1], j);
    powers = values.inverse();
  }

  /// Zeros of P_s - P_{s-1}, Legendre's polynomials on [0, 1], by Newton's method with those found divided out.
  void find_nodes() {
    const auto value = [](double t) {
      double before = 1, now = 2 * t - 1;
      for (int n = 1; n < stages; ++n)
        before = std::exchange(now, ((2 * n + 1) * (2 * t - 1) * now - n * before) / (n + 1));
      return now - before;
    };
    node[stages - 1] = 1;
    for (int i = 0; i + 1 < stages; ++i) {
      double t = i == 0 ? 0 : node[i - 1] + 1e-3;
      for (int n = 0; n < 100; ++n) {
        const double width = 1e-7, f = value(t);
        double per_value = (value(t + width) - value(t - width)) / (2 * width) / f - 1 / (t - 1);
        for (int j = 0; j < i; ++j)
          per_value -= 1 / (t - node[j]);
        const double step = 1 / per_value;
        t -= step;
        if (std::abs(step) < 1e-15)
          break;
      }
      node[i] = t;
    }
  }

  void find_modes() {
    const Eigen::EigenSolver<square_matrix> solver(inverse);
    std::array<int, spectrum> chosen{};
    for (int i = 0, next = 1; i < stages; ++i) {
      const double imaginary = solver.eigenvalues()[i].imag();
      if (std::abs(imaginary) < 1e-9)
        chosen[0] = i;
      else if (imaginary > 0)
        chosen[std::size_t(next++)] = i;
    }
    const auto vectors = solver.eigenvectors();
    const auto inverse_vectors = vectors.inverse().eval();
    for (std::size_t m = 0; m < spectrum; ++m) {
      eigenvalue[m] = solver.eigenvalues()[chosen[m]];
      to_modes[m] = {inverse_vectors.row(chosen[m]).real(), inverse_vectors.row(chosen[m]).imag()};
      const double times = m == 0 ? 1 : 2; // the conjugate one makes the same contribution
      from_modes[m] = {times * vectors.col(chosen[m]).real().transpose(),
                       times * vectors.col(chosen[m]).imag().transpose()};
    }
  }
};

} // namespace ricochet::stepper
