// compiles

#include "scene.hpp"

// What the programs beside this one do wrong, done right: they fail for no other reason than the one they name.
template <class S>
struct finished_law {
  using role = ricochet::role::crack;
  using number = typename S::number;
  static constexpr std::array<double, 1> joints{1};
  typename S::duration relaxation_time{};

  template <class Other>
  using in = finished_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"relaxation_time", &finished_law::relaxation_time, positive}};
  }
  typename S::speed speed_scale(const basic_pair<S>& pair, typename S::energy_per_area) const {
    return pair.reduced_radius / relaxation_time;
  }
  number first_ratio() const { return number(0.5); }
  edge_rate<number> rate(const number& root_ratio, int) const { return {number(1) - root_ratio, root_ratio}; }
};

int main() {
  compose(pair, hertz{});
  compose(pair, hertz{}, bulk, end_at_zero_overlap{});
  compose(pair, hertz{}, adhesion);
  compose(pair, hertz{}, adhesion, tsuji{.damping_coefficient = 0.1});
  compose(pair, hertz{}, adhesion, finished_law<dimensional>{1.0 * seconds});
  compose(pair, hertz{}, jkr{.work_of_adhesion = 1.0 * joules_per_square_metre});
  const state<double, variables<mutual_approach_t, approach_rate_t, contact_radius_t>> x{};
  const auto out = integrate(compose(pair, hertz{}, adhesion, crack, energy_ledger{}), impact{8.0 * metres_per_second});
  return out.crack_loss > 0 && x[approach_rate] + x[contact_radius] > 0;
}
