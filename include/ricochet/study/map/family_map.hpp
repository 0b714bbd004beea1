// The restitution of a whole family of pairs at once: a function of the speed and of one parameter more.
#pragma once
#include <ricochet/study/map/map_file.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ricochet {

/// e(v; p) between two speeds and two values of a parameter p > 0, by polynomials of degree seven in both variables on
/// patches halved now in one, now in the other: ln p, and sqrt(ln(v/v_s)), or ln v where no pair of the family sticks.
/// The sticking speed v_s(p) is a polynomial of ln p in pieces. Up to it e is zero, and where it is beyond the range of
/// speeds, or infinite, as strong damping makes it; outside the ranges e is no number.
class family_map {
public:
  static constexpr std::size_t terms = 8;

  /// c0 + c1 t + ... for ln v_s, with t from -1 at `begin` to 1 at `end`, which are values of ln p.
  struct threshold_piece {
    double begin, end;
    std::array<double, terms> c;
  };
  /// The tree of patches, each branch followed by all of its lower half and all of its upper one. A leaf holds
  /// c[i][j] t^i s^j, t and s from -1 to 1 over its part of the speed's variable and of ln p; or nothing if it is
  /// nowhere within the range of speeds.
  struct node {
    enum kind { halves_speed, halves_parameter, patch, outside } is;
    std::array<std::array<double, terms>, terms> c{};
  };
  struct interval {
    double low, high;
  };

  /// speeds in m/s; separating: parameters beyond which all pairs stick up to the high speed, where that is so for all,
  /// an interval of no width; variable: range of the speed's variable; threshold: empty if no pair sticks; tree: halves
  /// variable and ln p of the separating parameters.
  /// largest_error: found by comparison with collisions. description: one line. \throws bad_input if these do not
  /// make a map
  family_map(interval speeds, interval parameters, interval separating, interval variable, double largest_error,
             std::vector<threshold_piece> threshold, std::vector<node> tree, std::string description = "")
      : speeds_(speeds), parameters_(parameters), separating_(separating), variable_(variable),
        largest_error_(largest_error), threshold_(std::move(threshold)), tree_(std::move(tree)),
        description_(detail::one_line(description)), log_parameter_{std::log(separating.low),
                                                                    std::log(separating.high)} {
    require("low speed of the map", speeds.low, positive);
    require("high speed of the map", speeds.high, range{.low = speeds.low, .low_included = false});
    require("low parameter of the map", parameters.low, positive);
    require("high parameter of the map", parameters.high, range{.low = parameters.low, .low_included = false});
    const range of_parameters{.low = parameters.low, .high = parameters.high, .high_included = true};
    require("low separating parameter of the map", separating.low, of_parameters);
    require("high separating parameter of the map", separating.high, of_parameters);
    require("low end of the map's variable", variable.low, any_finite);
    require("high end of the map's variable", variable.high, range{.low = variable.low, .low_included = false});
    require("largest error of the map", largest_error, non_negative);
    if (all_stick())
      return;
    double at = log_parameter_.low;
    for (const threshold_piece& each : threshold_) {
      if (each.begin != at || !(each.end > at))
        throw bad_input("family map: no piece of the sticking speed goes on at ln p = " + shown(at));
      at = each.end;
    }
    if (!threshold_.empty() && at != log_parameter_.high)
      throw bad_input("family map: the sticking speed ends at ln p = " + shown(at));
    branches_.resize(tree_.size());
    const std::size_t read = plant(0, variable_, log_parameter_, 0);
    if (read != tree_.size())
      throw bad_input("family map: its tree ends after " + std::to_string(read) + " of " +
                      std::to_string(tree_.size()) + " nodes");
    for (std::size_t i = 0; i < grid * grid; ++i)
      start_.push_back(
          deepest(along(variable_, i / grid, i / grid + 1), along(log_parameter_, i % grid, i % grid + 1)));
  }

  /// At a speed in m/s and a parameter; NaN outside their ranges.
  double operator()(double v, double p) const {
    if (!(v >= speeds_.low && v <= speeds_.high && p >= parameters_.low && p <= parameters_.high))
      return std::numeric_limits<double>::quiet_NaN();
    if (all_stick() || p < separating_.low || p > separating_.high)
      return 0;
    const double y = std::clamp(std::log(p), log_parameter_.low, log_parameter_.high);
    double x = std::log(v);
    if (!threshold_.empty()) {
      x -= log_sticking_speed(y);
      if (x <= 0)
        return 0;
      x = std::sqrt(x);
    }
    x = std::clamp(x, variable_.low, variable_.high);
    const branch* at = &branches_[start_[cell(variable_, x) * grid + cell(log_parameter_, y)]];
    while (at->upper != 0)
      at = &branches_[(at->by_speed ? x : y) > at->middle ? at->upper : at->lower];
    return std::clamp(value(tree_[at->of].c, at->speed.place(x), at->parameter.place(y)), 0., 1.);
  }

  /// In m/s; 0 where no pair of the family sticks, infinite where it is beyond the range of speeds, NaN outside that of
  /// parameters.
  double sticking_speed(double p) const {
    if (!(p >= parameters_.low && p <= parameters_.high))
      return std::numeric_limits<double>::quiet_NaN();
    if (all_stick() || p < separating_.low || p > separating_.high)
      return std::numeric_limits<double>::infinity();
    return threshold_.empty() ? 0 : std::exp(log_sticking_speed(std::log(p)));
  }

  /// The same as a plain function of C: `map` is the address of a family_map, `speed` in m/s.
  static double restitution(const void* map, double speed, double parameter) {
    return (*static_cast<const family_map*>(map))(speed, parameter);
  }

  interval speeds() const { return speeds_; }
  interval parameters() const { return parameters_; }
  interval separating_parameters() const { return separating_; }
  double largest_error() const { return largest_error_; }
  const std::vector<threshold_piece>& threshold() const { return threshold_; }
  std::size_t patches() const {
    return std::size_t(std::count_if(tree_.begin(), tree_.end(), [](const node& n) { return n.is == node::patch; }));
  }
  const std::string& description() const { return description_; }

  /// As speed_map::save(), with what the file says of its numbers.
  void save(const std::filesystem::path& file) const {
    detail::map_writer out(kind, description_);
    out.comment("largest error found: " + detail::exact(largest_error_) + ", absolute");
    out.comment(
        "low and high speed [m/s], parameter, parameter beyond which all stick, and variable x; largest error;");
    out.comment(
        "number of pieces of ln v_s, and of nodes of the tree, which halves x and y of what does not all stick.");
    out.comment("x is sqrt(ln(v/v_s)), or ln v if there are no pieces; y = ln p. For each piece: begin and end of y,");
    out.comment("c0 ... c7 of t from -1 to 1 between. For each node, lower half before upper: 0 halves x, 1 halves y,");
    out.comment("3 is outside the range of speeds, 2 is followed by c00 c01 ... c77 of t^i s^j, t from -1 to 1 over "
                "its x, s over its y.");
    out.line(speeds_.low, speeds_.high, parameters_.low, parameters_.high, separating_.low, separating_.high,
             variable_.low, variable_.high, largest_error_, double(threshold_.size()), double(tree_.size()));
    for (const threshold_piece& each : threshold_)
      out.line(each.begin, each.end, each.c);
    for (const node& each : tree_)
      if (each.is == node::patch)
        std::apply([&](const auto&... row) { out.line(double(each.is), row...); }, each.c);
      else
        out.line(double(each.is));
    out.finish(file);
  }

  /// \throws std::runtime_error as speed_map::load().
  static family_map load(const std::filesystem::path& file) {
    detail::map_reader in(file, kind);
    const auto between = [&] {
      const double low = in.number();
      return interval{low, in.number()};
    };
    const interval speeds = between(), parameters = between(), separating = between(), variable = between();
    const double largest_error = in.number();
    std::vector<threshold_piece> threshold(in.count());
    std::vector<node> tree(in.count());
    for (threshold_piece& each : threshold) {
      each.begin = in.number();
      each.end = in.number();
      for (double& c : each.c)
        c = in.number();
    }
    for (node& each : tree) {
      const std::size_t is = in.count();
      if (is > node::outside)
        in.refuse("has a node of kind " + std::to_string(is));
      each.is = static_cast<decltype(each.is)>(is);
      if (each.is == node::patch)
        for (auto& row : each.c)
          for (double& c : row)
            c = in.number();
    }
    return in.finish([&] {
      return family_map(speeds, parameters, separating, variable, largest_error, std::move(threshold), std::move(tree),
                        in.description());
    });
  }

  /// c[i][j] t^i s^j.
  static double value(const std::array<std::array<double, terms>, terms>& c, double t, double s) {
    std::array<double, terms> of_s = c[terms - 1];
    for (std::size_t i = terms - 1; i-- > 0;)
      for (std::size_t j = 0; j < terms; ++j)
        of_s[j] = of_s[j] * t + c[i][j];
    return value(of_s, s);
  }
  static double value(const std::array<double, terms>& c, double t) {
    const double square = t * t, even = ((c[6] * square + c[4]) * square + c[2]) * square + c[0];
    return even + t * (((c[7] * square + c[5]) * square + c[3]) * square + c[1]);
  }

private:
  static constexpr const char* kind = "family map";
  static constexpr int most_halvings = 100;
  static constexpr std::size_t grid = 64; ///< of cells, each of which knows where in the tree to begin

  struct stretch { ///< of a variable, as -1 to 1
    double middle = 0, per_half = 1;
    stretch() = default;
    explicit stretch(const interval& i) : middle((i.low + i.high) / 2), per_half(2 / (i.high - i.low)) {}
    double place(double x) const { return (x - middle) * per_half; }
  };
  struct branch {
    std::size_t of = 0, lower = 0, upper = 0; ///< nodes; 0: none
    bool by_speed = false;
    double middle = 0;
    stretch speed, parameter;
  };

  /// The branches from this node on; the node behind them.
  std::size_t plant(std::size_t i, const interval& x, const interval& y, int depth) {
    if (i >= tree_.size())
      throw bad_input("family map: its tree of " + std::to_string(tree_.size()) + " nodes lacks some");
    if (depth > most_halvings)
      throw bad_input("family map: its tree halves more than " + std::to_string(most_halvings) + " times");
    branch& b = branches_[i];
    b.of = i;
    b.speed = stretch(x);
    b.parameter = stretch(y);
    b.by_speed = tree_[i].is == node::halves_speed;
    if (tree_[i].is == node::patch || tree_[i].is == node::outside)
      return i + 1;
    const interval& halved = b.by_speed ? x : y;
    const interval lower{halved.low, b.middle = (halved.low + halved.high) / 2}, upper{lower.high, halved.high};
    b.lower = i + 1;
    const auto half = [&](std::size_t at, const interval& part) {
      return b.by_speed ? plant(at, part, y, depth + 1) : plant(at, x, part, depth + 1);
    };
    b.upper = half(b.lower, lower);
    return half(b.upper, upper);
  }

  /// The last node that has all of a rectangle.
  std::size_t deepest(const interval& x, const interval& y) const {
    std::size_t i = 0;
    while (branches_[i].upper != 0) {
      const interval& of = branches_[i].by_speed ? x : y;
      if (of.low < branches_[i].middle && of.high > branches_[i].middle)
        break;
      i = of.high <= branches_[i].middle ? branches_[i].lower : branches_[i].upper;
    }
    return i;
  }
  /// Between two lines of the grid, a little less on either side, for round-off.
  static interval along(const interval& i, std::size_t from, std::size_t to) {
    const double step = (i.high - i.low) / double(grid);
    return {i.low + (double(from) + 1e-9) * step, i.low + (double(to) - 1e-9) * step};
  }
  static std::size_t cell(const interval& i, double x) {
    return std::min(std::size_t((x - i.low) * (double(grid) / (i.high - i.low))), grid - 1);
  }

  double log_sticking_speed(double y) const {
    const auto at = std::lower_bound(threshold_.begin(), threshold_.end() - 1, y,
                                     [](const threshold_piece& piece, double to) { return piece.end < to; });
    return value(at->c, (2 * y - (at->begin + at->end)) / (at->end - at->begin));
  }

  bool all_stick() const { return !(separating_.high > separating_.low); }

  interval speeds_, parameters_, separating_, variable_;
  double largest_error_;
  std::vector<threshold_piece> threshold_;
  std::vector<node> tree_;
  std::string description_;
  interval log_parameter_;
  std::vector<branch> branches_; ///< of the nodes of the same numbers
  std::vector<std::size_t> start_;
};

} // namespace ricochet
