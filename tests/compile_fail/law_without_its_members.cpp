// expects: crack-velocity law: joints, speed_scale, first_ratio or rate is missing or returns another
// type (law/crack/crack_velocity_law.hpp)

#include "scene.hpp"

// A crack-velocity law but for rate().
template <class S>
struct unfinished_law {
  using role = ricochet::role::crack;
  using number = typename S::number;
  static constexpr std::array<double, 1> joints{1};
  typename S::duration relaxation_time{};

  template <class Other>
  using in = unfinished_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"relaxation_time", &unfinished_law::relaxation_time, positive}};
  }
  typename S::speed speed_scale(const basic_pair<S>& pair, typename S::energy_per_area) const {
    return pair.reduced_radius / relaxation_time;
  }
  number first_ratio() const { return number(0.5); }
};

int main() { compose(pair, hertz{}, adhesion, unfinished_law<dimensional>{1.0 * seconds}); }
