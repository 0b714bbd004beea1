#pragma once
#include <ricochet/law/crack/crack_velocity_law.hpp>
#include <ricochet/law/crack/greenwood_table.hpp>

#include <memory>

namespace ricochet {

/// Exact crack-velocity law of a Dugdale zone in a three-element solid, any k (theory as in Greenwood 2004).
/// opening beta = 1/[1-(1-k)I], v = pi beta/(4 alpha); closing beta = [1-(1-k)N]^2/D, v = pi/(4 alpha D), D =
/// 1-(1-k)(2N-I) relaxation_time T_vis >= 0; modulus_ratio k in [1e-4, 0.98]; interaction_range z0 > 0;
/// first_ratio_over_k in (1, 1.02). Valid while the cohesive zone is short against the contact radius. Backward error
/// |beta(v(beta)) - beta| <= 1e-13 beta. Source: Krijt 2013 (12)-(15) for the model; N, I: cohesive_zone.hpp.
template <class S>
struct greenwood_law {
  using role = role::crack;
  using number = typename S::number;
  static constexpr std::array<double, 1> joints{1};
  typename S::duration relaxation_time{};
  number modulus_ratio{};
  typename S::length interaction_range{};
  number first_ratio_over_k = number(1.01);
  typename greenwood_table_of<number>::type table{}; ///< made by compose(); give one made for the same k to share it

  template <class Other>
  using in = greenwood_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"relaxation_time", &greenwood_law::relaxation_time, non_negative},
                      parameter{"modulus_ratio", &greenwood_law::modulus_ratio, modulus_ratio_range},
                      parameter{"interaction_range", &greenwood_law::interaction_range, positive},
                      parameter{"first_ratio_over_k", &greenwood_law::first_ratio_over_k,
                                range{.low = 1, .high = 1.02, .low_included = false}}};
  }

  /// \throws bad_input if the shared table belongs to another modulus ratio.
  void tabulate() requires std::same_as<number, double> {
    if (!table)
      table = std::make_shared<const greenwood_table>(modulus_ratio);
    if (table->modulus_ratio != modulus_ratio)
      throw bad_input("greenwood: the table given was made for modulus_ratio = " + shown(table->modulus_ratio) +
                      ", not for " + shown(modulus_ratio));
  }

  /// C = E* z0^2/(w T_vis): the edge's speed is C advance/slowness.
  typename S::speed speed_scale(const basic_pair<S>& pair, typename S::energy_per_area work_of_adhesion) const {
    return pair.reduced_modulus * interaction_range * interaction_range / (work_of_adhesion * relaxation_time);
  }

  /// beta of the contact's edge when the bodies touch [K appendix B].
  number first_ratio() const { return first_ratio_over_k * modulus_ratio; }
  number lowest_ratio() const { return modulus_ratio; }
  number highest_ratio() const { return number(1) / modulus_ratio; }

  /// Piece 0 closes (k < beta < 1), piece 1 opens (1 < beta < 1/k); a piece for each lane where numbers are lanes.
  template <class Piece>
  edge_rate<number> rate(const number& root_ratio, const Piece& piece) const {
    const number k = modulus_ratio;
    const number excess = (root_ratio - number(1)) * (root_ratio + number(1)); // beta - 1
    const number distance = max(number(abs(excess)), number(1e-18f));
    const auto closes = piece == 0; // for all lanes, or for each
    const auto below = excess < number(0);
    const auto exact = [&] { return number(root_ratio * root_ratio); };
    // beyond beta = 1 the mirror image of the speed
    const number ratio = select<number>(
        closes, [&] { return select<number>(below, exact, [&] { return number(number(1) - distance); }); },
        [&] {
          return select<number>(
              below, [&] { return number(number(1) + distance); }, exact);
        });
    const number sign = select<number>(
        below, [] { return number(1); }, [] { return number(-1); });
    const number Q = select<number>(
                         closes, [&] { return number(ratio - k); }, [&] { return number(number(1) - k * ratio); }) /
                     distance;
    return {select<number>(
                closes, [&] { return sign; }, [&] { return number(sign * pi<number>() * ratio); }),
            Q * slowness_over_factor(closes, Q)};
  }

private:
  template <class Condition>
  number slowness_over_factor(const Condition& closes, const number& Q) const {
    if constexpr (!std::same_as<Condition, bool>)
      return table.value(closes, Q);
    else if constexpr (number_traits<number>::inverts_exactly)
      return closes ? exact_closing_slowness(Q) : exact_opening_slowness(Q);
    else
      return evaluate<number>(closes ? table->closing : table->opening, Q);
  }

  number exact_closing_slowness(const number& Q) const {
    if (Q <= number(0))
      return number(12) * modulus_ratio / pi<number>();
    const auto curve = [this](const number& a) { return cohesive_zone::closing<number>(a, modulus_ratio); };
    const double near = static_cast<double>(Q);
    const double guess = 0.25 * pi<double>() * near * table->closing.value(near); // alpha D; alpha >= this
    const number alpha = cohesive_zone::invert<number>(curve, Q, number(std::max(guess, near)));
    return curve(alpha).slowness / Q;
  }
  number exact_opening_slowness(const number& Q) const {
    if (Q <= number(0))
      return number(12);
    const double near = static_cast<double>(Q);
    return number(4) / Q *
           cohesive_zone::invert<number>(cohesive_zone::opening<number>, Q,
                                         number(near * table->opening.value(near) / 4));
  }
};
using greenwood = greenwood_law<dimensional>;

} // namespace ricochet
