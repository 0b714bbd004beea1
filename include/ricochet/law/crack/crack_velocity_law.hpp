#pragma once
#include <ricochet/law/role.hpp>

#include <array>

namespace ricochet {

/// Speed of the contact edge as a fraction advance/slowness of the law's speed scale: > 0 where the contact grows.
/// A fraction, because the speed is unbounded at the ends of the law's range, where slowness passes through zero.
template <class T>
struct edge_rate {
  T advance;
  T slowness;
};

/// Crack-velocity law: speed of the edge as a function of beta = G/w, given through sqrt(beta) so that beta - 1 is free
/// of cancellation. `joints` lists the beta at which the law is not smooth, ascending; `piece` counts the intervals
/// between them, and a piece may be evaluated a little beyond its own interval.
/// A law may know no upper bound of beta (`unbounded`): its contact lets go as its radius vanishes, else at slowness =
/// 0. Axioms: speed(1) = 0; monotone between the joints; (G - w) times the opening speed >= 0; slowness = 0 at the
/// ends.
template <class L>
concept crack_velocity_law = any_law<L> && plays<L, role::crack> &&
    requires(const typename L::template in<reduced<double>> law, const basic_pair<reduced<double>>& pair, double x) {
  { L::joints.size() } -> std::convertible_to<std::size_t>;
  { law.speed_scale(pair, x) } -> std::same_as<double>;
  { law.first_ratio() } -> std::same_as<double>;
  { law.rate(x, 0) } -> std::same_as<edge_rate<double>>;
};

/// A law that knows the ends of its range of beta: a closing edge stays above the one, an opening one below the other.
template <class L>
concept limited_crack_law = crack_velocity_law<L> && requires(const typename L::template in<reduced<double>> law) {
  { law.lowest_ratio() } -> std::same_as<double>;
  { law.highest_ratio() } -> std::same_as<double>;
};

template <class L>
inline constexpr bool opens_without_bound = requires {
  requires L::unbounded;
};

/// The rate whichever piece sqrt(beta) lies in: what a pack needs, whose lanes may lie in different pieces.
template <class T, class Law>
edge_rate<T> rate_anywhere(const Law& law, const T& root_ratio) {
  edge_rate<T> result = law.rate(root_ratio, 0);
  for (std::size_t i = 0; i < Law::joints.size(); ++i) {
    const auto beyond = square(root_ratio) > T(static_cast<real_of<T>>(Law::joints[i]));
    const edge_rate<T> next = law.rate(root_ratio, int(i) + 1);
    result.advance = select<T>(
        beyond, [&] { return next.advance; }, [&] { return result.advance; });
    result.slowness = select<T>(
        beyond, [&] { return next.slowness; }, [&] { return result.slowness; });
  }
  return result;
}

} // namespace ricochet
