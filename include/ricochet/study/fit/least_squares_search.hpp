// The least sum of squares that a curve of restitutions comes to within a box of parameters. For fit_curve() of
// least_squares.hpp.
#pragma once
#include <ricochet/batch/share.hpp>
#include <ricochet/body/validate.hpp>
#include <ricochet/solve/accuracy.hpp>

#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>

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

/// tolerance: of each restitution. starts: points of the box of parameters that are looked at before the best are
/// followed. confidence: of the intervals; 0: none are sought. threads: 0 takes as many as the machine has. progress:
/// is told how many steps are done, of how many; they take unlike times, and there may be more than were foreseen.
struct fit_options {
  double tolerance = 1e-8;
  int starts = 32;
  double confidence = 0.95;
  unsigned threads = 0;
  progress_callback progress = {};
};

/// What is fitted: functions of the parameters, in the units of these, that give for each measurement
struct restitution_curve {
  /// the restitution, zero if the pair sticks, NaN if that cannot be told, to a tolerance,
  std::function<std::vector<double>(const std::vector<double>& parameters, double tolerance)> restitutions;
  /// and its derivatives: a row for each measurement, a column for each parameter. Without this, by differences.
  std::function<Eigen::MatrixXd(const std::vector<double>& parameters)> derivatives = {};
};

namespace detail {

/// Parameters are positions in the box here, each in [0, 1].
class least_squares_search {
public:
  using numbers = std::vector<double>;

  /// A position, and the sum of squares there.
  struct place {
    double square_sum = std::numeric_limits<double>::infinity();
    numbers x;
    bool operator<(const place& other) const { return square_sum < other.square_sum; }
  };

  least_squares_search(const restitution_curve& curve, std::span<const measurement> data,
                       std::span<const free_parameter> free, const fit_options& options)
      : curve_(curve), data_(data), free_(free), options_(options),
        steps_(1 + std::size_t(std::min(options.starts, followed) + std::min(options.starts, to_the_end))) {
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

  place least() {
    std::vector<place> places = looked_at();
    step_done();
    // Most of the best points lie where some parameter is of no account: more than one way down is tried.
    places.resize(std::min<std::size_t>(places.size(), followed));
    for (place& each : places) {
      each = minimised(each.x, nothing_held, roughly);
      step_done();
    }
    std::sort(places.begin(), places.end());
    places.resize(std::min<std::size_t>(places.size(), to_the_end));
    for (place& each : places) {
      each = minimised(each.x, nothing_held, fully);
      step_done();
    }
    return looked_about(*std::min_element(places.begin(), places.end()));
  }

  /// Slopes lead to the nearest minimum only, and there are many: the sum jumps where a pair that stuck begins to
  /// bounce, and is flat where a parameter is of no account. Looks near and far along each parameter for a better place
  /// than the best one, and goes down from there.
  place looked_about(place best) {
    for (int round = 0; round < most_rounds; ++round) {
      place better = best;
      for (std::size_t k = 0; k < free_.size(); ++k) {
        constexpr int looks = 32;
        numbers positions{best.x[k] - 0.01, best.x[k] - 0.003, best.x[k] + 0.003, best.x[k] + 0.01};
        for (int i = 0; i < looks; ++i)
          positions.push_back((i + 0.5) / looks);
        for (const double position : positions)
          if (position > 0 && position < 1) {
            place looked{.x = best.x};
            looked.x[k] = position;
            looked.square_sum = residuals(looked.x, options_.tolerance).squaredNorm();
            better = std::min(better, looked);
          }
      }
      if (!is_better(better, best))
        break;
      best = minimised(better.x, nothing_held, fully);
    }
    return best;
  }

  /// The same with the other parameters following to wherever they then fit best: for a minimum that is in doubt, since
  /// one parameter may stand at the wrong place because the others make up for it.
  place followed_about(place best) {
    if (free_.size() == 1) // nothing follows
      return best;
    for (int round = 0; round < most_rounds; ++round) {
      place better = best;
      for (std::size_t k = 0; k < free_.size(); ++k) {
        constexpr int looks = 8;
        for (int i = 0; i < looks; ++i) {
          numbers x = best.x;
          x[k] = (i + 0.5) / looks;
          x = minimised(x, k, roughly).x;
          better = std::min(better, minimised(x, nothing_held, roughly));
        }
        ++steps_;
        step_done();
      }
      if (!is_better(better, best))
        break;
      best = looked_about(minimised(better.x, nothing_held, fully));
    }
    return best;
  }

  /// How far minimised() goes, and whether by slopes that are as exact as they are had: others take less time, and the
  /// least sum hardly depends on them.
  struct extent {
    double precision;
    int evaluations;
    bool exact_slopes;
  };
  static constexpr extent roughly{1e-3, 5, false}, along_profile{1e-5, 200, false}, fully{1e-9, 200, true};
  static constexpr std::size_t nothing_held = std::size_t(-1);

  /// Least sum of squares next to x, with one of the parameters held or none.
  place minimised(const numbers& x, std::size_t held, const extent& how_far) {
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (k != held)
        moving.push_back(k);
    if (moving.empty())
      return {residuals(x, options_.tolerance).squaredNorm(), x};
    functor problem(*this, x, moving, how_far.exact_slopes);
    Eigen::VectorXd u(moving.size());
    for (std::size_t m = 0; m < moving.size(); ++m)
      u[Eigen::Index(m)] = std::asin(std::clamp(2 * x[moving[m]] - 1, -0.9999, 0.9999));
    Eigen::LevenbergMarquardt<functor> search(problem);
    search.setMaxfev(how_far.evaluations);
    search.setFtol(how_far.precision);
    search.setXtol(how_far.precision);
    search.minimize(u);
    return {square(search.fnorm()), problem.position(u)};
  }

  /// By more than rounding, and the errors that the tolerance allows, account for.
  bool is_better(const place& one, const place& other) const {
    double noise = 1e-6 * other.square_sum;
    for (std::size_t i = 0; i < data_.size(); ++i)
      noise += square(options_.tolerance / error_of(i));
    return one.square_sum < other.square_sum - noise;
  }

  /// Position in the box as parameters.
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

  std::vector<double> restitutions(const numbers& parameters) { return restitutions(parameters, options_.tolerance); }

  /// Of the residuals by the position in the box.
  Eigen::MatrixXd derivatives(const numbers& x) {
    if (!curve_.derivatives)
      return differences(x, 1e-4, 1e-9);
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

  bool errors_known() const { return errors_known_; }
  std::size_t bounced() const { return bounced_; }       ///< measurements that have a restitution
  std::size_t collisions() const { return collisions_; } ///< that were computed
  bool unresolved() const { return unresolved_; }        ///< was a collision, when last looked at?

  void foresee(std::size_t steps) { steps_ += steps; }
  void step_done() {
    ++done_;
    if (options_.progress)
      options_.progress(done_, steps_);
  }

private:
  static constexpr int followed = 6, to_the_end = 2, most_rounds = 5;

  double error_of(std::size_t i) const { return errors_known_ ? data_[i].error : 1; }

  /// (fitted - measured)/error; a pair that stuck, and would, fits. A collision that cannot be resolved deviates by
  /// more than any that can, so that the search turns elsewhere.
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

  /// Central ones over a distance h, of which the tolerance is a part such that errors are as small as the next term of
  /// the series.
  Eigen::MatrixXd differences(const numbers& x, double h, double tolerance) {
    tolerance = std::min(options_.tolerance, tolerance);
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
  std::vector<place> looked_at() {
    boost::random::sobol spread(free_.size());
    boost::random::uniform_01<double> uniform;
    std::vector<place> points(std::size_t(options_.starts));
    for (place& each : points) {
      for (std::size_t k = 0; k < free_.size(); ++k)
        each.x.push_back(0.02 + 0.96 * uniform(spread));
      each.square_sum = residuals(each.x, 1e-4).squaredNorm();
    }
    std::sort(points.begin(), points.end());
    return points;
  }

  /// x = (1 + sin u)/2 keeps the position in the box.
  struct functor : Eigen::DenseFunctor<double> {
    functor(least_squares_search& all, const numbers& x, const std::vector<std::size_t>& moving, bool exact_slopes)
        : Eigen::DenseFunctor<double>(int(moving.size()), int(all.data_.size())), fit(all), from(x), moves(moving),
          exact(exact_slopes) {}

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
      const Eigen::MatrixXd whole = exact ? fit.derivatives(position(u)) : fit.differences(position(u), 1e-4, 1e-8);
      for (std::size_t m = 0; m < moves.size(); ++m)
        jacobian.col(Eigen::Index(m)) = whole.col(Eigen::Index(moves[m])) * (std::cos(u[Eigen::Index(m)]) / 2);
      return 0;
    }

    least_squares_search& fit;
    numbers from;
    std::vector<std::size_t> moves;
    bool exact;
  };

  const restitution_curve& curve_;
  std::span<const measurement> data_;
  std::span<const free_parameter> free_;
  const fit_options& options_;
  std::size_t bounced_ = 0;
  bool errors_known_ = false, unresolved_ = false;
  std::size_t collisions_ = 0, done_ = 0, steps_;
};

} // namespace detail

} // namespace ricochet
