#pragma once
#include <ricochet/number/autodiff.hpp>
#include <ricochet/solve/stepper.hpp>

#include <memory>

#include <Eigen/LU>

namespace ricochet::stepper {

/// Coefficients of RODAS, six stages, order 4(3), stiffly accurate [Hairer & Wanner, Solving ODEs II, IV.7].
struct rodas_coefficients {
  static constexpr double gamma{0.25};
  static constexpr double a21{1.544}, a31{0.9466785280815826}, a32{0.2557011698983284}, a41{3.314825187068521},
      a42{2.896124015972201}, a43{0.9986419139977817}, a51{1.221224509226641}, a52{6.019134481288629},
      a53{12.53708332932087}, a54{-0.6878860361058950};
  static constexpr double c21{-5.6688}, c31{-2.430093356833875}, c32{-0.2063599157091915}, c41{-0.1073529058151375},
      c42{-9.594562251023355}, c43{-20.47028614809616}, c51{7.496443313967647}, c52{-10.24680431464352},
      c53{-33.99990352819905}, c54{11.70890893206160}, c61{8.083246795921522}, c62{-7.981132988064893},
      c63{-31.52159432874371}, c64{16.31930543123136}, c65{-6.058818238834054};
};

/// odeint's rosenbrock4, the L-stable method RODAS, on packed states and matrices of fixed size: odeint's own class is
/// tied to uBLAS vectors, which Boost 1.74 cannot compile as C++20 (tests/solve/rosenbrock.cpp compares both).
/// The Jacobian is taken by dual numbers. For motions in which the edge is much faster than the collision.
struct rosenbrock4 {
  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    static constexpr int size = int(state_type::names::size);
    static_assert(std::same_as<double, typename Flow::number>, "stepper::rosenbrock4 works on double only");
    using vector = Eigen::Matrix<real, size, 1>;
    using matrix = Eigen::Matrix<real, size, size>;
    using model_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;
    using dual_model = reduced_model<dual<real>, typename model_type::model_type>;
    static constexpr int motion = model_type::free_edge ? 3 : 2; ///< unknowns that feed back

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

    /// Rate at which the edge relaxes: |d(dy/d sigma)/dy|.
    real rate_of_edge(Flow& f, const state_type& x) {
      differentiate(f, x);
      return abs(jacobian_(0, 0));
    }

  private:
    /// Stages g_i of (1/(gamma h) - J) g_i = f(x + sum a_ij g_j) + sum c_ij g_j/h; the last one is the error.
    std::pair<state_type, state_type> step(Flow& f, const state_type& x, const real& h) {
      if (!known_)
        differentiate(f, x);
      known_ = true;
      constexpr rodas_coefficients c;
      const linear_solver solver(jacobian_, 1 / (c.gamma * h));
      const auto slope = [&f](const vector& v) {
        state_type dx{};
        f(unpack(v), dx, real(0));
        return pack(dx);
      };
      const vector from = pack(x);
      const vector g1 = solver.solve(pack(slope_));
      const vector g2 = solver.solve(slope(from + c.a21 * g1) + c.c21 / h * g1);
      const vector g3 = solver.solve(slope(from + c.a31 * g1 + c.a32 * g2) + (c.c31 * g1 + c.c32 * g2) / h);
      const vector g4 =
          solver.solve(slope(from + c.a41 * g1 + c.a42 * g2 + c.a43 * g3) + (c.c41 * g1 + c.c42 * g2 + c.c43 * g3) / h);
      const vector near = from + c.a51 * g1 + c.a52 * g2 + c.a53 * g3 + c.a54 * g4;
      const vector g5 = solver.solve(slope(near) + (c.c51 * g1 + c.c52 * g2 + c.c53 * g3 + c.c54 * g4) / h);
      const vector error =
          solver.solve(slope(near + g5) + (c.c61 * g1 + c.c62 * g2 + c.c63 * g3 + c.c64 * g4 + c.c65 * g5) / h);
      return {unpack(near + g5 + error), unpack(error)};
    }

    /// Solves (d I - J) g = r. Quadratures do not feed back, so that only the motion's own block has to be inverted.
    struct linear_solver {
      const matrix& J;
      double d;
      Eigen::Matrix<double, motion, motion> inverse;

      linear_solver(const matrix& jacobian, double diagonal) : J(jacobian), d(diagonal) {
        inverse = -J.template topLeftCorner<motion, motion>();
        inverse.diagonal().array() += d;
        inverse = inverse.inverse().eval();
      }
      vector solve(const vector& r) const {
        vector g = r;
        g.template head<motion>() = inverse * r.template head<motion>();
        for (int i = motion; i < size; ++i)
          g(i) = (r(i) + J.row(i).template head<motion>().dot(g.template head<motion>())) / d;
        return g;
      }
    };

    /// The Jacobian by dual numbers; quadratures do not feed back, so only the motion's own unknowns are seeded.
    void differentiate(Flow& f, const state_type& x) {
      if (!dual_model_)
        dual_model_ = std::make_shared<const dual_model>(f.model);
      f(x, slope_, real(0));
      jacobian_.setZero();
      for (std::size_t j = 0; j < std::size_t(motion); ++j) {
        typename dual_model::state_type seeded_x{}, slope{};
        for (std::size_t i = 0; i < x.size(); ++i)
          seeded_x[i] = i == j ? seeded(x[i]) : dual<real>(x[i]);
        ++f.evaluations;
        if (!dual_model_->derivative(seeded_x, slope, f.piece))
          f.outside = true;
        for (std::size_t i = 0; i < x.size(); ++i)
          jacobian_(Eigen::Index(i), Eigen::Index(j)) = slope[i].derivative(1);
      }
    }

    static vector pack(const state_type& x) { return Eigen::Map<const vector>(x.data()); }
    static state_type unpack(const vector& v) {
      state_type x{};
      Eigen::Map<vector>(x.data()) = v;
      return x;
    }

    real tolerance_;
    state_type typical_, slope_{};
    matrix jacobian_;
    std::shared_ptr<const dual_model> dual_model_;
    bool known_ = false;
  };
};

} // namespace ricochet::stepper
