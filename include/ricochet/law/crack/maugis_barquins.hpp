#pragma once
#include <ricochet/law/crack/crack_velocity_law.hpp>

namespace ricochet {

/// Power law of Maugis & Barquins (also Gent & Schultz), without a bound of G.
/// opening G/w = 1 + (|v|/v0)^n, closing its mirror image w/G = 1 + (v/v0)^n; v = v0 (1/x - 1)^{1/n}, x = min(G/w, w/G)
/// reference_speed: v0, m/s, > 0; exponent: n, in [0.1, 1]; ratio_at_touch: G/w of the first contact, in (0, 1e-6].
/// Valid for elastomers over some decades of speed. Contact grows from a = 0, where G/w = 0 and the edge's speed is
/// unbounded, and lets go as a -> 0. The start skips a time ~ (a_0/v0) ratio_at_touch^{1/3 + 1/n}, a_0 of JKR's jump.
/// Source: Gent & Schultz 1972, Maugis & Barquins 1978 for the opening edge; the closing one is its mirror image.
template <class S>
struct maugis_barquins_law {
  using role = role::crack;
  using number = typename S::number;
  static constexpr std::array<double, 1> joints{1};
  static constexpr bool unbounded = true;
  typename S::speed reference_speed{};
  number exponent{};
  number ratio_at_touch = number(1) / number(1'000'000) / number(1'000'000);

  template <class Other>
  using in = maugis_barquins_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{
        parameter{"reference_speed", &maugis_barquins_law::reference_speed, positive},
        parameter{"exponent", &maugis_barquins_law::exponent, range{.low = 0.1, .high = 1, .high_included = true}},
        parameter{"ratio_at_touch", &maugis_barquins_law::ratio_at_touch,
                  range{.high = 1e-6, .low_included = false, .high_included = true}}};
  }

  typename S::speed speed_scale(const basic_pair<S>&, typename S::energy_per_area) const { return reference_speed; }

  number first_ratio() const { return ratio_at_touch; }

  /// The same formula on both sides of beta = 1.
  edge_rate<number> rate(const number& root_ratio, int) const {
    const number one = 1, power = one / exponent;
    const auto opens = root_ratio > one;
    const number larger = select<number>(
        opens, [&] { return root_ratio; }, [&] { return one; });
    const number root = select<number>( // sqrt(x)
        opens, [&] { return number(one / larger); }, [&] { return root_ratio; });
    const number rest = (one - root) * (one + root);
    const number speed = pow(select<number>(
                                 rest > number(1e-30f), [&] { return rest; }, [] { return number(1e-30f); }),
                             power);
    return {select<number>(
                opens, [&] { return number(-speed); }, [&] { return speed; }),
            pow(number(root * root), power)};
  }
};
using maugis_barquins = maugis_barquins_law<dimensional>;

} // namespace ricochet
