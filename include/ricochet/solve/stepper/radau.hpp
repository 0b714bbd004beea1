#pragma once
#include <ricochet/number/gradient.hpp>
#include <ricochet/solve/edge/fast_edge.hpp>
#include <ricochet/solve/stepper/radau_table.hpp>
#include <ricochet/solve/stepper/stepper.hpp>

#include <optional>

#include <Eigen/LU>

namespace ricochet::stepper {

/// Radau IIA, L-stable and without loss of order where the edge is much faster than the collision: collocation, solved
/// by simplified Newton iterations in the modes of A^-1. The Jacobian is taken by dual numbers.
///
/// The speed of a fast edge depends on sqrt(beta) so steeply that neither a common Jacobian nor the differences of
/// large numbers will do: each stage has its own slope in sqrt(beta), which takes the place of delta among the unknowns
/// of the linear systems; and while the edge keeps up with the bodies, time is slowed as they move.
template <int stages>
struct radau {
  static constexpr double usual_error = 0.25;
  static constexpr double fast_enough = 0.05; ///< |beta - 1| of an edge whose law's kink at 1 is not to be stepped onto

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using table_type = radau_table<stages>;
    static_assert(std::same_as<double, typename Flow::number>, "stepper::radau works on double only");
    using model_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;
    static constexpr bool free_edge = model_type::free_edge;
    static constexpr int size = int(state_type::names::size);
    static constexpr int motion = free_edge ? 3 : 2; ///< unknowns that feed back: y, rate and, of a free edge, delta
    template <std::size_t n>
    using differentiable_model = reduced_model<gradient<real, n>, typename model_type::model_type>;
    using matrix = Eigen::Matrix<real, motion, motion>;
    using vector = Eigen::Matrix<real, motion, 1>;
    using increments = Eigen::Matrix<real, motion, stages>; ///< of the motion from the step's beginning to each node
    using ratios = Eigen::Matrix<real, 1, stages>;          ///< increments of sqrt(beta)
    struct inverse {
      matrix real, imaginary;
    };
    struct polynomial {
      increments z;
      ratios roots;
      real h;
    };

  public:
    method(const real& tolerance, const state_type& typical) : tolerance_(tolerance), typical_(typical) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      if (!known_) {
        least_clock_ = keeps_up(f, x);
        f.least_clock = least_clock_;
        differentiate(f, x);
      }
      f.least_clock = least_clock_;
      known_ = true;
      increments z = increments::Zero();
      if (goes_on_ && x == end_)
        z = extrapolated(f, x, h);
      state_type out = x;
      if (!solve(f, x, h, z, out)) {
        growth_ = 1.5;
        return {false, x, h, h / 3};
      }
      const real norm = std::max(error(f, x, h, z), quadrature_error_);
      tried_ = {z, roots(f, x, z), h};
      tried_end_ = out;
      tried_well_ = norm <= 1;
      real next = std::min(growth_ * h, resized(h, norm, stages + 1));
      if (norm > 1 && norm > refused_ / 2) // it hardly depends on the step: what it shows is very much faster
        next = std::min(next, h / 16);
      refused_ = norm > 1 ? norm : std::numeric_limits<real>::infinity();
      growth_ = norm <= 1 ? 5 : 1.5;
      return {norm <= 1, out, h, next};
    }

    state_type within(Flow& f, const state_type& x, const real& h) {
      f.least_clock = least_clock_;
      state_type out = x;
      increments z = interpolated(f, x, h);
      if (solve(f, x, h, z, out))
        return out;
      for (auto& component : out)
        component = std::numeric_limits<real>::quiet_NaN();
      return out;
    }

    /// Does the edge keep up with the bodies?
    bool glides() const { return least_clock_ > 0; }

    void moved() {
      known_ = false;
      goes_on_ = std::exchange(tried_well_, false);
      if (goes_on_) {
        last_ = tried_;
        end_ = tried_end_;
      }
    }

  private:
    /// The least clock if the edge keeps up with the bodies so well that they say how time is slowed, else 0.
    real keeps_up(const Flow& f, const state_type& x) {
      if constexpr (free_edge) {
        if (!edge_)
          edge_.emplace(f.model);
        const real least = edge_->least_clock();
        if (edge_->excess() < fast_enough && std::abs(f.model.root_ratio(x) - 1) < fast_enough) {
          const real own = f.model.at(x, f.piece).clock, slaved = f.model.at(x, f.piece, least).clock;
          if (slaved > 2 * least && slaved > own / 2)
            return least;
        }
      }
      return 0;
    }

    /// The polynomial through 0 and the increments at the nodes, at multiples of its own step.
    template <int rows>
    Eigen::Matrix<real, rows, 1> value(const Eigen::Matrix<real, rows, stages>& z, const real& part) const {
      Eigen::Matrix<real, rows, 1> sum = Eigen::Matrix<real, rows, 1>::Zero();
      for (int i = 0; i < stages; ++i) {
        real weight = 0;
        for (int j = stages; j >= 0; --j)
          weight = weight * part + table_.powers(j, i + 1);
        sum += weight * z.col(i);
      }
      return sum;
    }
    increments extrapolated(const Flow& f, const state_type& x, const real& h) const {
      return predicted(f, x, last_, h, 1);
    }
    increments interpolated(const Flow& f, const state_type& x, const real& h) const {
      return predicted(f, x, tried_, h, 0);
    }
    /// What a polynomial that has come to x at this part of its step says of the nodes of another one.
    increments predicted(const Flow& f, const state_type& x, const polynomial& known, const real& h, int from) const {
      increments z;
      for (int i = 0; i < stages; ++i) {
        const real part = from + table_.node[i] * h / known.h;
        z.col(i) = value(known.z, part);
        if (from == 1)
          z.col(i) -= known.z.col(stages - 1);
        if constexpr (free_edge) {
          const real root =
              value<1>(known.roots, part)[0] - (from == 1 ? known.roots[stages - 1] : 0) + f.model.root_ratio(x);
          keep_ratio(f, x, z, i, root);
        }
      }
      return z;
    }
    ratios roots(const Flow& f, const state_type& x, const increments& z) const {
      ratios r = ratios::Zero();
      if constexpr (free_edge)
        for (int i = 0; i < stages; ++i)
          r[i] = f.model.root_ratio(moved_by(x, z.col(i))) - f.model.root_ratio(x);
      return r;
    }

    static state_type moved_by(const state_type& x, const vector& z) {
      state_type at = x;
      for (int j = 0; j < motion; ++j)
        at[std::size_t(j)] += z[j];
      return at;
    }

    /// Solves the equations of the step, starting from the increments given; false if that does not converge.
    bool solve(Flow& f, const state_type& x, const real& h, increments& z, state_type& out) {
      invert_modes(h);
      std::array<state_type, stages> slope{};
      std::array<matrix, stages> correction;
      bool refresh = true;
      real last = 0;
      constexpr int most = 10;
      for (int iteration = 0; iteration < most; ++iteration) {
        f.outside = false;
        increments residual = -z * table_.inverse.transpose() / h;
        for (int i = 0; i < stages; ++i) {
          state_type& here = slope[std::size_t(i)];
          if (refresh)
            correction[std::size_t(i)] = own_slope(f, moved_by(x, z.col(i)), here);
          else
            f(moved_by(x, z.col(i)), here, real(0));
          for (int j = 0; j < motion; ++j)
            residual(j, i) += here[std::size_t(j)];
          residual.col(i) = (correction[std::size_t(i)] * residual.col(i)).eval();
        }
        const increments change = solution(residual);
        const real norm = update(f, x, change, z), rate = iteration == 0 ? 1 : norm / last;
        last = norm;
        refresh = rate > 0.05;
        const real to_come = std::max(rate, 0.01); // what changed first may have been linear and tell nothing of the rest
        if (norm < 0.1 * enough || (iteration > 0 && rate < 1 && norm * to_come < enough * (1 - to_come))) {
          finish(x, h, z, slope, out);
          return !f.outside;
        }
        if (!std::isfinite(norm) || (iteration > 1 && norm * std::pow(rate, most - 1 - iteration) > enough))
          return false;
      }
      return false;
    }
    static constexpr real enough = 1e-3; ///< in tolerances, of what is left to change

    /// Inverts lambda/h - J, in terms of sqrt(beta), for each mode: M^-1 = C^-1 - i A^-1 B C^-1 with M = A + iB and C =
    /// A + B A^-1 B, since complex numbers are slow.
    void invert_modes(const real& h) {
      for (std::size_t m = 0; m < inverse_.size(); ++m) {
        const matrix a = geometry_ * (table_.eigenvalue_real[int(m)] / h) - slopes_;
        if (m == 0) {
          inverse_[m] = {a.inverse(), matrix::Zero()};
          continue;
        }
        const matrix b = geometry_ * (table_.eigenvalue_imaginary[int(m)] / h), q = a.inverse() * b, c = a + b * q;
        inverse_[m].real = c.inverse();
        inverse_[m].imaginary = -q * inverse_[m].real;
      }
    }

    /// Solves (lambda/h - J) for all modes.
    increments solution(const increments& residual) const {
      const auto& to = table_.to_modes;
      const auto& from = table_.from_modes;
      increments change = increments::Zero();
      for (int m = 0; m < int(inverse_.size()); ++m) {
        const auto& [real_inverse, imaginary_inverse] = inverse_[std::size_t(m)];
        const vector real_part = residual * to.real.row(m).transpose(),
                     imaginary_part = residual * to.imaginary.row(m).transpose();
        change += (real_inverse * real_part - imaginary_inverse * imaginary_part) * from.real.row(m) -
                  (real_inverse * imaginary_part + imaginary_inverse * real_part) * from.imaginary.row(m);
      }
      return change;
    }

    /// Adds a change of y, rate and sqrt(beta) to the increments. While the edge keeps up, what is not linear goes to
    /// y: else its speed would be lost. Returns the size of the change, in tolerances, in parts of sqrt(beta) - 1, and
    /// of its distance to the end of its law's range.
    real update(const Flow& f, const state_type& x, const increments& change, increments& z) const {
      const increments linear = geometry_ * change;
      real norm = 0, largest = 1e-13, largest_change = 0;
      for (int j = 0; j < motion; ++j)
        norm = std::max(norm, linear.row(j).cwiseAbs().maxCoeff() / (typical_[std::size_t(j)] * tolerance_));
      if constexpr (!free_edge) {
        z += linear;
        return norm;
      } else {
        for (int i = 0; i < stages; ++i) {
          const real before = f.model.root_ratio(moved_by(x, z.col(i)));
          z.col(i) += linear.col(i);
          keep_ratio(f, x, z, i, before + change(2, i));
          const real now = f.model.root_ratio(moved_by(x, z.col(i)));
          largest = std::max(largest, std::abs(now - 1));
          largest_change = std::max(largest_change, std::abs(now - before));
          norm = std::max(norm, std::abs(now - before) / (10 * room(f, now)));
        }
        return std::max(norm, largest_change / (10 * largest));
      }
    }

    /// From this sqrt(beta) to the nearer end of its law's range, where the edge's speed has no bound.
    static real room(const Flow& f, const real& root) {
      if constexpr (limited_crack_law<decltype(model_type::crack)>)
        return std::min(std::abs(root - std::sqrt(f.model.crack.lowest_ratio())),
                        std::abs(std::sqrt(f.model.crack.highest_ratio()) - root));
      else
        return std::numeric_limits<real>::infinity();
    }

    /// While the edge keeps up: moves y to where sqrt(beta) is as wanted, as far as that is well defined.
    void keep_ratio(const Flow& f, const state_type& x, increments& z, int i, const real& wanted) const {
      if (!(least_clock_ > 0))
        return;
      state_type at = moved_by(x, z.col(i));
      for (int n = 0; n < 4; ++n) {
        const real step = (f.model.root_ratio(at) - wanted) * approach_per_ratio(f, at) / f.model.approach_gradient(at);
        if (!(std::abs(step) < 0.05 * at[0]))
          return;
        at[0] += step;
        if (std::abs(step) < 1e-15 * at[0])
          break;
      }
      z(0, i) = at[0] - x[0];
    }

    /// d(delta)/d(sqrt beta)
    static real approach_per_ratio(const Flow& f, const state_type& x) {
      return f.model.approach_at(x[0], 1) - f.model.approach_at(x[0], 0);
    }

    void finish(const state_type& x, const real& h, const increments& z, std::array<state_type, stages> slope,
                state_type& out) {
      quadrature_error_ = 0;
      out = moved_by(x, z.col(stages - 1));
      settle(x, h, z, slope);
      for (std::size_t j = motion; j < std::size_t(size); ++j) {
        real sum = 0, error = table_.error_slope * slope_[j];
        for (int i = 0; i < stages; ++i) {
          sum += table_.a(stages - 1, i) * slope[std::size_t(i)][j];
          error += table_.quadrature_error[i] * slope[std::size_t(i)][j];
        }
        out[j] += h * sum;
        quadrature_error_ = std::max(quadrature_error_, std::abs(h * error) / (typical_[j] * tolerance_));
      }
    }

    /// Slopes of quadratures as the increments have them: what is left to change of these, small as it is, would show
    /// in the clock and the edge's speed where the law is steep.
    void settle(const state_type& x, const real& h, const increments& z, std::array<state_type, stages>& slope) const {
      if constexpr (free_edge) {
        const increments settled = z * table_.inverse.transpose() / h;
        constexpr std::size_t by_edge = state_type::names::template index_of<crack_loss_t>();
        for (int i = 0; i < stages; ++i) {
          state_type& here = slope[std::size_t(i)];
          const auto part = [&](int first, int last) -> real { // of the slopes in the settled ones
            real both = 0, own = 0;
            for (int unknown = first; unknown <= last; ++unknown) {
              const real slope_there = here[std::size_t(unknown)] / typical_[std::size_t(unknown)];
              both += settled(unknown, i) / typical_[std::size_t(unknown)] * slope_there;
              own += slope_there * slope_there;
            }
            const real ratio = both / own;
            return std::abs(ratio - 1) < 0.5 ? ratio : 1;
          };
          // rate and delta together tell the clock: alone, each has a slope of zero somewhere, delta where bodies turn
          const real speed = part(0, 0), clock = part(1, 2);
          for (std::size_t j = motion; j < std::size_t(size); ++j)
            here[j] *= j == by_edge ? speed : clock;
        }
      }
      if constexpr (model_type::slides) // the distance feeds on the slip
        for (int i = 0; i < stages && x[slip] != 0; ++i) {
          real change = 0;
          for (int j = 0; j < stages; ++j)
            change += h * table_.a(i, j) * slope[std::size_t(j)][slip];
          slope[std::size_t(i)][slip_distance] *= 1 + change / x[slip];
        }
    }

    /// Size of the difference to a method of order `stages`, damped where the motion is stiff.
    real error(Flow& f, const state_type& x, const real& h, const increments& z) const {
      const matrix damping = geometry_ * inverse_[0].real;
      const vector difference = z * table_.error / (table_.error_slope * h);
      const auto estimate = [&](const state_type& slope) -> vector {
        vector sum = difference;
        for (int j = 0; j < motion; ++j)
          sum[j] += slope[std::size_t(j)];
        return damping * sum;
      };
      const vector e = estimate(slope_);
      real norm = size_of(e);
      if (norm > 1) {
        state_type slope{};
        f.outside = false;
        f(moved_by(x, e), slope, real(0));
        if (!f.outside)
          norm = size_of(estimate(slope));
      }
      return norm;
    }
    real size_of(const vector& e) const {
      real norm = 0;
      for (int j = 0; j < motion; ++j)
        norm = std::max(norm, std::abs(e[j]) / (typical_[std::size_t(j)] * tolerance_));
      return std::isfinite(norm) ? norm : std::numeric_limits<real>::infinity();
    }

    /// Slopes at x, and their derivatives with respect to the unknowns from `first` on.
    template <std::size_t n>
    Eigen::Matrix<real, motion, int(n)> differentiate(Flow& f, const differentiable_model<n>& model,
                                                      const state_type& x, std::size_t first, state_type& dx) {
      typename differentiable_model<n>::state_type seeded{}, slope{};
      for (std::size_t i = 0; i < x.size(); ++i)
        seeded[i] = i >= first && i < first + n ? gradient<real, n>::seeded(x[i], i - first) : x[i];
      f.evaluations += long(n);
      if (!model.derivative(seeded, slope, f.piece, f.direction, f.least_clock))
        f.outside = true;
      Eigen::Matrix<real, motion, int(n)> result;
      for (std::size_t i = 0; i < x.size(); ++i)
        dx[i] = slope[i].value;
      for (std::size_t i = 0; i < std::size_t(motion); ++i)
        for (std::size_t j = 0; j < n; ++j)
          result(int(i), int(j)) = slope[i].slope[j];
      return result;
    }

    /// What turns a stage's residual into that which the common Jacobian J_0 would need: (s - J_0)/(s - J_i) with J_i =
    /// J_0 + c_i n_i - c_0 n_0, where n is the gradient of sqrt(beta) but for its size and c the derivative by delta.
    matrix own_slope(Flow& f, const state_type& x, state_type& dx) {
      if constexpr (!free_edge) {
        f(x, dx, real(0));
        return matrix::Identity();
      } else {
        Eigen::Matrix<real, motion, 2> c;
        c << differentiate<1>(f, *by_approach_, x, 2, dx), -jacobian_.col(2);
        Eigen::Matrix<real, 2, motion> n; // times the inverse of s - J_0
        n.row(1) = inverse_[0].real.row(2) * geometry_(2, 2);
        n.row(0) = n.row(1);
        if (!(least_clock_ > 0))
          n.row(0) += inverse_[0].real.row(0) * (geometry_(2, 0) - f.model.approach_gradient(x));
        const Eigen::Matrix<real, 2, 2> bend = Eigen::Matrix<real, 2, 2>::Identity() - n * c;
        if (!(bend.determinant() > 0.1))
          return matrix::Identity();
        return matrix::Identity() + c * bend.inverse() * n;
      }
    }

    void differentiate(Flow& f, const state_type& x) {
      if (!by_motion_) {
        by_motion_.emplace(f.model);
        by_approach_.emplace(f.model);
      }
      jacobian_ = differentiate<std::size_t(motion)>(f, *by_motion_, x, 0, slope_);
      geometry_ = matrix::Identity();
      if constexpr (free_edge)
        geometry_.row(2) << f.model.approach_gradient(x), 0, approach_per_ratio(f, x);
      slopes_ = jacobian_ * geometry_;
    }

    const table_type& table_ = table_type::get();
    real growth_ = 5, quadrature_error_ = 0, tolerance_, least_clock_ = 0;
    real refused_ = std::numeric_limits<real>::infinity(); ///< size of the error for which the last step was not taken
    state_type typical_, slope_{}, tried_end_{}, end_{};
    matrix jacobian_, slopes_;                       ///< derivatives by y, rate and delta; by y, rate and sqrt(beta)
    matrix geometry_;                                ///< of the former by the latter
    std::array<inverse, table_type::modes> inverse_; ///< one for each mode
    polynomial tried_, last_;
    std::optional<differentiable_model<std::size_t(motion)>> by_motion_;
    std::optional<differentiable_model<1>> by_approach_;
    std::optional<fast_edge<model_type>> edge_;
    bool known_ = false, goes_on_ = false, tried_well_ = false;
  };
};

} // namespace ricochet::stepper
