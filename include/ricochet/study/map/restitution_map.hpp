// Maps of the restitution and of the contact duration of one pair, made from collisions.
#pragma once
#include <ricochet/study/map/map_collisions.hpp>
#include <ricochet/study/map/speed_map.hpp>
#include <ricochet/study/sweep.hpp>

#include <random>

namespace ricochet {

/// max_error: of the restitution, or relative of the duration.
struct map_options {
  double max_error = 1e-8;
  unsigned threads = 0;
  progress_callback progress = {}; ///< told the number of pieces that are good, and of all at that time
  std::string about = "";          ///< goes before the description of the model that is saved with the map; one line
};

namespace detail {

template <class Model, class Of>
class map_maker {
  using map_type = speed_map<Of>;
  using piece = typename map_type::piece;
  static constexpr std::size_t terms = map_type::terms, most_pieces = 20'000;
  static constexpr double near = 1e-6; ///< of the sticking speed, relative

public:
  map_maker(const Model& model, const map_options& options) : model_(model), options_(options) {
    require("max_error", options.max_error, range{.low = 1e-10, .high = 1e-2, .high_included = true});
  }

  map_type make(speed low, speed high) {
    require("low speed", low, positive);
    require("high speed", high, range{.low = in_si(low), .low_included = false});
    const double a = in_si(low), b = in_si(high);
    const std::string description = described(model_, one_line(options_.about));
    if (!find_sticking_speed(low, high))
      return {a, b, b, 0, {}, description};
    last_rooted_ = std::min(2 * sticking_, b);
    last_root_ = std::sqrt(last_rooted_ - sticking_);
    std::vector<cell> open;
    if (sticking_ > 0)
      open.push_back({0, last_root_, true});
    for (double at = std::max(a, last_rooted_); at < b; at = std::min(2 * at, b))
      open.push_back({at, std::min(2 * at, b), false});
    std::vector<piece> good;
    while (!open.empty()) {
      std::vector<cell> next;
      const std::vector<attempt> tried = attempts(open);
      for (std::size_t i = 0; i < open.size(); ++i)
        if (tried[i].error <= options_.max_error / 2 || too_narrow(open[i])) {
          good.push_back(tried[i].made);
          largest_error_ = too_narrow(open[i]) ? largest_error_ : std::max(largest_error_, tried[i].error);
        } else {
          const auto [begin, end, rooted] = open[i];
          next.push_back({begin, (begin + end) / 2, rooted});
          next.push_back({(begin + end) / 2, end, rooted});
        }
      if (good.size() + next.size() > most_pieces)
        throw bad_input("map: a max_error of " + shown(options_.max_error) + " takes more than " +
                        std::to_string(most_pieces) + " pieces");
      if (options_.progress)
        options_.progress(good.size(), good.size() + next.size());
      open = std::move(next);
    }
    std::sort(good.begin(), good.end(), [](const piece& x, const piece& y) { return x.begin < y.begin; });
    return {a, b, sticking_, largest_error_, std::move(good), description};
  }

private:
  struct cell {
    double begin, end; ///< of the variable: of the speed, or of the root of its distance to the sticking speed
    bool rooted;
  };
  struct attempt {
    piece made;
    double error = 0;
  };

  /// The slowest separation among speeds in small ratios tells below which the pair sticks. False if there is none.
  bool find_sticking_speed(speed low, speed high) {
    const std::size_t count = 8 + std::size_t(4 * std::log2(in_si(high) / in_si(low)));
    const std::vector<speed> speeds = logarithmic_speeds(low, high, count);
    std::vector<scene<Model>> scenes;
    for (const speed& v : speeds)
      scenes.push_back({model_, {v}});
    const auto outcomes = resolved(scenes, 1e-6, options_.threads);
    const auto separates = [](const auto& out) { return out.restitution.has_value(); };
    const auto first = std::find_if(outcomes.begin(), outcomes.end(), separates);
    if (first == outcomes.end())
      return false;
    const std::size_t slowest = std::size_t(first - outcomes.begin());
    if (slowest > 0)
      sticking_ = in_si(sticking_speed_up_to(model_, speeds[slowest - 1], speeds[slowest], 1e-12).smallest_separated);
    return true;
  }

  double speed_of(const cell& c, double x) const {
    if (!c.rooted)
      return x;
    return x < last_root_ ? sticking_ + x * x : last_rooted_;
  }
  double place(const cell& c, double t) const { return speed_of(c, ((1 - t) * c.begin + (1 + t) * c.end) / 2); }
  double begin_of(const cell& c) const { return speed_of(c, c.begin); }
  double end_of(const cell& c) const { return speed_of(c, c.end); }
  bool too_narrow(const cell& c) const {
    return (c.rooted && end_of(c) <= sticking_ * (1 + near)) || end_of(c) - begin_of(c) < 1e-13 * end_of(c);
  }

  double value(const outcome_of<Model>& out, speed v) const {
    if constexpr (std::same_as<Of, restitution_of_speed>) {
      return out.restitution.value_or(0);
    } else {
      if (!out.restitution)
        throw bad_input("duration map: the pair sticks at " + shown(in_si(v)) +
                        " m/s, though slower ones separate: end the map below");
      return in_si(out.contact_duration);
    }
  }

  /// Polynomials through collisions at the nodes, and their largest errors: at the cell's ends, between the nodes, at
  /// random, and, where the cell reaches there, as near the sticking speed as the promise does.
  std::vector<attempt> attempts(const std::vector<cell>& cells) {
    constexpr std::size_t looks = 9, all = terms + looks;
    std::vector<scene<Model>> scenes;
    for (const cell& c : cells) {
      const auto look = [&](double v) { scenes.push_back({model_, {v * units::metres_per_second}}); };
      for (const double t : of_.node)
        look(place(c, t));
      for (const double t : {-0.995, -0.9, -0.4, 0., 0.4, 0.9, 0.995})
        look(place(c, t));
      look(place(c, std::uniform_real_distribution(-1., 1.)(random_)));
      look(c.rooted && c.begin == 0 && !too_narrow(c) ? sticking_ * (1 + 1.01 * near) : place(c, -0.8));
    }
    const auto outcomes = resolved(scenes, options_.max_error / 16, options_.threads);
    std::vector<attempt> tried(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      Eigen::Matrix<double, all, 1> values;
      for (std::size_t j = 0; j < all; ++j)
        values[Eigen::Index(j)] = value(outcomes[i * all + j], scenes[i * all + j].impact.speed);
      piece& made = tried[i].made = {begin_of(cells[i]), end_of(cells[i]), cells[i].rooted, {}};
      Eigen::Map<Eigen::Matrix<double, terms, 1>>(made.c.data()) = of_.to_powers * values.template head<terms>();
      for (std::size_t j = terms; j < all; ++j) {
        const double v = in_si(scenes[i * all + j].impact.speed), is = values[Eigen::Index(j)];
        tried[i].error = std::max(tried[i].error, std::abs(made(v, sticking_) - is) / (Of::relative ? is : 1));
      }
    }
    return tried;
  }

  const Model& model_;
  const map_options& options_;
  const interpolation<terms> of_;
  std::mt19937_64 random_{1};
  double sticking_ = 0, largest_error_ = 0;
  double last_root_ = 0, last_rooted_ = 0; ///< variable and speed where rooted cells end
};

} // namespace detail

/// e(v) of a model between two speeds, to a largest error that is checked at nine speeds within each piece, one of
/// them at random. Pieces are halved until it is met, next to a kink of e(v) down to the last digits of v; within a
/// millionth of the sticking speed, which is known to 1e-12, the error meant is that of e^2. What separates only
/// between speeds closer than a quarter of an octave may be missed. \throws bad_input if low is not positive or not
/// below high, if the error is outside [1e-10, 1e-2] or takes more than 20000 pieces, or if a collision cannot be
/// resolved
template <class Model>
restitution_map make_restitution_map(const Model& model, speed low, speed high, const map_options& options = {}) {
  return detail::map_maker<Model, restitution_of_speed>(model, options).make(low, high);
}

/// The contact duration, to a relative error that is found likewise; NaN where the pair sticks. Within a millionth of
/// the sticking speed nothing is promised: its last digits there make the error 1e-6 at most where energy decides, as
/// of JKR, and 2e-3 with line_force, where the duration goes as the sixth root of v - v_s; with a finite edge it is
/// smooth up to the end. \throws bad_input likewise, and if the pair sticks again at higher speeds
template <class Model>
duration_map make_duration_map(const Model& model, speed low, speed high, const map_options& options = {}) {
  static_assert(Model::asked.duration, "a map of the contact duration is of a model that is asked for it: name "
                                       "contact_duration in compose()");
  return detail::map_maker<Model, duration_of_speed>(model, options).make(low, high);
}

} // namespace ricochet
