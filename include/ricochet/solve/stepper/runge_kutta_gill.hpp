#pragma once
#include <ricochet/solve/stepper/explicit_pair.hpp>
#include <ricochet/solve/stepper/stepper.hpp>

#include <numbers>

namespace ricochet::stepper {

/// Gill's four stages of order 4 [S. Gill, Proc. Cambridge Philos. Soc. 47 (1951) 96], with which Brach & Dunn 1995
/// integrate. Only the method: his way of storing it in three registers, and of gathering its round-off, is left out.
struct runge_kutta_gill_table {
  static constexpr unsigned short order = 4;
  static constexpr std::size_t stages = 4;
  using row = std::array<long double, stages>;
  static constexpr long double half_root = std::numbers::sqrt2_v<long double> / 2;
  static constexpr std::array<row, stages> a{{
      {},
      {0.5L},
      {half_root - 0.5L, 1 - half_root},
      {0, -half_root, 1 + half_root},
  }};
  static constexpr row b{1.L / 6, (1 - half_root) / 3, (1 + half_root) / 3, 1.L / 6};
};

/// As an odeint Stepper. State and Real to double or long double precision.
template <class State, class Real>
using runge_kutta_gill_method = explicit_method<runge_kutta_gill_table, State, Real>;
/// For collide(), the error that of one step against two halves.
using runge_kutta_gill = doubled<runge_kutta_gill_method>;

} // namespace ricochet::stepper
