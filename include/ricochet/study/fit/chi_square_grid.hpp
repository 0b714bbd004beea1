// Krijt et al.'s way from measured restitutions to parameters: chi^2 on a grid of them [Krijt 2013, section 4.1].
#pragma once
#include <ricochet/study/fit/fit.hpp>
#include <ricochet/study/fit/grid_filling.hpp>

namespace ricochet {

/// One number that a family of models takes, and the values of it that are tried, in the family's own unit.
struct grid_axis {
  std::string name;
  std::vector<double> values;
};

/// n values from low to high in equal ratios. \throws bad_input unless 0 < low < high and n >= 2.
inline grid_axis logarithmic_axis(std::string name, double low, double high, std::size_t n) {
  require("low end of " + name, low, positive);
  require("high end of " + name, high, range{.low = low, .low_included = false});
  require("number of values of " + name, double(n), range{.low = 2});
  grid_axis axis{std::move(name), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i)
    axis.values[i] = low * std::pow(high / low, double(i) / double(n - 1));
  return axis;
}

/// The values of one axis with which chi^2 stays below twice its least value [Krijt 2013, section 4.1]: with all others
/// as they are at the best point, and with the best others for each value.
struct grid_range {
  double best, low_alone, high_alone, low, high;
};

template <std::size_t N>
struct chi_square_grid {
  std::array<grid_axis, N> axes;
  std::vector<double> chi_square; ///< mean square deviation [Krijt 2013 (31)]; the last axis runs fastest
  std::array<std::size_t, N> best;
  std::array<grid_range, N> ranges;
  std::size_t collisions; ///< that were computed

  double at(const std::array<std::size_t, N>& index) const {
    std::size_t i = 0;
    for (std::size_t k = 0; k < N; ++k)
      i = i * axes[k].values.size() + index[k];
    return chi_square[i];
  }
};

namespace detail {

/// What the motion of a model depends on, and what the loss does that is added after it is known.
template <class Model>
struct motion_and_loss {
  std::array<double, quantity_count<elastic_part<Model>>> motion;
  std::array<double, 3 + quantity_count<Model> - quantity_count<elastic_part<Model>>> loss; ///< the pair, and the law

  explicit motion_and_loss(const Model& model) {
    std::size_t i = 0;
    for_each_quantity(model, [&](const char*, const auto& q) {
      if (i < motion.size())
        motion[i] = in_si(q);
      if (i < 3 || i >= motion.size())
        loss[i < 3 ? i : 3 + i - motion.size()] = in_si(q);
      ++i;
    });
  }
};

template <std::size_t N, class Family>
class grid_scan {
  using numbers = std::array<double, N>;
  using model_type = std::remove_cvref_t<std::invoke_result_t<const Family&, const numbers&>>;

public:
  grid_scan(const Family& family, std::span<const measurement> data, const std::array<grid_axis, N>& axes,
            const batch_options& options)
      : family_(family), data_(data), options_(options), grid_{axes, {}, {}, {}, 0} {
    if (data.empty())
      throw bad_input("chi^2 grid: there are no measurements");
    for (const measurement& each : data) {
      require("speed", each.speed, positive);
      require("restitution", each.restitution.value_or(0), range{.high = 1.5});
      measured_.push_back(each.restitution.value_or(0));
    }
    std::size_t count = 1;
    for (const grid_axis& axis : axes) {
      if (axis.values.empty())
        throw bad_input("chi^2 grid: " + axis.name + " has no values");
      count *= axis.values.size();
    }
    grid_.chi_square.resize(count);
  }

  chi_square_grid<N> solve() {
    const auto& last = grid_.axes.back().values;
    const std::size_t rows = grid_.chi_square.size() / last.size();
    const auto [added, alike] = losses_added(rows);
    motions_of_row_ = added ? 1 : last.size();
    const std::vector<std::vector<double>> all_losses = added && alike ? losses_of_row(0) : no_losses();

    // So many speeds at once as memory allows.
    const std::size_t together = std::max<std::size_t>(1, 4'000'000 / (rows * motions_of_row_));
    for (std::size_t first = 0; first < data_.size(); first += together) {
      const std::size_t count = std::min(together, data_.size() - first);
      const grid_filling left = energies_left(first, count, added);
      share(rows, 8, options_.threads, {}, [&](std::size_t from, std::size_t to) {
        for (std::size_t row = from; row < to; ++row) {
          const std::vector<std::vector<double>> own = added && !alike ? losses_of_row(row) : no_losses();
          const std::vector<std::vector<double>>& losses = alike ? all_losses : own;
          for (std::size_t j = 0; j < last.size(); ++j)
            for (std::size_t i = 0; i < count; ++i) {
              const double e_squared = left.at(i, row * motions_of_row_ + (added ? 0 : j));
              const double loss = added ? losses[j][first + i] : 0;
              grid_.chi_square[row * last.size() + j] +=
                  square(std::sqrt(std::max(e_squared - loss, 0.)) - measured_[first + i]) / double(data_.size());
            }
        }
      });
    }
    judge();
    return std::move(grid_);
  }

private:
  model_type model_of(std::size_t row, std::size_t j) const {
    numbers p;
    p[N - 1] = grid_.axes[N - 1].values[j];
    for (std::size_t k = N - 1; k-- > 0;) {
      const auto& values = grid_.axes[k].values;
      p[k] = values[row % values.size()];
      row /= values.size();
    }
    return family_(p);
  }

  static std::vector<std::vector<double>> no_losses() { return {}; }

  struct sharing {
    bool added; ///< models of a row differ by a loss alone that is added after the motion is known
    bool alike; ///< the losses of all rows are
  };
  sharing losses_added([[maybe_unused]] std::size_t rows) const {
    if constexpr (model_type::yields) {
      const std::size_t last = grid_.axes.back().values.size() - 1;
      const motion_and_loss<model_type> first(model_of(0, 0)), end(model_of(0, last));
      sharing found{true, true};
      for (std::size_t row = 0; row < rows; ++row) {
        const motion_and_loss<model_type> low(model_of(row, 0)), high(model_of(row, last));
        found.added &= low.motion == high.motion;
        found.alike &= low.loss == first.loss && high.loss == end.loss;
      }
      return found;
    } else {
      return {false, true};
    }
  }

  /// For each value of the last axis, of each measurement.
  std::vector<std::vector<double>> losses_of_row([[maybe_unused]] std::size_t row) const {
    std::vector<std::vector<double>> losses(grid_.axes.back().values.size());
    if constexpr (model_type::yields)
      for (std::size_t j = 0; j < losses.size(); ++j) {
        const model_type model = model_of(row, j);
        for (const measurement& each : data_)
          losses[j].push_back(model.plasticity.loss(model.pair, each.speed));
      }
    return losses;
  }

  /// e^2 of `count` measured speeds from `first` on, for all motions, without plastic loss if that is added later.
  grid_filling energies_left(std::size_t first, std::size_t count, bool added) {
    std::vector<std::vector<double>> positions;
    for (std::size_t k = 0; k < N - (added ? 1 : 0); ++k)
      positions.push_back(positions_on(grid_.axes[k]));
    const std::size_t motions = motions_of_row_ * (grid_.chi_square.size() / grid_.axes.back().values.size());
    grid_filling left(std::move(positions), count);
    const double share = left.fills_in() ? 0.25 : 1; // of the error, for collision and polynomial
    const auto evaluate = [&](const std::vector<std::size_t>& wanted, std::vector<double>& found) {
      constexpr std::size_t chunk = 100'000;
      for (std::size_t i = 0; i < wanted.size(); i += chunk) {
        const auto some = std::span(wanted).subspan(i, std::min(chunk, wanted.size() - i));
        const auto into = std::span(found).subspan(i, some.size());
        const auto speed_of = [&](std::size_t element) { return data_[first + element / motions].speed; };
        const auto model_for = [&](std::size_t element) {
          return model_of(element % motions / motions_of_row_, element % motions % motions_of_row_);
        };
        if (added)
          solve(some, into, share, speed_of,
                [&](std::size_t element) { return model_for(element).without_plasticity(); });
        else
          solve(some, into, share, speed_of, model_for);
      }
      grid_.collisions += wanted.size();
    };
    left.fill(share * options_.tolerance, evaluate, [&](std::size_t known) {
      if (options_.progress)
        options_.progress(first * motions + known, data_.size() * motions);
    });
    return left;
  }

  /// e^2 of these elements of the grid.
  template <class SpeedOf, class ModelFor>
  void solve(std::span<const std::size_t> elements, std::span<double> found, double share, const SpeedOf& speed_of,
             const ModelFor& model_for) const {
    std::vector<scene<std::remove_cvref_t<decltype(model_for(std::size_t(0)))>>> scenes;
    scenes.reserve(elements.size());
    for (const std::size_t element : elements)
      scenes.push_back({model_for(element), impact{speed_of(element)}});
    batch_options how = options_;
    how.progress = {};
    how.tolerance = std::max(share * options_.tolerance, tolerance_range.low);
    const auto outcomes = collide(scenes, how);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (outcomes[i].ending != ending::separated && outcomes[i].ending != ending::captured)
        throw bad_input("chi^2 grid: a collision ended " + std::string(name_of(outcomes[i].ending)) + ": " +
                        outcomes[i].reason);
      found[i] = square(outcomes[i].restitution.value_or(0));
    }
  }

  /// In which e is to be smooth: logarithms, where all values are positive.
  static std::vector<double> positions_on(const grid_axis& axis) {
    std::vector<double> x = axis.values;
    if (std::all_of(x.begin(), x.end(), [](double each) { return each > 0; }))
      std::transform(x.begin(), x.end(), x.begin(), [](double each) { return std::log(each); });
    return x;
  }

  void judge() {
    const auto index_of = [&](std::size_t i) {
      std::array<std::size_t, N> index;
      for (std::size_t k = N; k-- > 0;) {
        index[k] = i % grid_.axes[k].values.size();
        i /= grid_.axes[k].values.size();
      }
      return index;
    };
    const auto least = std::min_element(grid_.chi_square.begin(), grid_.chi_square.end());
    grid_.best = index_of(std::size_t(least - grid_.chi_square.begin()));
    for (std::size_t k = 0; k < N; ++k) {
      const double best = grid_.axes[k].values[grid_.best[k]];
      grid_.ranges[k] = {best, best, best, best, best};
    }
    for (std::size_t i = 0; i < grid_.chi_square.size(); ++i) {
      if (!(grid_.chi_square[i] <= 2 * *least))
        continue;
      const auto index = index_of(i);
      for (std::size_t k = 0; k < N; ++k) {
        auto others = index;
        others[k] = grid_.best[k];
        const double value = grid_.axes[k].values[index[k]];
        auto& found = grid_.ranges[k];
        found.low = std::min(found.low, value);
        found.high = std::max(found.high, value);
        if (others == grid_.best) {
          found.low_alone = std::min(found.low_alone, value);
          found.high_alone = std::max(found.high_alone, value);
        }
      }
    }
  }

  const Family& family_;
  std::span<const measurement> data_;
  const batch_options& options_;
  chi_square_grid<N> grid_;
  std::vector<double> measured_;
  std::size_t motions_of_row_ = 1; ///< collisions with the same parameters but for the last axis
};

} // namespace detail

/// chi^2 of a family of models, which makes one from an std::array of N numbers, on a grid of these numbers: the mean
/// square of measured minus computed restitution, that of pairs that stick being zero [Krijt 2013 (31)]. All
/// measurements count alike: what is known of their errors is not looked at.
///
/// All collisions run as batches. Where the last axis changes a law alone whose loss is added after the motion is known
/// (thornton_ning), the motions are computed once for all its values. Along axes of more than ten values polynomials of
/// degree six give what lies between collisions, on parts of the grid so small that they are right, within a quarter of
/// the tolerance, at some further collisions of each part; the collisions themselves are solved to a quarter of it.
/// Where a loss added takes most of what is left, that is the error in e^2.
/// \throws bad_input naming what is out of range, or if a collision cannot be resolved
template <std::size_t N, class Family>
chi_square_grid<N> scan_chi_square(const Family& family, std::span<const measurement> data,
                                   const std::array<grid_axis, N>& axes, const batch_options& options = {}) {
  return detail::grid_scan<N, Family>(family, data, axes, options).solve();
}

} // namespace ricochet
