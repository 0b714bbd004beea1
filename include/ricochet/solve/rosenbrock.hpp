#pragma once
#include <ricochet/number/autodiff.hpp>
#include <ricochet/solve/stepper.hpp>

#include <optional>

#include <Eigen/LU>

namespace ricochet::stepper {

/// Coefficients of RODAS, six stages, order 4(3), stiffly accurate [Hairer & Wanner, Solving ODEs II, IV.7]: the last
/// stage is the error, the one before leads to the embedded result.
struct rodas_table {
  static constexpr std::size_t stages = 6;
  using row = std::array<double, stages>;
  static constexpr double gamma = 0.25;
  static constexpr row near_the_end{1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950};
  static constexpr std::array<row, stages> a{{
      {},
      {1.544},
      {0.9466785280815826, 0.2557011698983284},
      {3.314825187068521, 2.896124015972201, 0.9986419139977817},
      near_the_end,
      {near_the_end[0], near_the_end[1], near_the_end[2], near_the_end[3], 1},
  }};
  static constexpr std::array<row, stages> c{{
      {},
      {-5.6688},
      {-2.430093356833875, -0.2063599157091915},
      {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
      {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
      {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054},
  }};
};

/// odeint's rosenbrock4, the L-stable method RODAS, on packed states and matrices of fixed size: odeint's own class is
/// tied to uBLAS vectors, which Boost 1.74 cannot compile as C++20 (tests/solve/rosenbrock.cpp compares both).
/// The Jacobian is taken by dual numbers. For motions in which the edge is much faster than the collision.
struct rosenbrock4 {
  static constexpr double usual_error = 0.25;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    static constexpr int size = int(state_type::names::size);
    static_assert(std::same_as<double, typename Flow::number>, "stepper::rosenbrock4 works on double only");
    using model_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;
    using dual_model = reduced_model<dual<real>, typename model_type::model_type>;
    static constexpr int motion = model_type::free_edge ? 3 : 2; ///< unknowns that feed back
    using matrix = Eigen::Matrix<real, motion, motion>;

  public:
    method(const real& tolerance, const state_type& typical) : tolerance_(tolerance), typical_(typical) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      f.outside = false;
      const auto [out, error] = step(f, x, h);
      const real norm = error_norm(error, typical_, tolerance_, f.outside);
      return {norm <= 1, out, h, resized(h, norm, 4)};
    }

    state_type within(Flow& f, const state_type& x, const real& h) { return step(f, x, h).first; }

    void moved() { known_ = false; }

  private:
    /// Stages g_i of (1/(gamma h) - J) g_i = f(x + sum a_ij g_j) + sum c_ij g_j/h: the state after the step, and its
    /// error.
    std::pair<state_type, state_type> step(Flow& f, const state_type& x, const real& h) {
      using table = rodas_table;
      if (!known_)
        differentiate(f, x);
      known_ = true;
      const real diagonal = 1 / (table::gamma * h);
      matrix inverse = -jacobian_.template topRows<motion>();
      inverse.diagonal().array() += diagonal;
      inverse = inverse.inverse().eval();
      std::array<state_type, table::stages> g;
      state_type at = x, slope = slope_;
      for (std::size_t s = 0; s < table::stages; ++s) {
        if (s > 0) {
          at = x;
          add(at, table::a[s], 1, g, s);
          f(at, slope, real(0));
        }
        add(slope, table::c[s], 1 / h, g, s);
        g[s] = solve(inverse, diagonal, slope);
      }
      const state_type& error = g.back();
      for (std::size_t i = 0; i < x.size(); ++i)
        at[i] += error[i];
      return {at, error};
    }

    /// x += factor sum of weight_j g_j over the first stages.
    static void add(state_type& x, const rodas_table::row& weight, const real& factor,
                    const std::array<state_type, rodas_table::stages>& g, std::size_t stages) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        real sum = 0;
        for (std::size_t j = 0; j < stages; ++j)
          sum += weight[j] * g[j][i];
        x[i] += factor * sum;
      }
    }

    /// Solves (diagonal - J) g = r. Quadratures do not feed back, so that only the motion's own block is inverted.
    state_type solve(const matrix& inverse, const real& diagonal, const state_type& r) const {
      state_type g{};
      for (int i = 0; i < motion; ++i)
        for (int j = 0; j < motion; ++j)
          g[std::size_t(i)] += inverse(i, j) * r[std::size_t(j)];
      for (int i = motion; i < size; ++i) {
        real sum = r[std::size_t(i)];
        for (int j = 0; j < motion; ++j)
          sum += jacobian_(i, j) * g[std::size_t(j)];
        g[std::size_t(i)] = sum / diagonal;
      }
      return g;
    }

    /// The Jacobian by dual numbers; quadratures do not feed back, so only the motion's own unknowns are seeded.
    void differentiate(Flow& f, const state_type& x) {
      if (!dual_model_)
        dual_model_.emplace(f.model);
      f(x, slope_, real(0));
      for (std::size_t j = 0; j < std::size_t(motion); ++j) {
        typename dual_model::state_type seeded_x{}, slope{};
        for (std::size_t i = 0; i < x.size(); ++i)
          seeded_x[i] = i == j ? seeded(x[i]) : dual<real>(x[i]);
        ++f.evaluations;
        if (!dual_model_->derivative(seeded_x, slope, f.piece))
          f.outside = true;
        for (std::size_t i = 0; i < x.size(); ++i)
          jacobian_(int(i), int(j)) = slope[i].derivative(1);
      }
    }

    real tolerance_;
    state_type typical_, slope_{};
    Eigen::Matrix<real, size, motion> jacobian_;
    std::optional<dual_model> dual_model_;
    bool known_ = false;
  };
};

} // namespace ricochet::stepper
