#pragma once
#include <ricochet/solve/stepper/radau_coefficients.hpp>

#include <Eigen/Core>

namespace ricochet::stepper {

/// The collocation method at the right Radau points with 3 or 5 stages, order 2 stages - 1 [Hairer & Wanner, Solving
/// ODEs II, IV.5, IV.8; their code RADAU].
template <int stages>
struct radau_table {
  using numbers = radau_coefficients<stages>;
  static constexpr int modes = (stages + 1) / 2; ///< the real eigenvalue of A^-1 and one of each conjugate pair
  template <int rows, int columns>
  using matrix = Eigen::Matrix<double, rows, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  struct weights {
    matrix<modes, stages> real, imaginary;
  };

  matrix<stages, 1> node{numbers::node.data()};                                  ///< the last is 1
  matrix<stages, stages> a{numbers::a.data()}, inverse{numbers::inverse.data()}; ///< A, A^-1
  matrix<modes, 1> eigenvalue_real{numbers::eigenvalue_real.data()};             ///< of A^-1, the real one first
  matrix<modes, 1> eigenvalue_imaginary{numbers::eigenvalue_imaginary.data()};
  weights to_modes{matrix<modes, stages>{numbers::to_modes_real.data()},
                   matrix<modes, stages>{numbers::to_modes_imaginary.data()}};
  weights from_modes{matrix<modes, stages>{numbers::from_modes_real.data()},
                     matrix<modes, stages>{numbers::from_modes_imaginary.data()}}; ///< A^-1 = Re sum from eigenvalue to
  matrix<stages, 1> error{numbers::error.data()}; ///< weights of the increments in the error estimate
  matrix<stages, 1> quadrature_error{numbers::quadrature_error.data()}; ///< the same of the slopes of quadratures
  double error_slope = numbers::error_slope;                            ///< and of the slope at the step's beginning
  matrix<stages + 1, stages + 1> powers{numbers::powers.data()};        ///< of the polynomial through 0 and the nodes

  static const radau_table& get() {
    static const radau_table table;
    return table;
  }
};

} // namespace ricochet::stepper
