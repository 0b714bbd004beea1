// A smooth function on a grid, from as few of its values as that takes. For scan_chi_square() of chi_square_grid.hpp.
#pragma once
#include <ricochet/body/validate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace ricochet::detail {

/// Several functions of the same grid points, each filled by itself: e^2 over the parameters, at several speeds. In
/// boxes of the grid that are wide enough a polynomial goes through a few values; where it misses others, it is halved.
class grid_filling {
public:
  /// positions: of the grid points along each axis; where they neither ascend nor descend, all are evaluated. count: of
  /// functions.
  grid_filling(std::vector<std::vector<double>> positions, std::size_t count)
      : positions_(std::move(positions)), strides_(positions_.size()) {
    points_ = 1;
    for (std::size_t k = positions_.size(); k-- > 0;) {
      strides_[k] = points_;
      points_ *= positions_[k].size();
      const auto& x = positions_[k];
      in_order_.push_back(std::adjacent_find(x.begin(), x.end(), std::greater_equal()) == x.end() ||
                          std::adjacent_find(x.begin(), x.end(), std::less_equal()) == x.end());
    }
    std::reverse(in_order_.begin(), in_order_.end());
    values_.assign(points_ * count, unknown);
    filled_.assign(points_ * count, false);
  }

  /// Is there an axis along which values may be filled in?
  bool fills_in() const {
    for (std::size_t k = 0; k < positions_.size(); ++k)
      if (polynomial_along(k, positions_[k].size()))
        return true;
    return false;
  }

  /// Value of function i at grid point j, of which the last axis runs fastest.
  double at(std::size_t i, std::size_t j) const { return values_[i * points_ + j]; }

  /// evaluate(indices, values) puts in the values of these elements of [function][grid point]. Square roots of those
  /// that are filled in differ by `allowed` at most from the true ones wherever that is tried. told(known): now and
  /// then, how many elements are known.
  template <class Evaluate, class Told>
  void fill(double allowed, const Evaluate& evaluate, const Told& told) {
    std::vector<box> boxes;
    for (std::size_t i = 0; i < values_.size() / points_; ++i) {
      box whole{i, {}, {}};
      for (const auto& axis : positions_) {
        whole.first.push_back(0);
        whole.last.push_back(axis.size() - 1);
      }
      boxes.push_back(whole);
    }
    std::vector<std::size_t> wanted;
    const auto evaluate_wanted = [&] {
      std::vector<double> found(wanted.size());
      evaluate(wanted, found);
      for (std::size_t i = 0; i < wanted.size(); ++i)
        values_[wanted[i]] = found[i];
      known_ += wanted.size();
      wanted.clear();
    };
    while (!boxes.empty()) {
      std::vector<std::vector<std::size_t>> tried; // of each box
      for (const box& each : boxes) {
        const auto nodes = nodes_of(each);
        for_each_point(nodes, [&](std::size_t point) { want(each.function * points_ + point, wanted); });
        tried.push_back(trials_of(each, nodes));
        for (const std::size_t point : tried.back())
          want(each.function * points_ + point, wanted);
      }
      evaluate_wanted();
      std::vector<box> halves;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        if (const auto axis = settle(boxes[i], tried[i], allowed)) {
          box low = boxes[i], high = boxes[i];
          low.last[*axis] = high.first[*axis] = (low.first[*axis] + low.last[*axis]) / 2;
          halves.push_back(low);
          halves.push_back(high);
        }
      boxes = std::move(halves);
      told(known_);
    }
    // Where zero begins there is a kink that boxes may have missed: it is followed, as is every error that it shows.
    const auto want_again = [&](std::size_t i) {
      if (filled_[i]) {
        filled_[i] = false;
        wanted.push_back(i);
      }
    };
    constexpr std::size_t reach = 2; // beyond a row of nodes, where a polynomial is right anyway
    for (std::size_t i = 0; i < values_.size(); ++i)
      for (const std::size_t j : neighbours(i, 1))
        if ((values_[i] > 0) != (values_[j] > 0)) {
          want_again(i);
          for (const std::size_t k : neighbours(i, reach))
            want_again(k);
        }
    while (!wanted.empty()) {
      const std::vector<std::size_t> again = wanted;
      std::vector<double> before;
      for (const std::size_t i : again)
        before.push_back(values_[i]);
      known_ -= again.size();
      evaluate_wanted();
      for (std::size_t n = 0; n < again.size(); ++n)
        if (std::abs(std::sqrt(values_[again[n]]) - std::sqrt(before[n])) > allowed)
          for (const std::size_t k : neighbours(again[n], reach))
            want_again(k);
    }
  }

private:
  static constexpr std::size_t nodes = 7, most_direct = nodes + 3;
  static constexpr double unknown = -1, wanted_soon = -2; ///< squares are never negative

  struct box {
    std::size_t function;
    std::vector<std::size_t> first, last; ///< grid points along each axis, both of them inside
  };
  using node_sets = std::vector<std::vector<std::size_t>>; ///< along each axis

  /// Elements up to `reach` grid points away along an axis.
  std::vector<std::size_t> neighbours(std::size_t element, std::size_t reach) const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < positions_.size(); ++k) {
      const std::size_t i = index_along(k, element % points_);
      for (std::size_t away = 1; away <= reach; ++away) {
        if (i >= away)
          all.push_back(element - away * strides_[k]);
        if (i + away < positions_[k].size())
          all.push_back(element + away * strides_[k]);
      }
    }
    return all;
  }

  bool polynomial_along(std::size_t k, std::size_t points) const { return in_order_[k] && points > most_direct; }

  void want(std::size_t element, std::vector<std::size_t>& wanted) {
    if (values_[element] == unknown) {
      values_[element] = wanted_soon;
      wanted.push_back(element);
    }
  }

  /// Chebyshev's points of the box with its ends, or all points.
  node_sets nodes_of(const box& b) const {
    node_sets all(positions_.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t steps = b.last[k] - b.first[k];
      if (polynomial_along(k, steps + 1))
        for (std::size_t i = 0; i < nodes; ++i) {
          const double share = (1 - std::cos(pi<double>() * double(i) / (nodes - 1))) / 2;
          all[k].push_back(b.first[k] + std::size_t(std::lround(double(steps) * share)));
        }
      else
        for (std::size_t i = 0; i <= steps; ++i)
          all[k].push_back(b.first[k] + i);
    }
    return all;
  }

  /// action(grid point), the last axis running fastest.
  template <class Action>
  void for_each_point(const node_sets& sets, const Action& action) const {
    std::vector<std::size_t> place(sets.size(), 0);
    for (bool more = true; more;) {
      std::size_t point = 0;
      for (std::size_t k = 0; k < sets.size(); ++k)
        point += sets[k][place[k]] * strides_[k];
      action(point);
      more = false;
      for (std::size_t k = sets.size(); k-- > 0 && !more;)
        if (++place[k] < sets[k].size())
          more = true;
        else
          place[k] = 0;
    }
  }

  std::size_t index_along(std::size_t k, std::size_t point) const { return point / strides_[k] % positions_[k].size(); }

  /// Points halfway between nodes, where a polynomial errs most: along each axis by itself, the other coordinates at
  /// random nodes, then along all axes at once.
  std::vector<std::size_t> trials_of(const box& b, const node_sets& sets) const {
    std::uint64_t random = b.function + 1;
    for (std::size_t k = 0; k < sets.size(); ++k)
      random = (random * 1'000'003 + b.first[k]) * 1'000'003 + b.last[k];
    const auto below = [&](std::size_t n) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      return std::size_t((random >> 33) % n);
    };
    const auto has_gaps = [&](std::size_t k) { return polynomial_along(k, b.last[k] - b.first[k] + 1); };
    const auto within = [&](std::size_t k, std::size_t gap) {
      return (sets[k][gap] + sets[k][gap + 1]) / 2 * strides_[k];
    };
    const auto at_node = [&](std::size_t k) { return sets[k][below(sets[k].size())] * strides_[k]; };
    std::vector<std::size_t> tried;
    for (std::size_t k = 0; k < sets.size(); ++k)
      for (std::size_t gap = 0; has_gaps(k) && gap + 1 < nodes; ++gap) {
        std::size_t point = within(k, gap);
        for (std::size_t l = 0; l < sets.size(); ++l)
          if (l != k)
            point += at_node(l);
        tried.push_back(point);
      }
    for (int i = 0; i < 8 && !tried.empty(); ++i) {
      std::size_t point = 0;
      for (std::size_t k = 0; k < sets.size(); ++k)
        point += has_gaps(k) ? within(k, below(nodes - 1)) : at_node(k);
      tried.push_back(point);
    }
    return tried;
  }

  /// Polynomials along axis k that are one at their node and zero at the others, at grid point i.
  std::vector<double> weights(std::size_t k, const std::vector<std::size_t>& set, std::size_t i) const {
    const auto& x = positions_[k];
    std::vector<double> all(set.size(), 1);
    for (std::size_t n = 0; n < set.size(); ++n)
      for (std::size_t m = 0; m < set.size(); ++m)
        if (m != n)
          all[n] *= (x[i] - x[set[m]]) / (x[set[n]] - x[set[m]]);
    return all;
  }

  /// The polynomial at all points of the box, from its values at the nodes; both with the last axis running fastest.
  std::vector<double> interpolated(const box& b, const node_sets& sets, std::vector<double> table) const {
    std::size_t outer = table.size(), inner = 1;
    for (std::size_t k = sets.size(); k-- > 0;) {
      const std::size_t count = b.last[k] - b.first[k] + 1;
      outer /= sets[k].size();
      std::vector<double> next(outer * count * inner, 0);
      for (std::size_t i = 0; i < count; ++i) {
        const std::vector<double> weight = weights(k, sets[k], b.first[k] + i);
        for (std::size_t o = 0; o < outer; ++o)
          for (std::size_t n = 0; n < weight.size(); ++n)
            for (std::size_t j = 0; j < inner; ++j)
              next[(o * count + i) * inner + j] += weight[n] * table[(o * weight.size() + n) * inner + j];
      }
      table = std::move(next);
      inner *= count;
    }
    return table;
  }

  /// Fills the box in, if the polynomial is right at all points tried; else the axis along which to halve it.
  std::optional<std::size_t> settle(const box& b, const std::vector<std::size_t>& tried, double allowed) {
    if (tried.empty()) // all points are nodes
      return std::nullopt;
    const node_sets sets = nodes_of(b);
    double* const values = values_.data() + b.function * points_;
    std::vector<double> table;
    for_each_point(sets, [&](std::size_t point) { table.push_back(values[point]); });
    table = interpolated(b, sets, std::move(table));

    node_sets all(sets.size());
    std::size_t longest = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
      for (std::size_t i = b.first[k]; i <= b.last[k]; ++i)
        all[k].push_back(i);
      if (all[k].size() * in_order_[k] > all[longest].size() * in_order_[longest])
        longest = k;
    }
    std::optional<std::size_t> halved;
    double worst = allowed;
    for (const std::size_t point : tried) {
      std::size_t place = 0, between = 0, axis = 0; // between: nodes, along so many axes
      for (std::size_t k = 0; k < sets.size(); ++k) {
        const std::size_t i = index_along(k, point);
        place = place * all[k].size() + (i - b.first[k]);
        if (std::find(sets[k].begin(), sets[k].end(), i) == sets[k].end()) {
          ++between;
          axis = k;
        }
      }
      const double error = std::abs(std::sqrt(std::max(table[place], 0.)) - std::sqrt(values[point]));
      if (error > worst) {
        worst = error;
        halved = between == 1 ? axis : longest;
      }
    }
    if (halved)
      return halved;
    std::size_t place = 0;
    for_each_point(all, [&](std::size_t point) {
      if (values[point] == unknown) {
        values[point] = std::max(table[place], 0.);
        filled_[b.function * points_ + point] = true;
        ++known_;
      }
      ++place;
    });
    return std::nullopt;
  }

  std::vector<std::vector<double>> positions_;
  std::vector<bool> in_order_;
  std::vector<std::size_t> strides_;
  std::size_t points_, known_ = 0;
  std::vector<double> values_;
  std::vector<bool> filled_; ///< from a polynomial
};

} // namespace ricochet::detail
