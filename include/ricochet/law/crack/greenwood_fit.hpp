#pragma once
#include <ricochet/law/crack/crack_velocity_law.hpp>

namespace ricochet {

/// Greenwood's published fits to the crack-velocity law, k = 0.02 only.
/// v = 0.15/(beta ln[(1-k)/(1-beta)]) | (0.1035x+0.3421)x^1.116, x = 1/beta-1 | -(0.2112x+0.3939)x^1.1403, x = beta-1 |
/// -0.24 beta/ln[(1-k)/(1-1/beta)] relaxation_time T_vis >= 0; modulus_ratio k = 0.02; interaction_range z0 > 0;
/// first_ratio_over_k in (1, 1.02). Joints at beta = 0.29, 1, 3.7 with jumps of -0.8 % and +0.6 %; off the exact law by
/// up to 7.3 % in beta. Source: Krijt 2013 (16), (17).
template <class S>
struct greenwood_fit_law {
  using role = role::crack;
  using number = typename S::number;
  static constexpr std::array<double, 3> joints{0.29, 1, 3.7};
  typename S::duration relaxation_time{};
  number modulus_ratio = number(2) / number(100);
  typename S::length interaction_range{};
  number first_ratio_over_k = number(1.01);

  template <class Other>
  using in = greenwood_fit_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"relaxation_time", &greenwood_fit_law::relaxation_time, non_negative},
                      parameter{"modulus_ratio", &greenwood_fit_law::modulus_ratio, modulus_ratio_range},
                      parameter{"interaction_range", &greenwood_fit_law::interaction_range, positive},
                      parameter{"first_ratio_over_k", &greenwood_fit_law::first_ratio_over_k,
                                range{.low = 1, .high = 1.02, .low_included = false}}};
  }

  /// \throws bad_input for any other k than the fits'.
  void validate() const requires std::same_as<number, double> {
    if (modulus_ratio != 0.02)
      throw bad_input("greenwood_fit: modulus_ratio = " + shown(modulus_ratio) +
                      " but the published fits hold for 0.02 only; use greenwood, the exact law for any modulus ratio");
  }

  /// C = E* z0^2/(w T_vis): the edge's speed is C advance/slowness.
  typename S::speed speed_scale(const basic_pair<S>& pair, typename S::energy_per_area work_of_adhesion) const {
    return pair.reduced_modulus * interaction_range * interaction_range / (work_of_adhesion * relaxation_time);
  }

  /// beta of the contact's edge when the bodies touch [K appendix B].
  number first_ratio() const { return first_ratio_over_k * modulus_ratio; }
  number lowest_ratio() const { return modulus_ratio; }
  number highest_ratio() const { return number(1) / modulus_ratio; }

  edge_rate<number> rate(const number& root_ratio, int piece) const {
    const number one = 1, k = modulus_ratio;
    const number ratio = root_ratio * root_ratio;
    const number excess = (root_ratio - one) * (root_ratio + one);
    const number below = select<number>( // 1 - beta, kept positive for the logarithm
        excess < -thousandths(1), [&] { return number(-excess); }, [] { return thousandths(1); });
    const number inverse = select<number>( // 1/beta, kept below one for the logarithm
        ratio > thousandths(1001), [&] { return number(one / ratio); }, [] { return thousandths(999); });
    switch (piece) {
    case 0: // [K (16)], closing
      return {one, ratio * log((one - k) / below) / thousandths(150)};
    case 1: // [K (17)], closing
      return power(-excess / ratio, thousandths(1035) / number(10), thousandths(3421) / number(10), thousandths(1116));
    case 2: { // [K (17)], opening
      const auto closing = power(excess, thousandths(2112) / number(10), thousandths(3939) / number(10),
                                 thousandths(11403) / number(10));
      return {-closing.advance, closing.slowness};
    }
    default: // [K (16)], opening
      return {-thousandths(240) * ratio, log((one - k) / (one - inverse))};
    }
  }

private:
  static number thousandths(int n) { return number(static_cast<float>(n)) / number(1000); }

  /// (p x + q) x^n, odd in x so that it can be evaluated beyond its joint.
  static edge_rate<number> power(const number& x, const number& p, const number& q, const number& n) {
    const number size = select<number>(
        abs(x) > number(1e-30f), [&] { return number(abs(x)); }, [] { return number(1e-30f); });
    const number speed = (p * size + q) * pow(size, n);
    return {select<number>(
                x > number(0), [&] { return speed; }, [&] { return number(-speed); }),
            number(1)};
  }
};
using greenwood_fit = greenwood_fit_law<dimensional>;

} // namespace ricochet
