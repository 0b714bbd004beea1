// Writes include/ricochet/solve/stepper/radau_coefficients.hpp to standard output: collocation at the right Radau
// points, from its definition, in long double.
#include <cmath>
#include <complex>
#include <cstdio>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace {
using real = long double;

/// Round-off becomes 0.
void print(const char* name, const auto& matrix) {
  std::printf("  static constexpr std::array<double, %d> %s{", int(matrix.size()), name);
  const char* separator = "";
  for (int i = 0; i < matrix.rows(); ++i)
    for (int j = 0; j < matrix.cols(); ++j)
      std::printf("%s%.17Lg", std::exchange(separator, ", "), std::abs(matrix(i, j)) < 1e-16L ? 0 : real(matrix(i, j)));
  std::printf("};\n");
}

/// [Hairer & Wanner, Solving ODEs II, IV.5, IV.8; their code RADAU]
template <int stages>
class collocation {
  using vector = Eigen::Matrix<real, stages, 1>;
  using square_matrix = Eigen::Matrix<real, stages, stages>;

  /// Zeros of P_s - P_{s-1}, Legendre's polynomials on [0, 1], by Newton's method with those found divided out.
  static vector nodes() {
    const auto value = [](real t) {
      real before = 1, now = 2 * t - 1;
      for (int n = 1; n < stages; ++n)
        before = std::exchange(now, ((2 * n + 1) * (2 * t - 1) * now - real(n) * before) / (n + 1));
      return now - before;
    };
    vector node;
    node[stages - 1] = 1;
    for (int i = 0; i + 1 < stages; ++i) {
      real t = i == 0 ? 0 : node[i - 1] + 1e-3L;
      for (int n = 0; n < 100; ++n) {
        const real width = 1e-7L, f = value(t);
        real per_value = (value(t + width) - value(t - width)) / (2 * width) / f - 1 / (t - 1);
        for (int j = 0; j < i; ++j)
          per_value -= 1 / (t - node[j]);
        const real step = 1 / per_value;
        t -= step;
        if (std::abs(step) < 1e-18L)
          break;
      }
      node[i] = t;
    }
    return node;
  }

public:
  void write() const {
    const vector node = nodes();
    square_matrix vandermonde, integrals; // of the powers 0 ... stages - 1 at the nodes, and from zero up to them
    for (int i = 0; i < stages; ++i)
      for (int j = 0; j < stages; ++j) {
        vandermonde(i, j) = std::pow(node[i], real(j));
        integrals(i, j) = std::pow(node[i], real(j + 1)) / (j + 1);
      }
    const square_matrix a = integrals * vandermonde.inverse(), inverse = a.inverse();

    const Eigen::EigenSolver<square_matrix> solver(inverse);
    const auto vectors = solver.eigenvectors().eval(), inverse_vectors = vectors.inverse().eval();
    constexpr int modes = (stages + 1) / 2;
    Eigen::Matrix<std::complex<real>, modes, 1> eigenvalue;
    Eigen::Matrix<std::complex<real>, modes, stages> to_modes, from_modes;
    for (int i = 0, next = 1; i < stages; ++i) {
      const std::complex<real> lambda = solver.eigenvalues()[i];
      const bool is_real = std::abs(lambda.imag()) < 1e-9L;
      if (!is_real && lambda.imag() < 0)
        continue;
      const int m = is_real ? 0 : next++;
      eigenvalue[m] = lambda;
      to_modes.row(m) = inverse_vectors.row(i);
      from_modes.row(m) = real(is_real ? 1 : 2) * vectors.col(i).transpose(); // the conjugate one adds as much
    }

    const real error_slope = 1 / eigenvalue[0].real();
    vector first = vector::Zero();
    first[0] = -error_slope;
    const vector quadrature_error = vandermonde.transpose().partialPivLu().solve(first);
    const vector error = inverse.transpose() * quadrature_error;
    Eigen::Matrix<real, stages + 1, stages + 1> values;
    for (int i = 0; i <= stages; ++i)
      for (int j = 0; j <= stages; ++j)
        values(i, j) = i == 0 ? real(j == 0) : std::pow(node[i - 1], real(j));

    std::printf("template <>\nstruct radau_coefficients<%d> {\n", stages);
    print("node", node);
    print("a", a);
    print("inverse", inverse);
    print("eigenvalue_real", eigenvalue.real());
    print("eigenvalue_imaginary", eigenvalue.imag());
    print("to_modes_real", to_modes.real());
    print("to_modes_imaginary", to_modes.imag());
    print("from_modes_real", from_modes.real());
    print("from_modes_imaginary", from_modes.imag());
    print("error", error);
    print("quadrature_error", quadrature_error);
    std::printf("  static constexpr double error_slope = %.17Lg;\n", error_slope);
    print("powers", values.inverse().eval());
    std::printf("};\n");
  }
};
} // namespace

int main() {
  std::printf("// Made by tests/tables/radau_coefficients.cpp; not to be edited.\n#pragma once\n#include <array>\n\n"
              "namespace ricochet::stepper {\n\n"
              "/// Coefficients of radau_table, matrices row by row, modes one to a row.\n"
              "template <int stages>\nstruct radau_coefficients;\n\n// clang-format off\n");
  collocation<3>().write();
  collocation<5>().write();
  std::printf("// clang-format on\n\n} // namespace ricochet::stepper\n");
}
