// Parameters from measured restitutions by least squares: of whatever gives restitutions for parameters (fit.hpp makes
// that of a family of models).
#pragma once
#include <ricochet/study/fit/least_squares_search.hpp>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <Eigen/QR>

namespace ricochet {

struct fitted_parameter {
  std::string name;
  double value;
  double standard_error; ///< from the derivatives at the best fit; infinite where the data do not tell
  double low, high;      ///< of the profile-likelihood interval, or of the box where it does not end inside
};

struct fit_result {
  std::vector<fitted_parameter> parameters;
  Eigen::MatrixXd correlation; ///< no numbers of parameters that the data do not tell
  double chi_square; ///< sum of squares of the residuals over their errors, or over `scatter` where none are known
  double scatter;    ///< standard deviation of one restitution, estimated from the residuals; 1 where errors are known
  int degrees_of_freedom; ///< measured restitutions, and pairs that stuck and would not, less parameters, if that
                          ///< is above zero: pairs that stuck, and would, do not scatter
  std::vector<double> residuals;     ///< measured minus fitted restitution; of pairs that stuck and would, zero
  std::vector<std::string> warnings; ///< what the data do not tell
  std::size_t collisions;            ///< that were computed
};

namespace detail {

class least_squares {
  using search = least_squares_search;
  using in_double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

public:
  least_squares(const restitution_curve& curve, std::span<const measurement> data, std::span<const free_parameter> free,
                const fit_options& options)
      : data_(data), free_(free), options_(options), search_(curve, data, free, options) {}

  fit_result solve() {
    search_.foresee(steps_of_intervals());
    best_ = search_.least();
    judge();
    if (in_doubt())
      if (const search::place other = search_.followed_about(best_); search_.is_better(other, best_)) {
        best_ = other;
        judge();
      }
    for (int again = 0; !seek_intervals(); ++again) {
      if (again == 3) {
        result_.warnings.push_back("the search for the intervals keeps finding better fits: narrow the ranges of the "
                                   "free parameters, or let more points be looked at");
        break;
      }
      search_.foresee(steps_of_intervals());
      best_ = search_.looked_about(search_.minimised(better_.x, search::nothing_held, search::fully));
      judge();
    }
    result_.collisions = search_.collisions();
    return result_;
  }

private:
  std::size_t steps_of_intervals() const { return options_.confidence > 0 ? 2 * free_.size() : 0; }

  /// That noise of the errors given makes so large a chi^2.
  double chance() const {
    return boost::math::gamma_q(result_.degrees_of_freedom / 2., result_.chi_square / 2, in_double());
  }
  bool too_far() const { return search_.errors_known() && result_.degrees_of_freedom > 0 && !(chance() > 1e-3); }

  /// At which end of the range searched is the best fit, if it is?
  std::optional<int> end_of(std::size_t k) const {
    const int end = best_.x[k] < 0.5 ? 0 : 1;
    const double distance = std::abs(best_.x[k] - end);
    return distance < 1e-3 && !(distance > 3 * standard_errors_[k]) ? std::optional(end) : std::nullopt;
  }

  /// The search may have ended in the wrong place.
  bool in_doubt() const {
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (end_of(k))
        return true;
    return too_far();
  }

  static std::string rounded(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", x);
    return text;
  }

  /// The result of the best fit, without intervals.
  void judge() {
    result_ = {};
    const std::vector<double> p = search_.at(best_.x);
    int would_bounce = 0;
    const std::vector<double> e = search_.restitutions(p);
    for (std::size_t i = 0; i < data_.size(); ++i) {
      if (std::isnan(e[i]))
        throw bad_input("fit: the search ended where the collision at " + shown(in_si(data_[i].speed)) +
                        " m/s cannot be resolved; narrow the ranges of the free parameters");
      result_.residuals.push_back(data_[i].restitution.value_or(0) - e[i]);
      would_bounce += !data_[i].restitution && e[i] > 0;
    }
    result_.degrees_of_freedom = std::max(0, int(search_.bounced()) + would_bounce - int(p.size()));
    result_.scatter = search_.errors_known() ? 1 : std::sqrt(best_.square_sum / result_.degrees_of_freedom);
    result_.chi_square = search_.errors_known() ? best_.square_sum : result_.degrees_of_freedom;
    judge_distance();
    if (!search_.errors_known() && would_bounce > 0)
      result_.warnings.push_back(std::to_string(would_bounce) + " of the pairs that stuck bounce in the fit");
    const auto zeros =
        std::count_if(data_.begin(), data_.end(), [](const auto& each) { return each.restitution == 0.; });
    if (zeros > 0)
      result_.warnings.push_back(std::to_string(zeros) +
                                 " restitutions are given as the number zero: a pair that stuck "
                                 "is to be given as captured, or it passes for a precise one");
    judge_parameters(p);
  }

  void judge_distance() {
    const std::string chi_square = "chi^2 = " + rounded(result_.chi_square) + " of " +
                                   std::to_string(result_.degrees_of_freedom) + " degrees of freedom: ";
    if (too_far())
      result_.warnings.push_back(chi_square + "the model does not describe the data, or their errors are larger");
    if (search_.errors_known() && result_.degrees_of_freedom > 0 && chance() > 1 - 1e-6)
      result_.warnings.push_back(chi_square + "the errors are smaller than those given");
    if (result_.scatter == 0)
      result_.warnings.push_back(
          "the fit is exact, so that the scatter of the data is not known: intervals have no width");
  }

  /// By the derivatives at the best fit.
  void judge_parameters(const std::vector<double>& p) {
    const auto n = Eigen::Index(p.size());
    const Eigen::MatrixXd jacobian = search_.derivatives(best_.x);
    std::vector<Eigen::Index> telling; // parameters that change a restitution
    for (Eigen::Index k = 0; k < n; ++k)
      if (jacobian.col(k).norm() > 0)
        telling.push_back(k);
    Eigen::MatrixXd covariance = // of restitutions that scatter by one
        Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
    result_.correlation = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed;
    decomposed.setThreshold(1e-7);
    if (!telling.empty())
      decomposed.compute(jacobian(Eigen::all, telling));
    if (const auto rank = telling.empty() ? 0 : decomposed.rank(); rank < Eigen::Index(telling.size())) {
      result_.warnings.push_back("the data do not tell all parameters: of " + std::to_string(n) + " only " +
                                 std::to_string(rank) + " can be known, or so many combinations of them");
    } else if (rank > 0) {
      const Eigen::MatrixXd inverse = decomposed.solve(Eigen::MatrixXd::Identity(jacobian.rows(), jacobian.rows()));
      covariance(telling, telling) = inverse * inverse.transpose();
      for (const Eigen::Index k : telling)
        for (const Eigen::Index l : telling) {
          const double c = k == l ? 1 : covariance(k, l) / std::sqrt(covariance(k, k) * covariance(l, l));
          result_.correlation(k, l) = c;
          if (l < k && std::abs(c) > 0.99)
            result_.warnings.push_back(free_[std::size_t(l)].name + " and " + free_[std::size_t(k)].name +
                                       " can hardly be told apart: their correlation is " + rounded(c));
        }
    }
    for (std::size_t k = 0; k < p.size(); ++k) {
      const auto& [name, low, high] = free_[k];
      standard_errors_.resize(p.size()); // of positions
      standard_errors_[k] = result_.scatter * std::sqrt(covariance(Eigen::Index(k), Eigen::Index(k)));
      result_.parameters.push_back({name, p[k], standard_errors_[k] * search_.slope_of_position(k, p), low, high});
      const auto end = end_of(k);
      if (jacobian.col(Eigen::Index(k)).norm() == 0)
        result_.warnings.push_back(name + " changes none of these restitutions next to the best fit");
      else if (end)
        result_.warnings.push_back(name + ": the best fit is at the " + (*end == 0 ? "lower" : "upper") +
                                   " end of the range searched, " + shown(*end == 0 ? low : high));
    }
  }

  /// False if a better fit than the best came to light, which is then `better_`.
  bool seek_intervals() {
    if (options_.confidence > 0)
      for (std::size_t k = 0; k < free_.size(); ++k)
        for (const double side : {-1., 1.}) {
          better_ = best_;
          seek_end_of_interval(k, side);
          search_.step_done();
          if (search_.is_better(better_, best_) && better_.square_sum < best_.square_sum - 1e-3 * allowed())
            return false;
        }
    return true;
  }

  /// Excess of the sum of squares within the intervals.
  double allowed() const {
    using namespace boost::math;
    const double upper_tail = (1 + options_.confidence) / 2;
    if (search_.errors_known())
      return square(quantile(normal_distribution<double, in_double>(), upper_tail));
    const students_t_distribution<double, in_double> student(result_.degrees_of_freedom);
    return square(result_.scatter * quantile(student, upper_tail));
  }

  /// Where the others go with a parameter, as long as restitutions are linear in all.
  search::numbers valley_at(double position, std::size_t k) const {
    search::numbers x = best_.x;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double slope =
          result_.correlation(Eigen::Index(j), Eigen::Index(k)) * standard_errors_[j] / standard_errors_[k];
      if (std::isfinite(slope))
        x[j] = std::clamp(x[j] + slope * (position - best_.x[k]), 0., 1.);
    }
    return x;
  }

  /// Where the least sum of squares with this parameter held exceeds the least of all by what is allowed.
  void seek_end_of_interval(std::size_t k, double side) {
    using boost::math::tools::toms748_solve;
    const double allowed_excess = allowed();
    search::place within = best_; // the last in the interval: far outside the others may be lost
    const auto excess = [&](double position) {
      const auto beyond = [&](const search::place& found) {
        return found.square_sum - best_.square_sum - allowed_excess;
      };
      const auto from = [&](search::numbers x) {
        x[k] = position;
        return search_.minimised(x, k, search::along_profile);
      };
      search::place found = from(within.x);
      if (beyond(found) > 0) // from there the way may be cut off by a measurement that comes to stick on it
        found = std::min(found, from(valley_at(position, k)));
      better_ = std::min(better_, found);
      if (!(beyond(found) > 0))
        within = found;
      return beyond(found);
    };
    auto& [name, value, standard_error, low, high] = result_.parameters[k];
    const double end = side < 0 ? 0 : 1;
    double inside = best_.x[k], value_inside = -allowed_excess;
    double step = side * (std::isfinite(standard_errors_[k]) ? std::clamp(2 * standard_errors_[k], 1e-9, 0.25) : 0.02);
    for (;; step *= 2) {
      const double outside = side * (inside + step - end) < 0 ? inside + step : end;
      const double value_outside = excess(outside);
      if (value_outside > 0) {
        const auto close = [&](double a, double b) { return std::abs(b - a) < 1e-3 * std::abs(b - best_.x[k]); };
        std::uintmax_t most = 30;
        const bool up = outside > inside;
        const auto bracket =
            toms748_solve(excess, up ? inside : outside, up ? outside : inside, up ? value_inside : value_outside,
                          up ? value_outside : value_inside, close, most);
        search::numbers found = best_.x;
        found[k] = (bracket.first + bracket.second) / 2;
        (side < 0 ? low : high) = search_.at(found)[k];
        (void)excess(outside);
        if (search_.unresolved())
          result_.warnings.push_back(name + ": the interval ends at " + shown(search_.at(found)[k]) +
                                     ", where collisions cannot be resolved any more");
        return;
      }
      if (outside == end) {
        if (end_of(k) != int(end)) // which has been said
          result_.warnings.push_back(name + ": the data give no " + (side < 0 ? "lower" : "upper") +
                                     " limit within the range searched, which ends at " +
                                     shown(side < 0 ? free_[k].low : free_[k].high));
        return;
      }
      inside = outside;
      value_inside = value_outside;
    }
  }

  std::span<const measurement> data_;
  std::span<const free_parameter> free_;
  const fit_options& options_;
  least_squares_search search_;
  search::place best_, better_;
  std::vector<double> standard_errors_;
  fit_result result_{};
};

} // namespace detail

/// Least squares: the parameters with which the curve comes closest to the measurements. Sticking is data: a pair that
/// stuck fits where the curve is zero, and else deviates by the curve's restitution.
///
/// From the best six of `starts` points that fill the box of parameters some steps down each, and from the best two of
/// these all the way, by Levenberg-Marquardt; from the better of both it looks about, near and far. A fit that the data
/// reject, or at an end of a range, is doubted: each parameter is then put elsewhere, with the others following. The
/// intervals are by profile likelihood: all other parameters are fitted anew for each value of the one; of unknown
/// errors, by Student's t. A better fit that comes to light there takes the place of the best.
/// \throws bad_input naming the measurement or parameter that is out of range, or if a collision cannot be resolved at
/// the best fit; and what the curve throws
inline fit_result fit_curve(const restitution_curve& curve, std::span<const measurement> data,
                            std::span<const free_parameter> free, const fit_options& options = {}) {
  return detail::least_squares(curve, data, free, options).solve();
}

} // namespace ricochet
