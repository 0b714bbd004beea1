// What the restitution depends on, and how much: its derivatives with respect to everything a scene is made of.
#pragma once
#include <ricochet/number/gradient.hpp>
#include <ricochet/solve/collide.hpp>

#include <memory>
#include <string>
#include <vector>

namespace ricochet {

/// Something that the restitution depends on: a constant of the pair, a parameter of a law, or the speed.
struct sensitivity {
  std::string quantity, unit;
  double value;      ///< in SI
  double derivative; ///< of the restitution with respect to it

  double relative() const { return value * derivative; } ///< by its logarithm
};

/// A restitution and its derivatives with respect to N things. Of a captured pair, value and derivatives are zero.
template <std::size_t N>
struct differentiated_restitution {
  ricochet::ending ending;
  double value, error_estimate;
  std::array<double, N> derivative{};
  double derivative_error = 0; ///< estimate for the derivatives by quantities' logarithms, the largest
};

namespace detail {

/// f(name, quantity) for all that the restitution depends on but the speed, in the order of reduced_laws.
template <class Model, class Function>
void for_each_quantity(Model& model, const Function& f) {
  f("reduced_modulus", model.pair.reduced_modulus);
  f("reduced_radius", model.pair.reduced_radius);
  f("reduced_mass", model.pair.reduced_mass);
  const auto of_law = [&](auto& law) {
    std::apply([&](const auto&... p) { (f(p.name, law.*(p.member)), ...); },
               std::remove_cvref_t<decltype(law)>::parameters());
  };
  of_law(model.elastic);
  of_law(model.adhesion);
  of_law(model.crack);
  of_law(model.damping);
  of_law(model.tangential);
  of_law(model.plasticity);
}

template <class Law>
inline constexpr std::size_t parameter_count = std::tuple_size_v<decltype(Law::parameters())>;
template <class Model>
inline constexpr std::size_t quantity_count =
    3 + parameter_count<decltype(Model::elastic)> + parameter_count<decltype(Model::adhesion)> +
    parameter_count<decltype(Model::crack)> + parameter_count<decltype(Model::damping)> +
    parameter_count<decltype(Model::tangential)> + parameter_count<decltype(Model::plasticity)>;

/// A scene that can be moved: quantity i, or the speed behind them, goes along direction j by slope[i][j], in SI.
template <std::size_t N, class Model>
struct moving_scene {
  Model model;
  ricochet::impact impact;
  std::vector<std::array<double, N>> slope; ///< quantity_count<Model> + 1 rows

  double along_speed(std::size_t j) const { return slope.back()[j]; }

  /// Largest relative change of a quantity by a step of one along direction j; of those that are zero it tells nothing.
  double pace(std::size_t j) const {
    double largest = std::abs(along_speed(j)) / in_si(impact.speed);
    std::size_t i = 0;
    for_each_quantity(model, [&](const char*, const auto& q) {
      if (const double moved = slope[i++][j]; moved != 0 && in_si(q) != 0)
        largest = std::max(largest, std::abs(moved / in_si(q)));
    });
    return largest;
  }

  /// Does direction j lead away from a zero, beyond which there may be no law?
  bool leaves_zero(std::size_t j) const {
    bool leaves = false;
    std::size_t i = 0;
    for_each_quantity(model, [&](const char*, const auto& q) { leaves |= slope[i++][j] != 0 && in_si(q) == 0; });
    return leaves;
  }

  /// The scene a step away along direction j.
  std::pair<Model, ricochet::impact> at(std::size_t j, double step) const {
    std::pair<Model, ricochet::impact> moved{model, impact};
    std::size_t i = 0;
    for_each_quantity(moved.first, [&](const char*, auto& q) {
      if (const double by = step * slope[i++][j]; by != 0)
        q *= 1 + by / in_si(q);
    });
    moved.second.speed *= 1 + step * along_speed(j) / in_si(impact.speed);
    if constexpr (requires { model.crack.table; })
      if (auto& crack = moved.first.crack; crack.modulus_ratio != model.crack.modulus_ratio)
        crack.table = std::make_shared<std::remove_reference_t<decltype(*crack.table)>>(crack.modulus_ratio);
    return moved;
  }

  /// Does direction j change what the law has tables of, which dual numbers do not see?
  bool moves_table(std::size_t j) const {
    bool moves = false;
    if constexpr (requires { model.crack.table; }) {
      std::size_t i = 0;
      for_each_quantity(model, [&](const char*, const auto& q) {
        moves |= static_cast<const void*>(&q) == &model.crack.modulus_ratio && slope[i][j] != 0;
        ++i;
      });
    }
    return moves;
  }
};

/// How all quantities of a family's model, and in a last row, of zeros, the speed, go with its numbers p: by
/// differences of the family's formulas, for which each number is moved by once and twice its step.
template <std::size_t N, class Family>
std::vector<std::array<double, N>> slopes_of_quantities(const Family& family, const std::array<double, N>& p,
                                                        const std::array<double, N>& step) {
  using model_type = std::remove_cvref_t<std::invoke_result_t<const Family&, const std::array<double, N>&>>;
  std::vector<std::array<double, N>> slope(quantity_count<model_type> + 1);
  for (std::size_t k = 0; k < N; ++k) {
    const double h = step[k];
    const auto moved = [&](double by) {
      std::array<double, N> q = p;
      q[k] += by;
      const model_type model = family(q);
      std::vector<double> all;
      for_each_quantity(model, [&](const char*, const auto& quantity) { all.push_back(in_si(quantity)); });
      return all;
    };
    const auto up = moved(h), down = moved(-h), far_up = moved(2 * h), far_down = moved(-2 * h);
    for (std::size_t i = 0; i < up.size(); ++i) {
      const double by_two = (far_up[i] - far_down[i]) / (4 * h), by_one = (up[i] - down[i]) / (2 * h);
      slope[i][k] = up[i] == down[i] ? 0 : (4 * by_one - by_two) / 3;
    }
  }
  return slope;
}

/// By central differences at two distances, extrapolated; nothing where the pair is captured at one of them, NaN where
/// there is but one side.
template <std::size_t N, class Model>
std::optional<double> derivative_by_differences(const moving_scene<N, Model>& scene, std::size_t j) {
  if (scene.leaves_zero(j))
    return std::numeric_limits<double>::quiet_NaN();
  const double pace = scene.pace(j);
  if (pace == 0)
    return 0.;
  const collide_options closest{.tolerance = 1e-12};
  for (double relative = 2e-3; relative > 1e-6; relative /= 10) {
    const auto difference = [&](double step) {
      const auto [above, faster] = scene.at(j, step);
      const auto [below, slower] = scene.at(j, -step);
      const auto up = integrate(above, faster, closest), down = integrate(below, slower, closest);
      return up.restitution && down.restitution ? (*up.restitution - *down.restitution) / (2 * step)
                                                : std::numeric_limits<double>::quiet_NaN();
    };
    const double step = relative / pace, derivative = (4 * difference(step) - difference(2 * step)) / 3;
    if (!std::isnan(derivative))
      return derivative;
  }
  return std::nullopt;
}

/// By dual numbers, at one step tolerance; nothing if the edge is too fast for an explicit method.
template <std::size_t N, class Model>
std::optional<std::array<double, N>> derivatives_by_duals(const moving_scene<N, Model>& scene, double tolerance) {
  using number = gradient<double, N>;
  const scales unit = scales_at(scene.model, scene.impact.speed);
  std::size_t next = 0;
  const auto moving = [&](const auto& quantity) {
    number x = reduce<double>(quantity, unit);
    for (std::size_t j = 0; j < N; ++j)
      x.slope[j] = scene.slope[next][j] / unit.factor(quantity);
    ++next;
    return x;
  };
  const reduced_model<number, Model> numbers(reduced_laws<number, Model>(scene.model, moving));
  const number v = moving(scene.impact.speed);
  const long budget = 200'000;
  const auto out =
      collision<reduced_model<number, Model>, stepper::tsitouras_papakostas75>(numbers, tolerance, budget).solve(v);
  if (!out.restitution)
    return std::nullopt;
  return out.restitution->slope;
}

template <std::size_t N, class Model>
differentiated_restitution<N> differentiate(const moving_scene<N, Model>& scene, const collide_options& options) {
  static_assert(!Model::has_friction, "derivatives are of normal collisions: leave out the tangential law");
  if constexpr (Model::yields) { // e^2 = e_A^2 - loss, of which only the loss depends on the law of plastic flow
    auto slope = scene.slope;
    slope.erase(slope.end() - 1 - std::ptrdiff_t(parameter_count<decltype(Model::plasticity)>), slope.end() - 1);
    const auto elastic = differentiate(
        moving_scene<N, elastic_part<Model>>{scene.model.without_plasticity(), scene.impact, slope}, options);
    const auto out = with_plastic_loss(scene.model, scene.impact.speed,
                                       integrate(scene.model.without_plasticity(), scene.impact, options));
    differentiated_restitution<N> found{out.ending, out.restitution.value_or(0), out.error_estimate};
    for (std::size_t j = 0; out.restitution && j < N; ++j) {
      double loss_slope = 0;
      if (const double pace = scene.pace(j); pace > 0) {
        const double step = 1e-5 / pace;
        const auto [above, faster] = scene.at(j, step);
        const auto [below, slower] = scene.at(j, -step);
        loss_slope =
            (above.plasticity.loss(above.pair, faster.speed) - below.plasticity.loss(below.pair, slower.speed)) /
            (2 * step);
      }
      found.derivative[j] = (elastic.value * elastic.derivative[j] - loss_slope / 2) / found.value;
      found.derivative_error = elastic.derivative_error * elastic.value / found.value;
    }
    return found;
  } else {
    if constexpr (Model::has_crack_law)
      if (edge_is_static(scene.model)) { // from which it differs by a power of its speed that is below one
        auto slope = scene.slope;
        const auto crack = slope.begin() + std::ptrdiff_t(3 + parameter_count<decltype(Model::elastic)> +
                                                          parameter_count<decltype(Model::adhesion)>);
        slope.erase(crack, crack + std::ptrdiff_t(parameter_count<decltype(Model::crack)>));
        const auto held = scene.model.with_static_edge();
        auto found =
            differentiate(moving_scene<N, std::remove_const_t<decltype(held)>>{held, scene.impact, slope}, options);
        for (std::size_t j = 0; j < N; ++j)
          if (scene.leaves_zero(j))
            found.derivative[j] = std::numeric_limits<double>::quiet_NaN();
        return found;
      }
    const auto out = integrate(scene.model, scene.impact, options);
    if (out.ending != ending::separated && out.ending != ending::captured)
      throw bad_input("derivatives: the collision at " + shown(in_si(scene.impact.speed)) + " m/s ended " +
                      name_of(out.ending) + ": " + out.reason);
    differentiated_restitution<N> found{out.ending, out.restitution.value_or(0), out.error_estimate};
    if (!out.restitution)
      return found;
    bool by_duals = false;
    for (double tolerance = std::clamp(options.tolerance / 100, 1e-12, 1e-6); !by_duals && tolerance > 1e-14;
         tolerance /= 100) {
      const auto rough = derivatives_by_duals(scene, tolerance), fine = derivatives_by_duals(scene, tolerance / 16);
      if (!rough || !fine)
        break;
      found.derivative = *fine;
      found.derivative_error = 0;
      for (std::size_t j = 0; j < N; ++j)
        if (!std::isfinite((*fine)[j])) // as of a root at zero
          found.derivative[j] = std::numeric_limits<double>::quiet_NaN();
        else if (const double pace = scene.pace(j); pace > 0)
          found.derivative_error = std::max(found.derivative_error, std::abs((*fine)[j] - (*rough)[j]) / pace);
      by_duals = found.derivative_error <= std::max(options.tolerance, 1e-9);
    }
    for (std::size_t j = 0; j < N; ++j)
      if (!by_duals || scene.moves_table(j)) {
        const auto derivative = derivative_by_differences(scene, j);
        if (!derivative)
          throw bad_input("derivatives: the pair sticks at " + shown(in_si(scene.impact.speed)) +
                          " m/s as soon as a quantity changes by a millionth");
        found.derivative[j] = *derivative;
        found.derivative_error = std::max(by_duals ? found.derivative_error : 0., 1e-8);
      }
    return found;
  }
}

} // namespace detail

/// What comes of an impact, and how its restitution changes with all that the scene is made of.
template <class Model>
struct sensitive_outcome {
  outcome_of<Model> outcome;
  std::vector<sensitivity> by;
  double error_estimate = 0; ///< of the relative ones
};

/// Derivatives of the restitution of a normal collision with respect to the constants of the pair, every parameter of a
/// law, and the speed, by dual numbers in one run; by differences where an edge is too fast for that, and with respect
/// to greenwood's modulus ratio, of which it has tables. They are zero where the pair is captured, and NaN with respect
/// to a quantity that is zero where they have no bound, such as a work of adhesion.
/// \throws bad_input as integrate(), if the collision is not resolved, or within a millionth of the sticking speed.
template <class Model>
sensitive_outcome<Model> sensitivities(const Model& model, const impact& impact, const collide_options& options = {}) {
  constexpr std::size_t count = detail::quantity_count<Model> + 1;
  detail::moving_scene<count, Model> scene{model, impact, std::vector<std::array<double, count>>(count)};
  for (std::size_t i = 0; i < count; ++i)
    scene.slope[i][i] = 1;
  sensitive_outcome<Model> result{integrate(model, impact, options), {}, 0};
  const auto found = detail::differentiate(scene, options);
  result.error_estimate = found.derivative_error;
  std::size_t i = 0;
  const auto add = [&](const char* name, const auto& q) {
    result.by.push_back({name, unit_symbol(q), in_si(q), found.derivative[i++]});
  };
  detail::for_each_quantity(model, add);
  add("speed", impact.speed);
  return result;
}

} // namespace ricochet
