#pragma once
#include <ricochet/law/tangential/tangential_law.hpp>

namespace ricochet {

inline constexpr range stiffness_ratio_range{.high = 10, .low_included = false, .high_included = true};

/// Mindlin's contact with Coulomb friction at every point: it sticks inside, slips outside, and springs back.
/// A bed of springs E*(delta - x^2/R) dx at |x| <= a, each with kappa E* dx along the surface and slipping at f.
/// friction_coefficient: f, >= 0. stiffness_ratio: kappa = 4 G*/E*, 1/G* = sum (2 - nu_i)/G_i; stiffness_ratio_of().
/// Valid for like solids (else their press alone shears, neglected), kappa 2/3 to 1; above 10 it swings too fast.
/// Neither adhesion nor damping presses.
/// Source: Cattaneo 1938, Mindlin 1949; as springs Popov & Hess 2015, chapter 5; in impacts Maw et al. 1976.
template <class S>
struct mindlin_law {
  using role = role::tangential;
  using number = typename S::number;
  number friction_coefficient{};
  number stiffness_ratio{};

  template <class Other>
  using in = mindlin_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"friction_coefficient", &mindlin_law::friction_coefficient, non_negative},
                      parameter{"stiffness_ratio", &mindlin_law::stiffness_ratio, stiffness_ratio_range}};
  }

  /// Force per stretch and length of the bed along one diameter.
  typename S::modulus stiffness(const basic_pair<S>& pair) const { return stiffness_ratio * pair.reduced_modulus; }

  /// How far a spring that is pressed in by `press` can be stretched before it slips.
  typename S::length largest_stretch(typename S::length press) const {
    return friction_coefficient / stiffness_ratio * press;
  }
};
using mindlin = mindlin_law<dimensional>;

/// kappa of two solids; 2(1 - nu)/(2 - nu) for like ones. \throws bad_input as validate().
inline double stiffness_ratio_of(const material& one, const material& other) {
  validate(one, "first ");
  validate(other, "second ");
  const auto along = [](const material& m) { // (2 - nu)/G
    return 2 * (2 - m.poissons_ratio) * (1 + m.poissons_ratio) / m.youngs_modulus;
  };
  const double ratio = 4.0 * (detail::compliance(one) + detail::compliance(other)) / (along(one) + along(other));
  return required("stiffness_ratio", ratio, stiffness_ratio_range);
}

} // namespace ricochet
