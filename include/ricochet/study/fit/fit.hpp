// Which parameters of a family of models measured restitutions tell, and how well.
#pragma once
#include <ricochet/batch/batch.hpp>
#include <ricochet/study/fit/least_squares.hpp>
#include <ricochet/study/sensitivity.hpp>

namespace ricochet {

namespace detail {

/// `Family` makes a model from N numbers.
template <std::size_t N, class Family>
class curve_of_family {
  using numbers = std::array<double, N>;
  using model_type = std::remove_cvref_t<std::invoke_result_t<const Family&, const numbers&>>;

public:
  curve_of_family(const Family& family, std::span<const measurement> data, const std::array<free_parameter, N>& free,
                  unsigned threads)
      : family_(family), data_(data), free_(free), threads_(threads) {
    for (const measurement& each : data)
      impacts_.push_back({each.speed});
  }

  std::vector<double> restitutions(const std::vector<double>& parameters, double tolerance) const {
    std::vector<double> e;
    for (const auto& out : collide(family_(as_array(parameters)), std::span<const impact>(impacts_),
                                   batch_options{.tolerance = tolerance, .threads = threads_}))
      e.push_back(out.ending == ending::separated  ? *out.restitution
                  : out.ending == ending::captured ? 0
                                                   : std::numeric_limits<double>::quiet_NaN());
    return e;
  }

  Eigen::MatrixXd derivatives(const std::vector<double>& parameters) const {
    constexpr double tolerance = 1e-4; // a search needs no more, nor do standard errors
    const numbers p = as_array(parameters);
    numbers step, inside;
    for (std::size_t k = 0; k < N; ++k) {
      const auto& [name, low, high] = free_[k];
      step[k] = std::min(1e-3 * (low > 0 ? p[k] : high - low), (high - low) / 8);
      inside[k] = std::clamp(p[k], low + 2 * step[k], high - 2 * step[k]);
    }
    const model_type model = family_(inside); // at zero there may be no derivative
    const std::vector<numbers> slope = slopes_of_quantities(family_, inside, step);
    Eigen::MatrixXd found(data_.size(), N);
    share(data_.size(), 2, threads_, {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const moving_scene<N, model_type> scene{model, impacts_[i], slope};
        numbers
            by{}; // where a collision has no derivatives, too near the sticking speed or unresolved, it tells nothing
        try {
          by = differentiate(scene, {.tolerance = tolerance}).derivative;
        } catch (const bad_input&) {
        }
        for (std::size_t k = 0; k < N; ++k)
          found(Eigen::Index(i), Eigen::Index(k)) = by[k];
      }
    });
    return found;
  }

private:
  static numbers as_array(const std::vector<double>& parameters) {
    numbers p;
    std::copy(parameters.begin(), parameters.end(), p.begin());
    return p;
  }

  const Family& family_;
  std::span<const measurement> data_;
  const std::array<free_parameter, N>& free_;
  unsigned threads_;
  std::vector<impact> impacts_;
};

} // namespace detail

/// fit_curve() of a family of models, in batches, with derivatives as sensitivities() has them.
/// \param family makes a model from an std::array of N numbers, without a tangential law
/// \throws bad_input as fit_curve() does, and where the family or its derivatives do
template <std::size_t N, class Family>
fit_result fit(const Family& family, std::span<const measurement> data, const std::array<free_parameter, N>& free,
               const fit_options& options = {}) {
  const detail::curve_of_family<N, Family> curve(family, data, free, options.threads);
  return fit_curve({[&](const std::vector<double>& p, double tolerance) { return curve.restitutions(p, tolerance); },
                    [&](const std::vector<double>& p) { return curve.derivatives(p); }},
                   data, free, options);
}

} // namespace ricochet
