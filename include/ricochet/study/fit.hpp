// Which parameters of a family of models measured restitutions tell, and how well.
#pragma once
#include <ricochet/batch/batch.hpp>
#include <ricochet/study/sensitivity.hpp>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>

#include <Eigen/QR>
#include <unsupported/Eigen/LevenbergMarquardt>

#include <span>

namespace ricochet {

/// A measured collision. restitution: empty where the pair stuck. error: standard deviation of the restitution, of a
/// pair that stuck of its being zero; zero for all where none is known: they then count alike.
struct measurement {
  ricochet::speed speed;
  std::optional<double> restitution;
  double error = 0;
};

/// A number that a family of models takes, in the family's own unit, sought between low and high: by its logarithm,
/// where low > 0.
struct free_parameter {
  std::string name;
  double low, high;
};

/// tolerance: of each restitution. starts: points of the box of parameters that are looked at before the best three are
/// followed. confidence: of the intervals; 0: none are sought. threads: 0 takes as many as the machine has.
struct fit_options {
  double tolerance = 1e-8;
  int starts = 32;
  double confidence = 0.95;
  unsigned threads = 0;
};

struct fitted_parameter {
  std::string name;
  double value;
  double standard_error; ///< from the derivatives at the best fit; infinite where the data do not tell
  double low, high;      ///< of the profile-likelihood interval, or of the box where it does not end inside
};

struct fit_result {
  std::vector<fitted_parameter> parameters;
  Eigen::MatrixXd correlation;
  double chi_square; ///< sum of squares of the residuals over their errors, or over `scatter` where none are known
  double scatter;    ///< standard deviation of one restitution, estimated from the residuals; 1 where errors are known
  int degrees_of_freedom;        ///< measured restitutions less parameters: pairs that stuck, and would, do not scatter
  std::vector<double> residuals; ///< measured minus fitted restitution; of pairs that stuck and would, zero
  std::vector<std::string> warnings; ///< what the data do not tell
  std::size_t collisions;            ///< that were computed
};

namespace detail {

/// `Family` makes a model from N numbers.
template <std::size_t N, class Family>
class fitting {
  using numbers = std::array<double, N>;
  using model_type = std::remove_cvref_t<std::invoke_result_t<const Family&, const numbers&>>;

public:
  fitting(const Family& family, std::span<const measurement> data, const std::array<free_parameter, N>& free,
          const fit_options& options)
      : family_(family), data_(data), free_(free), options_(options) {
    require("tolerance", options.tolerance, tolerance_range);
    require("starts", double(options.starts), range{.low = 1});
    require("confidence", options.confidence, range{.high = 1});
    for (const free_parameter& each : free) {
      require("low end of " + each.name, each.low, any_finite);
      require("high end of " + each.name, each.high, range{.low = each.low, .low_included = false});
    }
    errors_known_ = !data.empty() && data[0].error > 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const std::string which = "measurement " + std::to_string(i) + ": ";
      require(which + "speed", data[i].speed, positive);
      require(which + "restitution", data[i].restitution.value_or(0), range{.high = 1.5});
      require(which + "error", data[i].error, non_negative);
      if ((data[i].error > 0) != errors_known_)
        throw bad_input(which + "errors must be given for all measurements or for none");
      impacts_.push_back({data[i].speed});
      bounced_ += data[i].restitution.has_value();
    }
    if (errors_known_ ? data.size() < N : bounced_ <= N)
      throw bad_input("fit: " + std::to_string(errors_known_ ? data.size() : bounced_) +
                      (errors_known_ ? " measurements" : " measured restitutions, of unknown errors,") +
                      " are too few for " + std::to_string(N) + " free parameters");
  }

  fit_result solve() {
    std::vector<std::pair<double, numbers>> starts = looked_at();
    double best = std::numeric_limits<double>::infinity();
    numbers x{};
    std::array<bool, N> all;
    all.fill(true);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, starts.size()); ++i) {
      numbers from = starts[i].second;
      if (const double square_sum = minimise(from, all, 1e-9); square_sum < best) {
        best = square_sum;
        x = from;
      }
    }
    return judged(x, best);
  }

private:
  /// Position in the box, each in [0, 1], as numbers for the family.
  numbers at(const numbers& x) const {
    numbers p;
    for (std::size_t k = 0; k < N; ++k) {
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

  /// (fitted - measured)/error of one measurement; a pair that stuck, and would, fits.
  double residual(std::size_t i, double e) const { return (e - data_[i].restitution.value_or(0)) / error_of(i); }

  Eigen::VectorXd residuals(const numbers& x, double tolerance) {
    const auto outcomes = collide(family_(at(x)), std::span<const impact>(impacts_),
                                  batch_options{.tolerance = tolerance, .threads = options_.threads});
    Eigen::VectorXd r(data_.size());
    for (std::size_t i = 0; i < data_.size(); ++i)
      r[Eigen::Index(i)] = residual(i, outcomes[i].restitution.value_or(0));
    collisions_ += data_.size();
    return r;
  }

  static constexpr double derivative_tolerance = 1e-4; ///< a search needs no more, nor do standard errors

  /// Derivatives of the residuals by the position in the box.
  Eigen::MatrixXd derivatives(const numbers& x) {
    const numbers p = at(x);
    const model_type model = family_(p);
    const std::vector<numbers> slope = slope_of_quantities(p);
    Eigen::MatrixXd jacobian(data_.size(), N);
    share(data_.size(), 2, options_.threads, {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const moving_scene<N, model_type> scene{model, impact{data_[i].speed}, slope};
        const auto e = differentiate(scene, {.tolerance = derivative_tolerance});
        for (std::size_t k = 0; k < N; ++k)
          jacobian(Eigen::Index(i), Eigen::Index(k)) = e.derivative[k] * slope_of_position(k, p) / error_of(i);
      }
    });
    collisions_ += 3 * data_.size();
    return jacobian;
  }

  /// By p, of all quantities of the model and, a last row of zeros, the speed; by differences of the family's formulas.
  std::vector<numbers> slope_of_quantities(const numbers& p) const {
    std::vector<numbers> slope(quantity_count<model_type> + 1);
    const auto quantities = [&](numbers q, std::size_t k, double step) {
      q[k] += step;
      const model_type model = family_(q);
      std::vector<double> all;
      for_each_quantity(model, [&](const char*, const auto& quantity) { all.push_back(in_si(quantity)); });
      return all;
    };
    for (std::size_t k = 0; k < N; ++k) {
      const double h = 1e-3 * (free_[k].low > 0 ? p[k] : free_[k].high - free_[k].low);
      const auto up = quantities(p, k, h), down = quantities(p, k, -h), far_up = quantities(p, k, 2 * h),
                 far_down = quantities(p, k, -2 * h);
      for (std::size_t i = 0; i < up.size(); ++i) {
        const double by_two = (far_up[i] - far_down[i]) / (4 * h), by_one = (up[i] - down[i]) / (2 * h);
        slope[i][k] = up[i] == down[i] ? 0 : (4 * by_one - by_two) / 3;
      }
    }
    return slope;
  }

  /// The box at evenly spread points, the best first.
  std::vector<std::pair<double, numbers>> looked_at() {
    boost::random::sobol spread(N);
    boost::random::uniform_01<double> uniform;
    std::vector<std::pair<double, numbers>> points;
    for (int i = 0; i < options_.starts; ++i) {
      numbers x;
      for (double& each : x)
        each = 0.02 + 0.96 * uniform(spread);
      points.emplace_back(residuals(x, 1e-4).squaredNorm(), x);
    }
    std::sort(points.begin(), points.end());
    return points;
  }

  /// x = (1 + sin u)/2 keeps the position in the box.
  struct functor : Eigen::DenseFunctor<double> {
    functor(fitting& all, const numbers& x, const std::vector<std::size_t>& moving)
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

    fitting& fit;
    numbers from;
    std::vector<std::size_t> moves;
  };

  /// Least sum of squares next to x, with the positions that are free; x becomes the place.
  double minimise(numbers& x, const std::array<bool, N>& free, double precision) {
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < N; ++k)
      if (free[k])
        moving.push_back(k);
    if (moving.empty())
      return residuals(x, options_.tolerance).squaredNorm();
    functor problem(*this, x, moving);
    Eigen::VectorXd u(moving.size());
    for (std::size_t m = 0; m < moving.size(); ++m)
      u[Eigen::Index(m)] = std::asin(std::clamp(2 * x[moving[m]] - 1, -0.9999, 0.9999));
    Eigen::LevenbergMarquardt<functor> search(problem);
    search.setMaxfev(200);
    search.setFtol(precision);
    search.setXtol(precision);
    search.minimize(u);
    x = problem.position(u);
    return square(search.fnorm());
  }

  fit_result judged(const numbers& best, double square_sum) {
    const numbers p = at(best);
    fit_result result{};
    result.degrees_of_freedom = int(bounced_) - int(N);
    result.scatter = errors_known_ ? 1 : std::sqrt(square_sum / result.degrees_of_freedom);
    result.chi_square = square_sum / square(result.scatter);
    const Eigen::VectorXd r = residuals(best, options_.tolerance);
    for (std::size_t i = 0; i < data_.size(); ++i)
      result.residuals.push_back(-r[Eigen::Index(i)] * error_of(i));

    const Eigen::MatrixXd jacobian = derivatives(best);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(jacobian);
    decomposed.setThreshold(1e-7);
    const bool told = decomposed.rank() == Eigen::Index(N);
    const Eigen::MatrixXd covariance =
        told ? Eigen::MatrixXd((jacobian.transpose() * jacobian).inverse() * square(result.scatter))
             : Eigen::MatrixXd::Constant(N, N, std::numeric_limits<double>::infinity());
    result.correlation = Eigen::MatrixXd::Identity(N, N);
    if (!told)
      result.warnings.push_back("the data do not tell all parameters: " + std::to_string(decomposed.rank()) +
                                " combinations of " + std::to_string(N) + " change the restitutions measured");
    for (Eigen::Index k = 0; k < Eigen::Index(N); ++k)
      for (Eigen::Index l = 0; told && l < k; ++l) {
        const double c = covariance(k, l) / std::sqrt(covariance(k, k) * covariance(l, l));
        result.correlation(k, l) = result.correlation(l, k) = c;
        if (std::abs(c) > 0.99)
          result.warnings.push_back(free_[std::size_t(l)].name + " and " + free_[std::size_t(k)].name +
                                    " can hardly be told apart: their correlation is " + shown(c));
      }
    for (std::size_t k = 0; k < N; ++k) {
      const double of_position = std::sqrt(covariance(Eigen::Index(k), Eigen::Index(k)));
      fitted_parameter parameter{free_[k].name, p[k], of_position * slope_of_position(k, p), free_[k].low,
                                 free_[k].high};
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
    const double allowed =
        errors_known_
            ? quantile(chi_squared(1), options_.confidence)
            : square(result.scatter * quantile(students_t(result.degrees_of_freedom), (1 + options_.confidence) / 2));
    std::array<bool, N> free;
    free.fill(true);
    free[k] = false;
    for (const double side : {-1., 1.}) {
      numbers near = best; // the others move along with it
      const auto excess = [&](double position) {
        near[k] = position;
        return minimise(near, free, 1e-5) - least - allowed;
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
          break;
        }
        if (outside == end) {
          result.warnings.push_back(free_[k].name + ": the data give no " + (side < 0 ? "lower" : "upper") +
                                    " limit within the range searched, which ends at " +
                                    shown(side < 0 ? free_[k].low : free_[k].high));
          break;
        }
        inside = outside;
        value_inside = value;
      }
    }
  }

  const Family& family_;
  std::span<const measurement> data_;
  const std::array<free_parameter, N>& free_;
  const fit_options& options_;
  std::vector<impact> impacts_;
  std::size_t bounced_ = 0;
  bool errors_known_ = false;
  std::size_t collisions_ = 0;
};

} // namespace detail

/// Least squares: the parameters with which the family's models give the measured restitutions best. Sticking is data:
/// a pair that stuck fits where the model's does, and else deviates by the model's restitution.
///
/// From the best of `starts` points that fill the box of parameters, Levenberg-Marquardt with derivatives as
/// sensitivities() has them. The intervals are by profile likelihood: all other parameters are fitted anew for each
/// value of the one; of unknown errors, by Student's t.
/// \param family makes a model from an std::array of N numbers, without a tangential law
/// \throws bad_input naming the measurement or parameter that is out of range, or if a collision cannot be resolved
template <std::size_t N, class Family>
fit_result fit(const Family& family, std::span<const measurement> data, const std::array<free_parameter, N>& free,
               const fit_options& options = {}) {
  return detail::fitting<N, Family>(family, data, free, options).solve();
}

} // namespace ricochet
