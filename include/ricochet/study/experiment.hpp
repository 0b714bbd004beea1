// At which speeds to measure, so that a fit tells the parameters best.
#pragma once
#include <ricochet/batch/share.hpp>
#include <ricochet/study/sensitivity.hpp>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <span>

namespace ricochet {

/// What share of the measurements to make at each candidate, >= 0, their sum being 1; and the variance of each one's
/// prediction, over that of a measurement, times the number of measurements. N over the largest of these, N the number
/// of parameters, is a lower bound of det(M)^{1/N} over the largest there is.
struct optimal_shares {
  Eigen::VectorXd share, variance;
};

namespace detail {
/// Of a matrix whose columns are about as long as each other.
inline Eigen::Index rank_of(const Eigen::MatrixXd& x) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(x);
  decomposed.setThreshold(1e-7);
  return decomposed.rank();
}
/// Columns that span the same, at right angles.
inline Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& x) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> decomposed(x);
  return decomposed.householderQ() * Eigen::MatrixXd::Identity(x.rows(), x.cols());
}
} // namespace detail

/// D-optimal shares: those with the largest det(M), M = sum of share_i x_i x_i^T, so that the parameters' confidence
/// ellipsoid is the smallest. At the optimum no candidate's x_i^T M^-1 x_i exceeds the number of parameters [Kiefer &
/// Wolfowitz 1960]; the search ends where none does by more than `gap`, relatively, or after 100 000 exchanges.
/// derivatives: of what is measured by the parameters, one row x_i a candidate, one column a parameter.
/// By exchange: from that candidate of some share where the prediction's variance is least, to the one where it is
/// largest, so much as makes det(M) largest [Fedorov 1972; Boehning 1986, Metrika 33 337].
/// \throws bad_input if the candidates do not tell all parameters, or gap is outside [1e-10, 1e-1].
inline optimal_shares d_optimal_shares(const Eigen::MatrixXd& derivatives, double gap = 1e-6) {
  require("gap", gap, range{.low = 1e-10, .high = 1e-1, .high_included = true});
  const Eigen::Index candidates = derivatives.rows(), N = derivatives.cols();
  if (!derivatives.allFinite())
    throw bad_input("optimal shares: a derivative is no finite number");
  const auto refuse = [&](Eigen::Index rank) {
    throw bad_input("optimal shares: the candidates tell " + std::to_string(rank) + " combinations of " +
                    std::to_string(N) + " parameters");
  };
  if (N == 0 || candidates < N)
    refuse(candidates);
  const Eigen::VectorXd unit = derivatives.colwise().norm().transpose(); // the shares do not depend on it
  const Eigen::MatrixXd scaled_derivatives =
      derivatives * (unit.array() > 0).select(unit, 1).cwiseInverse().matrix().asDiagonal();
  if (const Eigen::Index rank = detail::rank_of(scaled_derivatives); rank < N)
    refuse(rank);
  const Eigen::MatrixXd x = detail::orthonormal(scaled_derivatives); // nothing depends on more than what it spans
  optimal_shares found{Eigen::VectorXd::Constant(candidates, 1 / double(candidates)), {}};
  auto& [share, variance] = found;
  for (long round = 0;; ++round) {
    const Eigen::LLT<Eigen::MatrixXd> information(x.transpose() * share.asDiagonal() * x);
    const Eigen::MatrixXd scaled = information.matrixL().solve(x.transpose()); // columns L^-1 x_i
    variance = scaled.colwise().squaredNorm().transpose();
    Eigen::Index to, from = -1;
    if (variance.maxCoeff(&to) <= double(N) * (1 + gap) || round == 100'000)
      return found;
    for (Eigen::Index i = 0; i < candidates; ++i)
      if (share[i] > 0 && (from < 0 || variance[i] < variance[from]))
        from = i;
    const double gain = variance[to] - variance[from];
    const double bend = variance[to] * variance[from] - square(scaled.col(to).dot(scaled.col(from)));
    const double moved = bend > 0 ? std::min(share[from], gain / (2 * bend)) : share[from];
    share[to] += moved;
    share[from] = moved < share[from] ? share[from] - moved : 0;
  }
}

/// So many measurements, in whole numbers: the shares rounded, then measurement by measurement moved to another
/// candidate as long as that makes det(M) larger [Fedorov 1972]. derivatives: as for d_optimal_shares(). \throws
/// bad_input if there are fewer measurements than parameters.
inline std::vector<int> whole_measurements(const Eigen::MatrixXd& derivatives, const optimal_shares& optimum,
                                           int measurements) {
  require("measurements", double(measurements), range{.low = double(std::max<Eigen::Index>(1, derivatives.cols()))});
  if (optimum.share.size() != derivatives.rows() || !(derivatives.colwise().norm().array() > 0).all())
    throw bad_input("whole measurements: the shares are not those of these candidates, or a parameter changes nothing");
  const Eigen::VectorXd wanted = measurements * optimum.share;
  Eigen::VectorXd number = wanted.array().floor();
  for (Eigen::Index at; measurements - number.sum() > 0.5; number[at] += 1)
    (wanted - number).maxCoeff(&at);
  const Eigen::MatrixXd spanned =
      detail::orthonormal(derivatives * derivatives.colwise().norm().cwiseInverse().asDiagonal());
  const Eigen::LLT<Eigen::MatrixXd> at_optimum(spanned.transpose() * optimum.share.asDiagonal() * spanned);
  const Eigen::MatrixXd x = at_optimum.matrixL().solve(spanned.transpose()).transpose(); // their information is about one
  bool better = true;
  for (int round = 0; better && round < 10'000; ++round) {
    better = false;
    // A little of the optimum, lest rounded numbers that do not tell all parameters have no inverse.
    const Eigen::LLT<Eigen::MatrixXd> information(x.transpose() * (number + 1e-6 * wanted).asDiagonal() * x);
    const Eigen::MatrixXd scaled = information.matrixL().solve(x.transpose());
    double largest = 1 + 1e-9;
    Eigen::Index from = 0, to = 0;
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      for (Eigen::Index j = 0; number[i] > 0 && j < x.rows(); ++j) {
        const double grown = (1 - scaled.col(i).squaredNorm()) * (1 + scaled.col(j).squaredNorm()) +
                             square(scaled.col(i).dot(scaled.col(j))); // det(M), by the move
        if (grown > largest) {
          largest = grown;
          from = i;
          to = j;
          better = true;
        }
      }
    if (better) {
      number[from] -= 1;
      number[to] += 1;
    }
  }
  std::vector<int> whole;
  for (const double n : number)
    whole.push_back(int(n));
  return whole;
}

/// Standard errors of parameters by a fit to so many measurements of each candidate, each with this standard deviation:
/// roots of the diagonal of error^2 (sum of n_i x_i x_i^T)^-1; infinite where the measurements do not tell all of them.
/// \throws bad_input if there is not one number, >= 0, for each candidate, or error is not above 0
inline Eigen::VectorXd promised_errors(const Eigen::MatrixXd& derivatives, const std::vector<int>& number,
                                       double error) {
  if (number.size() != std::size_t(derivatives.rows()))
    throw bad_input("promised errors: " + std::to_string(number.size()) + " numbers of measurements for " +
                    std::to_string(derivatives.rows()) + " candidates");
  require("error", error, positive);
  Eigen::MatrixXd measured = derivatives;
  for (Eigen::Index i = 0; i < measured.rows(); ++i) {
    const int n = number[std::size_t(i)];
    require("number of measurements", double(n), non_negative);
    measured.row(i) *= std::sqrt(double(n));
  }
  const Eigen::VectorXd unit = measured.colwise().norm().transpose();
  const bool told =
      (unit.array() > 0).all() && detail::rank_of(measured * unit.cwiseInverse().asDiagonal()) == measured.cols();
  if (!told)
    return Eigen::VectorXd::Constant(measured.cols(), std::numeric_limits<double>::infinity());
  return error * (measured.transpose() * measured).inverse().diagonal().cwiseSqrt();
}

/// measurements: how many. error: standard deviation of each restitution. gap: as for d_optimal_shares(). tolerance: of
/// the restitutions. threads: 0 takes as many as the machine has. progress: told how many candidates are looked at.
struct experiment_options {
  int measurements = 20;
  double error = 0.01;
  double gap = 1e-6;
  double tolerance = 1e-6;
  unsigned threads = 0;
  progress_callback progress = {};
};

/// Of the candidates, in their order: restitution, its derivatives by the logarithms of the parameters (a row each),
/// D-optimal shares, and the whole numbers of measurements. relative_errors: the standard errors of the parameters,
/// over their values, that a fit to these promises.
struct experiment_plan {
  std::vector<double> restitution;
  Eigen::MatrixXd derivatives;
  optimal_shares optimum;
  std::vector<int> measurements;
  Eigen::VectorXd relative_errors;
};

/// Restitutions of a family's model at these speeds and their derivatives by the logarithms of its numbers p, all > 0.
/// Those of pairs that stick are zero. \throws bad_input as sensitivities()
template <std::size_t N, class Family>
std::vector<differentiated_restitution<N>>
family_sensitivities(const Family& family, const std::array<double, N>& p, std::span<const speed> speeds,
                     double tolerance = 1e-6, unsigned threads = 0, const progress_callback& progress = {}) {
  std::array<double, N> step;
  for (std::size_t k = 0; k < N; ++k) {
    require("parameter " + std::to_string(k), p[k], positive);
    step[k] = 1e-3 * p[k];
  }
  require("tolerance", tolerance, tolerance_range);
  const auto model = family(p);
  auto slope = detail::slopes_of_quantities(family, p, step);
  for (auto& of_quantity : slope)
    for (std::size_t k = 0; k < N; ++k)
      of_quantity[k] *= p[k];
  std::vector<differentiated_restitution<N>> all(speeds.size());
  detail::share(speeds.size(), 1, threads, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      require("speed", speeds[i], positive);
      const detail::moving_scene<N, std::remove_cvref_t<decltype(model)>> scene{model, impact{speeds[i]}, slope};
      all[i] = detail::differentiate(scene, {.tolerance = tolerance});
    }
  });
  return all;
}

/// The derivatives as a matrix, a row each.
template <std::size_t N>
Eigen::MatrixXd derivatives_of(const std::vector<differentiated_restitution<N>>& restitutions) {
  Eigen::MatrixXd derivatives(restitutions.size(), N);
  for (std::size_t i = 0; i < restitutions.size(); ++i)
    for (std::size_t k = 0; k < N; ++k)
      derivatives(Eigen::Index(i), Eigen::Index(k)) = restitutions[i].derivative[k];
  return derivatives;
}

/// How often to measure the restitution at which of the candidate speeds, to learn a family's numbers best, if they are
/// about these. The plan is for small errors: as far as e(v) is a straight line over what is not known of them, which
/// it is not next to the sticking speed, so take no candidates there.
/// family: makes a model from an std::array of N numbers, all > 0, without a tangential law
/// \throws bad_input naming what is out of range, if the candidates do not tell all numbers, if there are fewer
/// measurements than numbers, or if a collision cannot be resolved
template <std::size_t N, class Family>
experiment_plan optimal_speeds(const Family& family, const std::array<double, N>& parameters,
                               std::span<const speed> candidates, const experiment_options& options = {}) {
  require("error", options.error, positive);
  const auto found =
      family_sensitivities(family, parameters, candidates, options.tolerance, options.threads, options.progress);
  experiment_plan plan{{}, derivatives_of(found), {}, {}, {}};
  for (const auto& each : found)
    plan.restitution.push_back(each.value);
  plan.optimum = d_optimal_shares(plan.derivatives, options.gap);
  plan.measurements = whole_measurements(plan.derivatives, plan.optimum, options.measurements);
  plan.relative_errors = promised_errors(plan.derivatives, plan.measurements, options.error);
  return plan;
}

} // namespace ricochet
