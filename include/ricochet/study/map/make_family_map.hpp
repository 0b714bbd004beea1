// Maps of e over the speed and one parameter, made from collisions.
#pragma once
#include <ricochet/study/map/family_map.hpp>
#include <ricochet/study/map/map_collisions.hpp>

#include <random>
#include <type_traits>

namespace ricochet {

/// max_error: of the restitution, 1e-9 to 1e-2. most_patches: more are no map, but a sign of a kink in e.
struct family_map_options {
  double max_error = 1e-6;
  std::size_t most_patches = 4000;
  unsigned threads = 0;
  progress_callback progress = {}; ///< told the number of patches that are good, and of all at that time
  std::string about = "";          ///< description that is saved with the map: what p is; one line
};

namespace detail {

template <class Family>
class family_map_maker {
  using Model = std::invoke_result_t<const Family&, double>;
  using interval = family_map::interval;
  using threshold_piece = family_map::threshold_piece;
  using node = family_map::node;
  static constexpr std::size_t terms = family_map::terms;
  using table = Eigen::Matrix<double, terms, terms>;

public:
  family_map_maker(const Family& family, const family_map_options& options) : family_(family), options_(options) {
    require("max_error", options.max_error, range{.low = 1e-9, .high = 1e-2, .high_included = true});
    for (std::size_t k = 0; k < terms; ++k)
      for (std::size_t i = 0; i < terms; ++i)
        to_chebyshev_(Eigen::Index(k), Eigen::Index(i)) =
            (k == 0 ? 1. : 2.) / terms * std::cos(double(k) * std::acos(of_.node[i]));
  }

  family_map make(double low_parameter, double high_parameter, speed low, speed high) {
    require("low parameter", low_parameter, positive);
    require("high parameter", high_parameter, range{.low = low_parameter, .low_included = false});
    require("low speed", low, positive);
    require("high speed", high, range{.low = in_si(low), .low_included = false});
    one_line(options_.about);
    low_ = std::log(in_si(low));
    high_ = std::log(in_si(high));
    y_ = {std::log(low_parameter), std::log(high_parameter)};
    const interval speeds{in_si(low), in_si(high)}, parameters{low_parameter, high_parameter};
    interval separating = parameters;
    const std::vector<double> sampled = even(y_, 32);
    if (const auto at_low = stick(sampled, low); std::find(at_low.begin(), at_low.end(), true) != at_low.end()) {
      separating = find_separating(sampled, beyond * high, parameters);
      if (separating.low == separating.high)
        return {speeds, parameters, separating, {0, 1}, 0, {}, {}, options_.about};
      y_ = {std::log(separating.low), std::log(separating.high)};
      find_threshold();
    }
    set_variable();
    grow();
    std::vector<node> tree;
    flatten(0, tree);
    return {speeds, parameters, separating, x_, largest_error_, std::move(threshold_), std::move(tree), options_.about};
  }

private:
  struct part { ///< a node of the tree while it grows
    interval x, y;
    node made{node::patch};
    std::size_t lower = 0;
    double error = 0;
  };

  Model model(double y) const { return family_(std::exp(y)); }
  static double place(const interval& i, double t) { return ((1 - t) * i.low + (1 + t) * i.high) / 2; }
  speed speed_at(double x, double y) const {
    return std::exp(threshold_.empty() ? x : log_threshold(y) + x * x) * units::metres_per_second;
  }

  static std::vector<double> even(const interval& y, int intervals) {
    std::vector<double> places;
    for (int i = 0; i <= intervals; ++i)
      places.push_back(place(y, 2. * i / intervals - 1));
    return places;
  }

  /// Which of these pairs do, at this speed?
  std::vector<bool> stick(const std::vector<double>& ys, speed v) const {
    std::vector<scene<Model>> scenes;
    for (const double y : ys)
      scenes.push_back({model(y), {v}});
    std::vector<bool> found;
    for (const auto& out : resolved(scenes, 1e-6, options_.threads))
      found.push_back(!out.restitution);
    return found;
  }

  /// The parameters of which pairs separate at a speed that is a little beyond the map's: a single interval, or no map.
  interval find_separating(const std::vector<double>& ys, speed fast, const interval& all) const {
    const std::vector<bool> sticks = stick(ys, fast);
    const auto first = std::find(sticks.begin(), sticks.end(), false), end = std::find(first, sticks.end(), true);
    if (std::find(end, sticks.end(), false) != sticks.end())
      throw bad_input("family map: at " + shown(in_si(fast)) + " m/s pairs of parameters around " +
                      shown(std::exp(ys[std::size_t(end - sticks.begin())])) +
                      " stick, and those of smaller and of larger ones separate: make a map of each side");
    if (first == sticks.end())
      return {all.low, all.low};
    const auto edge = [&](double separates, double sticks_there) {
      while (std::abs(sticks_there - separates) > 1e-4) {
        const double middle = (separates + sticks_there) / 2;
        (stick({middle}, fast)[0] ? sticks_there : separates) = middle;
      }
      return std::exp(separates);
    };
    const std::size_t from = std::size_t(first - sticks.begin()), to = std::size_t(end - sticks.begin());
    return {from == 0 ? all.low : edge(ys[from], ys[from - 1]), to == ys.size() ? all.high : edge(ys[to - 1], ys[to])};
  }

  struct located {
    double log_speed, error;
  };

  /// ln v_s of the pair of one parameter, from a bracket that grows from the middle of the range of speeds. e goes as
  /// slope sqrt(ln v/v_s), and an error of ln v_s must not show in it a millionth beyond: less than `near`
  /// max_error/slope.
  located log_sticking_speed(double y) const {
    const Model pair = model(y);
    const auto restitution = [&](double log_v) {
      return collide(pair, impact{std::exp(log_v) * units::metres_per_second}, {.tolerance = 1e-6})
          .restitution.value_or(0);
    };
    double a = (low_ + high_) / 2, b = a;
    const double step = std::log(2.), farthest = std::log(1e6);
    const bool up = restitution(a) == 0;
    while (up ? restitution(b += step) == 0 : restitution(a -= step) > 0) {
      (up ? a : b) = up ? b : a;
      if (a < low_ - farthest || b > high_ + farthest)
        throw bad_input("family map: the pair of parameter " + shown(std::exp(y)) + (up ? " sticks" : " separates") +
                        " at " + shown(std::exp(up ? b : a)) + " m/s, a million times beyond the range of speeds: " +
                        "the family has to have a sticking speed everywhere, or nowhere");
    }
    const auto search = [&](double width) {
      const auto found = sticking_speed_up_to(pair, std::exp(a) * units::metres_per_second,
                                              std::exp(b) * units::metres_per_second, width);
      a = std::log(in_si(found.largest_captured));
      b = std::log(in_si(found.smallest_separated));
    };
    search(1e-4);
    const double slope = std::clamp(restitution(b + 1e-3) / std::sqrt(1e-3), 1e-3, 3.);
    search(std::max(1e-12, near / 4 * options_.max_error / slope / 4));
    return {(a + b) / 2, std::max(near / 4 * options_.max_error / slope, b - a)};
  }

  void find_threshold() {
    const std::array looks{-0.99, -0.7, -0.3, 0.1, 0.5, 0.85, 0.99};
    std::vector<interval> open{y_};
    while (!open.empty()) {
      constexpr std::size_t all = terms + looks.size();
      std::vector<located> values(open.size() * all);
      std::vector<double> ts(of_.node.begin(), of_.node.end());
      ts.insert(ts.end(), looks.begin(), looks.end());
      share(values.size(), 1, options_.threads, {}, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          values[i] = log_sticking_speed(place(open[i / all], ts[i % all]));
      });
      std::vector<interval> next;
      for (std::size_t i = 0; i < open.size(); ++i) {
        threshold_piece made{open[i].low, open[i].high, {}};
        Eigen::Matrix<double, terms, 1> at_nodes;
        for (std::size_t j = 0; j < terms; ++j)
          at_nodes[Eigen::Index(j)] = values[i * all + j].log_speed;
        Eigen::Map<Eigen::Matrix<double, terms, 1>>(made.c.data()) = of_.to_powers * at_nodes;
        bool good = true;
        for (std::size_t j = terms; j < all; ++j)
          good &=
              std::abs(family_map::value(made.c, ts[j]) - values[i * all + j].log_speed) <= values[i * all + j].error;
        if (good) {
          threshold_.push_back(made);
        } else {
          const double middle = place(open[i], 0);
          next.push_back({open[i].low, middle});
          next.push_back({middle, open[i].high});
        }
      }
      if (threshold_.size() + next.size() > options_.most_patches)
        throw bad_input("family map: the sticking speed takes more than " + std::to_string(options_.most_patches) +
                        " pieces: it is no smooth function of the parameter");
      open = std::move(next);
    }
    std::sort(threshold_.begin(), threshold_.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  }

  double log_threshold(double y) const {
    const auto at = std::lower_bound(threshold_.begin(), threshold_.end() - 1, y,
                                     [](const threshold_piece& piece, double to) { return piece.end < to; });
    return family_map::value(at->c, (2 * y - (at->begin + at->end)) / (at->end - at->begin));
  }

  /// ln v_s lies between, by many looks, each good for its neighbourhood.
  interval threshold_within(const interval& y) const {
    constexpr int looks = 32;
    interval all{log_threshold(y.low), log_threshold(y.low)};
    double before = all.low, farthest = 0;
    for (int i = 1; i <= looks; ++i) {
      const double here = log_threshold(place(y, 2. * i / looks - 1));
      all = {std::min(all.low, here), std::max(all.high, here)};
      farthest = std::max(farthest, std::abs(here - before));
      before = here;
    }
    return {all.low - farthest, all.high + farthest};
  }

  void set_variable() {
    if (threshold_.empty()) {
      x_ = {low_, high_};
      return;
    }
    const interval thresholds = threshold_within(y_);
    x_ = {std::sqrt(std::max(0., low_ - thresholds.high)), std::sqrt(std::max(near, high_ - thresholds.low))};
  }

  bool is_outside(const part& p) const {
    if (threshold_.empty())
      return false;
    const interval thresholds = threshold_within(p.y);
    return thresholds.low + square(p.x.low) > high_ || thresholds.high + square(p.x.high) < low_;
  }
  bool is_at_threshold(const part& p) const { return !threshold_.empty() && p.x.high <= near; }

  void grow() {
    parts_ = {{x_, y_}};
    std::vector<std::size_t> open{0};
    std::size_t good = 0;
    while (!open.empty()) {
      std::erase_if(open, [&](std::size_t i) {
        if (is_outside(parts_[i]))
          parts_[i].made.is = node::outside;
        return parts_[i].made.is == node::outside;
      });
      const std::vector<bool> by_speed = attempt(open);
      std::vector<std::size_t> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        part& p = parts_[open[k]];
        if (p.error <= options_.max_error / 2 || is_at_threshold(p)) {
          ++good;
          largest_error_ = is_at_threshold(p) ? largest_error_ : std::max(largest_error_, p.error);
          continue;
        }
        p.made = {by_speed[k] ? node::halves_speed : node::halves_parameter};
        p.lower = parts_.size();
        part lower{p.x, p.y}, upper{p.x, p.y};
        (by_speed[k] ? lower.x : lower.y).high = (by_speed[k] ? upper.x : upper.y).low =
            place(by_speed[k] ? p.x : p.y, 0);
        next.insert(next.end(), {p.lower, p.lower + 1});
        parts_.insert(parts_.end(), {lower, upper}); // p is no more
      }
      if (good + next.size() > options_.most_patches)
        throw bad_input("family map: a max_error of " + shown(options_.max_error) + " takes more than " +
                        std::to_string(options_.most_patches) +
                        " patches: allow more, or a larger error; e must have " +
                        "no kink, as it has at a yield speed");
      if (options_.progress)
        options_.progress(good, good + next.size());
      open = std::move(next);
    }
  }

  /// Polynomials through collisions at the nodes of these parts, with their largest errors: on the rims, in between,
  /// and at random. True for each that is less smooth along the speed than along the parameter.
  std::vector<bool> attempt(const std::vector<std::size_t>& open) {
    constexpr std::size_t nodes = terms * terms, looks = 26, all = nodes + looks;
    const std::array steady{-0.99, -0.4, 0.45, 0.98};
    std::vector<scene<Model>> scenes;
    std::vector<std::array<double, 2>> at;
    std::uniform_real_distribution<double> anywhere(-1, 1);
    scenes.reserve(open.size() * all);
    for (const std::size_t i : open) {
      const part& p = parts_[i];
      const auto column = [&](double s, const auto& ts) {
        const double y = place(p.y, s);
        const Model of = model(y);
        for (const double t : ts) {
          const double x = place(p.x, t);
          at.push_back({t, s});
          scenes.push_back({of, {speed_at(x, y)}});
        }
      };
      for (const double s : of_.node)
        column(s, of_.node);
      for (const double s : steady)
        column(s, steady);
      for (int k = 0; k < 8; ++k) {
        const double s = anywhere(random_);
        column(s, std::array{anywhere(random_)});
      }
      // As near the sticking speed as the promise goes, on both rims.
      const bool touches = !threshold_.empty() && p.x.low == 0 && !is_at_threshold(p);
      for (const double s : {-0.9, 0.9})
        column(s, std::array{touches ? 2.01 * near / p.x.high - 1 : 0.});
    }
    const auto outcomes = resolved(scenes, options_.max_error / 16, options_.threads);
    const auto e = [&](std::size_t i) {
      if (threshold_.empty() && !outcomes[i].restitution)
        throw bad_input("family map: a pair of the family sticks at " + shown(in_si(scenes[i].impact.speed)) +
                        " m/s, though none does at the low speed");
      return outcomes[i].restitution.value_or(0);
    };
    std::vector<bool> by_speed;
    for (std::size_t k = 0; k < open.size(); ++k) {
      part& p = parts_[open[k]];
      table values; // of t, s
      for (std::size_t i = 0; i < nodes; ++i)
        values(Eigen::Index(i % terms), Eigen::Index(i / terms)) = e(k * all + i);
      const table c = of_.to_powers * values * of_.to_powers.transpose();
      const table smooth = (to_chebyshev_ * values * to_chebyshev_.transpose()).cwiseAbs();
      by_speed.push_back(smooth.bottomRows(2).sum() > smooth.rightCols(2).sum());
      for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t j = 0; j < terms; ++j)
          p.made.c[i][j] = c(Eigen::Index(i), Eigen::Index(j));
      for (std::size_t i = k * all + nodes; i < (k + 1) * all; ++i) {
        const double is = e(i), mapped = family_map::value(p.made.c, at[i][0], at[i][1]);
        const bool is_near = !threshold_.empty() && place(p.x, at[i][0]) < near;
        p.error = std::max(p.error, is_near ? std::abs(mapped * mapped - is * is) : std::abs(mapped - is));
      }
    }
    return by_speed;
  }

  void flatten(std::size_t i, std::vector<node>& tree) const {
    tree.push_back(parts_[i].made);
    if (parts_[i].lower != 0) {
      flatten(parts_[i].lower, tree);
      flatten(parts_[i].lower + 1, tree);
    }
  }

  static constexpr double beyond = 1.2; ///< the high speed, up to where sticking speeds are looked for
  static constexpr double near = 1e-3;  ///< root of a millionth of the sticking speed

  const Family& family_;
  const family_map_options& options_;
  const interpolation<terms> of_;
  table to_chebyshev_;
  std::mt19937_64 random_{1};
  double low_ = 0, high_ = 0; ///< logarithms of the speeds
  interval x_{}, y_{};        ///< ranges of the variables
  std::vector<threshold_piece> threshold_;
  std::vector<part> parts_;
  double largest_error_ = 0;
};

} // namespace detail

/// e(v; p) of the models that `family(p)` gives, between two values of p > 0 and two speeds, to a largest error that is
/// checked at 26 places in each patch, eight of them at random; within a millionth of the sticking speed it is that of
/// e^2. The family must have a sticking speed at every p, wherever it lies, or at none, and no kink. It is called by
/// several threads at once.
/// \throws bad_input if a range is empty, if max_error is outside [1e-9, 1e-2] or takes too many patches, if only some
/// of the family stick, or if a collision cannot be resolved.
template <class Family>
family_map make_family_map(const Family& family, double low_parameter, double high_parameter, speed low, speed high,
                           const family_map_options& options = {}) {
  return detail::family_map_maker<Family>(family, options).make(low_parameter, high_parameter, low, high);
}

} // namespace ricochet
