// Parameters from measured restitutions by least squares: of whatever gives restitutions for parameters (fit.hpp makes
// that of a family of models).
#pragma once
#include <ricochet/batch/share.hpp>
#include <ricochet/body/validate.hpp>
#include <ricochet/solve/accuracy.hpp>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>

#include <Eigen/QR>
#include <unsupported/Eigen/LevenbergMarquardt>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ricochet {

/// A measured collision. restitution: empty where the pair stuck. error: standard deviation of the restitution, of a
/// pair that stuck of its being zero; zero for all where none is known: they then count alike.
struct measurement {
  ricochet::speed speed;
  std::optional<double> restitution;
  double error = 0;
};

/// A number that is sought between low and high: by its logarithm, where low > 0.
struct free_parameter {
  std::string name;
  double low, high;
};

/// tolerance: of each restitution. starts: points of the box of parameters that are looked at before the best are followed. confidence: of the intervals; 0: none are sought. threads: 0 takes as many as the machine has. progress:
/// is told how many steps are done, of how many; they take unlike times.
struct fit_options {
  double tolerance = 1e-8;
  int starts = 32;
  double confidence = 0.95;
  unsigned threads = 0;
  progress_callback progress = {};
};

struct fitted_parameter {
  std::string name;
  double value;
  double standard_error; ///< from the derivatives at the best fit; infinite where the data do not tell
  double low, high;      ///< of the profile-likelihood interval, or of the box where it does not end inside
};

struct fit_result {
  std::vector<fitted_parameter> parameters;
  Eigen::MatrixXd correlation; ///< no numbers where the data do not tell all parameters
  double chi_square; ///< sum of squares of the residuals over their errors, or over `scatter` where none are known
  double scatter;    ///< standard deviation of one restitution, estimated from the residuals; 1 where errors are known
  int degrees_of_freedom;        ///< measured restitutions, and, of known errors, pairs that stuck and would not, less
                                 ///< parameters: pairs that stuck, and would, do not scatter
  std::vector<double> residuals; ///< measured minus fitted restitution; of pairs that stuck and would, zero
  std::vector<std::string> warnings; ///< what the data do not tell
  std::size_t collisions;            ///< that were computed
};

/// What is fitted: functions of the parameters, in the units of these, that give for each measurement
struct restitution_curve {
  /// the restitution, zero if the pair sticks, NaN if that cannot be told, to a tolerance,
  std::function<std::vector<double>(const std::vector<double>& parameters, double tolerance)> restitutions;
  /// and its derivatives: a row for each measurement, a column for each parameter. Without this, by differences.
  std::function<Eigen::MatrixXd(const std::vector<double>& parameters)> derivatives = {};
};

namespace detail {

class least_squares {
  using numbers = std::vector<double>;
  using in_double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

public:
  least_squares(const restitution_curve& curve, std::span<const measurement> data,
                std::span<const free_parameter> free, const fit_options& options)
      : curve_(curve), data_(data), free_(free), options_(options),
        steps_(2 + std::size_t(std::min(options.starts, 6) + std::min(options.starts, 2)) +
               (options.confidence > 0) * 2 * free.size()) {
    require("tolerance", options.tolerance, tolerance_range);
    require("starts", double(options.starts), range{.low = 1});
    require("confidence", options.confidence, range{.high = 1});
    if (free.empty())
      throw bad_input("fit: no parameter is free");
    for (const free_parameter& each : free) {
      require("low end of " + each.name, each.low, any_finite);
      require("high end of " + each.name, each.high, range{.low = each.low, .low_included = false});
      if (each.low > 0 && !std::isfinite(each.high / each.low))
        throw bad_input("the range of " + each.name + " is too wide");
    }
    errors_known_ = !data.empty() && data[0].error > 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const std::string which = "measurement " + std::to_string(i) + ": ";
      require(which + "speed", data[i].speed, positive);
      require(which + "restitution", data[i].restitution.value_or(0), range{.high = 1.5});
      require(which + "error", data[i].error, non_negative);
      if ((data[i].error > 0) != errors_known_)
        throw bad_input(which + "errors must be given for all measurements or for none");
      bounced_ += data[i].restitution.has_value();
    }
    if (errors_known_ ? data.size() < free.size() : bounced_ <= free.size())
      throw bad_input("fit: " + std::to_string(errors_known_ ? data.size() : bounced_) +
                      (errors_known_ ? " measurements" : " measured restitutions, of unknown errors,") +
                      " are too few for " + std::to_string(free.size()) + " free parameters");
  }

  fit_result solve() {
    std::vector<std::pair<double, numbers>> places = looked_at();
    one_more_step();
    // Most of the best points lie where some parameter is of no account: more than one way down is tried.
    const std::vector<bool> all(free_.size(), true);
    places.resize(std::min<std::size_t>(places.size(), 6));
    for (auto& [square_sum, x] : places) {
      square_sum = minimise(x, all, 1e-3, 5);
      one_more_step();
    }
    std::sort(places.begin(), places.end());
    places.resize(std::min<std::size_t>(places.size(), 2));
    for (auto& [square_sum, x] : places) {
      square_sum = minimise(x, all, 1e-9, 200);
      one_more_step();
    }
    auto [least, best] = *std::min_element(places.begin(), places.end());
    look_around(best, least);
    return judged(best, least);
  }

private:
  void one_more_step() {
    ++done_;
    if (options_.progress)
      options_.progress(done_, steps_);
  }

  /// Position in the box, each in [0, 1], as parameters.
  numbers at(const numbers& x) const {
    numbers p(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto& [name, low, high] = free_[k];
      p[k] = low > 0 ? low * std::pow(high / low, x[k]) : low + (high - low) * x[k];
    }
    return p;
  }
  double slope_of_position(std::size_t k, const numbers& p) const {
    const auto& [name, low, high] = free_[k];
    return low > 0 ? p[k] * std::log(high / low) : high - low;
  }

  double error_of(std::size_t i) const { return errors_known_ ? data_[i].error : 1; }

  /// (fitted - measured)/error; a pair that stuck, and would, fits. A collision that cannot be resolved deviates by more
  /// than any that can, so that the search turns elsewhere.
  Eigen::VectorXd residuals(const numbers& x, double tolerance) {
    const std::vector<double> e = restitutions(at(x), tolerance);
    Eigen::VectorXd r(data_.size());
    for (std::size_t i = 0; i < data_.size(); ++i)
      r[Eigen::Index(i)] = (std::isnan(e[i]) ? 2 : e[i] - data_[i].restitution.value_or(0)) / error_of(i);
    return r;
  }
  std::vector<double> restitutions(const numbers& parameters, double tolerance) {
    std::vector<double> e = curve_.restitutions(parameters, tolerance);
    if (e.size() != data_.size())
      throw bad_input("fit: the curve gives " + std::to_string(e.size()) + " restitutions for " +
                      std::to_string(data_.size()) + " measurements");
    collisions_ += e.size();
    unresolved_ = std::any_of(e.begin(), e.end(), [](double each) { return std::isnan(each); });
    return e;
  }

  /// Of the residuals by the position in the box.
  Eigen::MatrixXd derivatives(const numbers& x) {
    if (!curve_.derivatives)
      return differences(x);
    const numbers p = at(x);
    Eigen::MatrixXd jacobian = curve_.derivatives(p);
    if (jacobian.rows() != Eigen::Index(data_.size()) || jacobian.cols() != Eigen::Index(p.size()))
      throw bad_input("fit: the curve gives derivatives of " + std::to_string(jacobian.rows()) + " restitutions by " +
                      std::to_string(jacobian.cols()) + " parameters");
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i)
      for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
        jacobian(i, k) *= slope_of_position(std::size_t(k), p) / error_of(std::size_t(i));
    return jacobian;
  }

  Eigen::MatrixXd differences(const numbers& x) {
    constexpr double h = 1e-4; // errors of restitutions over h are then as small as the next term of the series
    const double tolerance = std::min(options_.tolerance, 1e-9);
    Eigen::MatrixXd jacobian(data_.size(), x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      numbers above = x, below = x;
      above[k] = std::min(1., x[k] + h);
      below[k] = std::max(0., x[k] - h);
      jacobian.col(Eigen::Index(k)) =
          (residuals(above, tolerance) - residuals(below, tolerance)) / (above[k] - below[k]);
    }
    return jacobian;
  }

  /// The box at evenly spread points, the best first.
  std::vector<std::pair<double, numbers>> looked_at() {
    boost::random::sobol spread(free_.size());
    boost::random::uniform_01<double> uniform;
    std::vector<std::pair<double, numbers>> points;
    for (int i = 0; i < options_.starts; ++i) {
      numbers x(free_.size());
      for (double& each : x)
        each = 0.02 + 0.96 * uniform(spread);
      points.emplace_back(residuals(x, 1e-4).squaredNorm(), x);
    }
    std::sort(points.begin(), points.end());
    return points;
  }

  /// x = (1 + sin u)/2 keeps the position in the box.
  struct functor : Eigen::DenseFunctor<double> {
    functor(least_squares& all, const numbers& x, const std::vector<std::size_t>& moving)
        : Eigen::DenseFunctor<double>(int(moving.size()), int(all.data_.size())), fit(all), from(x), moves(moving) {}

    numbers position(const Eigen::VectorXd& u) const {
      numbers x = from;
      for (std::size_t m = 0; m < moves.size(); ++m)
        x[moves[m]] = (1 + std::sin(u[Eigen::Index(m)])) / 2;
      return x;
    }
    int operator()(const Eigen::VectorXd& u, Eigen::VectorXd& r) const {
      r = fit.residuals(position(u), fit.options_.tolerance);
      return 0;
    }
    int df(const Eigen::VectorXd& u, Eigen::MatrixXd& jacobian) const {
      const Eigen::MatrixXd whole = fit.derivatives(position(u));
      for (std::size_t m = 0; m < moves.size(); ++m)
        jacobian.col(Eigen::Index(m)) = whole.col(Eigen::Index(moves[m])) * (std::cos(u[Eigen::Index(m)]) / 2);
      return 0;
    }

    least_squares& fit;
    numbers from;
    std::vector<std::size_t> moves;
  };

  /// Least sum of squares next to x, with the positions that are free; x becomes the place.
  double minimise(numbers& x, const std::vector<bool>& free, double precision, int most) {
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < free.size(); ++k)
      if (free[k])
        moving.push_back(k);
    if (moving.empty())
      return residuals(x, options_.tolerance).squaredNorm();
    functor problem(*this, x, moving);
    Eigen::VectorXd u(moving.size());
    for (std::size_t m = 0; m < moving.size(); ++m)
      u[Eigen::Index(m)] = std::asin(std::clamp(2 * x[moving[m]] - 1, -0.9999, 0.9999));
    Eigen::LevenbergMarquardt<functor> search(problem);
    search.setMaxfev(most);
    search.setFtol(precision);
    search.setXtol(precision);
    search.minimize(u);
    x = problem.position(u);
    return square(search.fnorm());
  }

  /// Slopes lead to the nearest minimum only, and there are many: the sum jumps where a pair that stuck begins to bounce,
  /// and is flat where a parameter is of no account. Looks near and far along each parameter for a better place, and goes
  /// down from there.
  void look_around(numbers& best, double& least) {
    for (int round = 0; round < 5; ++round) {
      numbers better = best;
      double lowest = least;
      for (std::size_t k = 0; k < best.size(); ++k) {
        constexpr int looks = 32;
        std::vector<double> places{best[k] - 0.01, best[k] - 0.003, best[k] + 0.003, best[k] + 0.01};
        for (int i = 0; i < looks; ++i)
          places.push_back((i + 0.5) / looks);
        for (const double place : places) {
          numbers x = best;
          x[k] = place;
          if (!(place > 0 && place < 1))
            continue;
          if (const double square_sum = residuals(x, options_.tolerance).squaredNorm(); square_sum < lowest) {
            lowest = square_sum;
            better = x;
          }
        }
      }
      if (!(lowest < least * (1 - 1e-6)))
        return;
      least = minimise(better, std::vector<bool>(best.size(), true), 1e-9, 200);
      best = better;
    }
  }

  static std::string rounded(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", x);
    return text;
  }

  /// That noise of the errors given makes so large a chi^2.
  static double chance(const fit_result& result) {
    return boost::math::gamma_q(result.degrees_of_freedom / 2., result.chi_square / 2, in_double());
  }

  fit_result judged(const numbers& best, double square_sum) {
    const numbers p = at(best);
    const auto n = Eigen::Index(p.size());
    fit_result result{};
    result.degrees_of_freedom = int(bounced_) - int(p.size());
    const std::vector<double> e = restitutions(p, options_.tolerance);
    for (std::size_t i = 0; i < data_.size(); ++i) {
      if (std::isnan(e[i]))
        throw bad_input("fit: the search ended where the collision at " + shown(in_si(data_[i].speed)) +
                        " m/s cannot be resolved; narrow the ranges of the free parameters");
      result.residuals.push_back(data_[i].restitution.value_or(0) - e[i]);
      result.degrees_of_freedom += errors_known_ && !data_[i].restitution && e[i] > 0;
    }
    result.scatter = errors_known_ ? 1 : std::sqrt(square_sum / result.degrees_of_freedom);
    result.chi_square = errors_known_ ? square_sum : result.degrees_of_freedom;

    const std::string chi_square =
        "chi^2 = " + rounded(result.chi_square) + " of " + std::to_string(result.degrees_of_freedom) + " degrees of freedom: ";
    if (errors_known_ && result.degrees_of_freedom > 0 && !(chance(result) > 1e-3))
      result.warnings.push_back(chi_square + "the model does not describe the data, or their errors are larger");
    if (errors_known_ && result.degrees_of_freedom > 0 && chance(result) > 1 - 1e-6)
      result.warnings.push_back(chi_square + "the errors are smaller than those given");
    if (result.scatter == 0)
      result.warnings.push_back("the fit is exact, so that the scatter of the data is not known: intervals have no width");
    const Eigen::MatrixXd jacobian = derivatives(best);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(jacobian);
    decomposed.setThreshold(1e-7);
    const bool told = decomposed.rank() == n;
    Eigen::MatrixXd covariance = // of restitutions that scatter by one
        Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
    if (told) {
      const Eigen::MatrixXd inverse = decomposed.solve(Eigen::MatrixXd::Identity(jacobian.rows(), jacobian.rows()));
      covariance = inverse * inverse.transpose();
    }
    result.correlation = told ? Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n))
                              : Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
    if (!told)
      result.warnings.push_back("the data do not tell all parameters: of " + std::to_string(n) + " only " +
                                std::to_string(decomposed.rank()) + " can be known, or so many combinations of them");
    for (Eigen::Index k = 0; k < n; ++k)
      if (jacobian.col(k).norm() == 0)
        result.warnings.push_back(free_[std::size_t(k)].name + " changes none of the restitutions measured");
    for (Eigen::Index k = 0; k < n; ++k)
      for (Eigen::Index l = 0; told && l < k; ++l) {
        const double c = covariance(k, l) / std::sqrt(covariance(k, k) * covariance(l, l));
        result.correlation(k, l) = result.correlation(l, k) = c;
        if (std::abs(c) > 0.99)
          result.warnings.push_back(free_[std::size_t(l)].name + " and " + free_[std::size_t(k)].name +
                                    " can hardly be told apart: their correlation is " + rounded(c));
      }
    one_more_step();
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double of_position = result.scatter * std::sqrt(covariance(Eigen::Index(k), Eigen::Index(k)));
      fitted_parameter parameter{free_[k].name, p[k], of_position * slope_of_position(k, p), free_[k].low,
                                 free_[k].high};
      for (const double end : {0., 1.})
        if (std::abs(best[k] - end) < 1e-3 && jacobian.col(Eigen::Index(k)).norm() > 0)
          result.warnings.push_back(free_[k].name + ": the best fit is at the " + (end == 0 ? "lower" : "upper") +
                                    " end of the range searched, " + shown(end == 0 ? free_[k].low : free_[k].high));
      if (options_.confidence > 0)
        seek_interval(best, square_sum, k, of_position, parameter, result);
      result.parameters.push_back(parameter);
    }
    result.collisions = collisions_;
    return result;
  }

  /// Where the least sum of squares with this parameter held exceeds the least of all by what the confidence asks for.
  void seek_interval(const numbers& best, double least, std::size_t k, double standard_error,
                     fitted_parameter& parameter, fit_result& result) {
    using namespace boost::math;
    const double upper_tail = (1 + options_.confidence) / 2;
    const double allowed =
        square(errors_known_ ? quantile(normal_distribution<double, in_double>(), upper_tail)
                             : result.scatter * quantile(students_t_distribution<double, in_double>(
                                                             result.degrees_of_freedom),
                                                         upper_tail));
    std::vector<bool> free(best.size(), true);
    free[k] = false;
    for (const double side : {-1., 1.}) {
      numbers near = best; // the others move along with it
      const auto excess = [&](double position) {
        near[k] = position;
        return minimise(near, free, 1e-5, 200) - least - allowed;
      };
      const double end = side < 0 ? 0 : 1;
      double inside = best[k], value_inside = -allowed;
      double step = side * std::clamp(2 * standard_error, 1e-9, 0.25);
      for (;; step *= 2) {
        const double outside = side * (inside + step - end) < 0 ? inside + step : end;
        const double value = excess(outside);
        if (value > 0) {
          const auto close = [&](double a, double b) { return std::abs(b - a) < 1e-3 * std::abs(b - best[k]); };
          std::uintmax_t most = 30;
          const bool up = outside > inside;
          const auto bracket = tools::toms748_solve(excess, up ? inside : outside, up ? outside : inside,
                                                    up ? value_inside : value, up ? value : value_inside, close, most);
          numbers found = best;
          found[k] = (bracket.first + bracket.second) / 2;
          (side < 0 ? parameter.low : parameter.high) = at(found)[k];
          (void)excess(outside);
          if (unresolved_)
            result.warnings.push_back(free_[k].name + ": the interval ends at " + shown(at(found)[k]) +
                                      ", where collisions cannot be resolved any more");
          break;
        }
        if (outside == end && std::abs(best[k] - end) < 1e-3) // which has been said
          break;
        if (outside == end) {
          result.warnings.push_back(free_[k].name + ": the data give no " + (side < 0 ? "lower" : "upper") +
                                    " limit within the range searched, which ends at " +
                                    shown(side < 0 ? free_[k].low : free_[k].high));
          break;
        }
        inside = outside;
        value_inside = value;
      }
      one_more_step();
    }
  }

  const restitution_curve& curve_;
  std::span<const measurement> data_;
  std::span<const free_parameter> free_;
  const fit_options& options_;
  std::size_t bounced_ = 0;
  bool errors_known_ = false;
  bool unresolved_ = false; ///< was a collision, when last looked at?
  std::size_t collisions_ = 0, done_ = 0, steps_;
};

} // namespace detail

/// Least squares: the parameters with which the curve comes closest to the measurements. Sticking is data: a pair that
/// stuck fits where the curve is zero, and else deviates by the curve's restitution.
///
/// From the best six of `starts` points that fill the box of parameters some steps down each, and from the best two of
/// these all the way, by Levenberg-Marquardt; from the better of both it looks about, near and far. The intervals are by
/// profile likelihood: all other parameters are fitted anew for each value of the one; of unknown errors, by Student's t.
/// \throws bad_input naming the measurement or parameter that is out of range, or if a collision cannot be resolved at
/// the best fit; and what the curve throws
inline fit_result fit_curve(const restitution_curve& curve, std::span<const measurement> data,
                            std::span<const free_parameter> free, const fit_options& options = {}) {
  return detail::least_squares(curve, data, free, options).solve();
}

} // namespace ricochet
