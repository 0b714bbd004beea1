#pragma once
#include <ricochet/law/plasticity/flowing_law.hpp>

namespace ricochet {

/// Thornton & Ning within the motion: the pressure in the contact is cut off at that of first yield, p_y = 1.6 Y.
/// Growing beyond the yield radius a_y, dF_1/da = 2 pi a p_y + 2E*c sqrt(a), F_1 the force without the adhesion's part
/// and c its flattening; beyond the largest radius so far only; else elastic, with R_p = 4E*a^3/3F_1 of that radius
/// and delta_p = a^2/R - a^2/R_p.
/// yield_strength: Y of the weaker body, Pa, > 0; of a small body, closed_form::yield_strength() gives it.
/// Valid for Hertz with or without JKR, while the plastic zone is enclosed: to pressures of about 3 Y on average. Below
/// least_strength() the contact yields while adhesion draws it together, where the law would create energy.
/// Source: Thornton & Ning 1998, Powder Technol. 99 154; without adhesion its restitution is Krijt 2013 (29).
template <class S>
struct thornton_ning_contact_law {
  using role = role::plasticity;
  using number = typename S::number;
  using length = typename S::length;
  using root_length = typename S::root_length;
  typename S::modulus yield_strength{};

  template <class Other>
  using in = thornton_ning_contact_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"yield_strength", &thornton_ning_contact_law::yield_strength, positive}};
  }

  /// Pressure at the centre at first yield.
  typename S::modulus yield_pressure() const { return number(8) * yield_strength / number(5); }

  /// Where p(0) = 2E*a/(pi R) - E*c/(pi sqrt(a)) = p_y, by Newton's method from above, where it is convex in sqrt(a).
  length yield_radius(const basic_pair<S>& pair, root_length flattening) const {
    const length R = pair.reduced_radius;
    const length hertzian = pi<number>() * R * yield_pressure() / (number(2) * pair.reduced_modulus);
    if (flattening == root_length{})
      return hertzian;
    const auto constant = R * flattening / number(2);
    root_length y = sqrt(hertzian) + cube_root(constant);
    for (int i = 0; i < 60; ++i) {
      const root_length step = (y * (y * y - hertzian) - constant) / (number(3) * y * y - hertzian);
      y -= step;
      if (abs(step) <= number(4) * std::numeric_limits<number>::epsilon() * y)
        break;
    }
    return y * y;
  }

  /// Shape of a contact whose largest radius is this, >= that of first yield.
  contact_shape<S> shape(const basic_pair<S>& pair, root_length flattening, length yielded, length largest) const {
    const length a = largest, R = pair.reduced_radius;
    const number strain = number(3) * pi<number>() * yield_pressure() / (number(4) * pair.reduced_modulus);
    // 3F_1/4E* is `area`; of it and a^3/R that which has grown since yield, so that at yield nothing is left but zeros.
    const length growth = a - yielded;
    const root_length root = sqrt(a), root_yielded = sqrt(yielded);
    const auto grown_area =
        growth * (strain * (a + yielded) + flattening * (a + root * root_yielded + yielded) / (root + root_yielded));
    const auto grown_cube = growth * ((a * a + a * yielded + yielded * yielded) / R);
    const auto area = yielded * yielded * (yielded / R) + grown_area;
    const auto slope = number(2) * strain * a + number(3) * flattening * root / number(2);
    const auto per_radius = number(1) / a;
    const auto per_area = number(1) / area;
    const number flat = a / R;
    contact_shape<S> result;
    result.radius = a * (a * a * per_area);
    result.residual_approach = (grown_cube - grown_area) * per_radius;
    result.radius_slope = (number(3) * a * a - result.radius * slope) * per_area;
    result.approach_slope = number(2) * flat - (slope - area * per_radius) * per_radius;
    return result;
  }

  /// Energy lost for each growth of the largest radius: F d(delta_p)/da - dU/dR_p dR_p/da, with Hertz's U.
  typename S::force lost_force(const flattened_configuration<S>& c) const {
    const length flat = c.radius * c.radius / c.shape.radius;
    const auto stiffness = number(2) * c.pair.reduced_modulus * c.radius;
    return stiffness * ((c.approach - flat / number(3)) * c.shape.approach_slope -
                        (flat / c.shape.radius) * (c.approach / number(3) - flat / number(5)) * c.shape.radius_slope);
  }

  /// Strength of a contact that first yields at a^{3/2} = 5cR/4, 1.16 times its radius at touch: of one that yields at
  /// less, lost_force() begins negative.
  typename S::modulus least_strength(const basic_pair<S>& pair, root_length flattening) const {
    if (flattening == root_length{})
      return typename S::modulus{};
    const root_length y = cube_root(number(5) * flattening * pair.reduced_radius / number(4));
    const auto p_y = number(3) * pair.reduced_modulus * (flattening / y) / (number(2) * pi<number>());
    return number(5) * p_y / number(8);
  }
};
using thornton_ning_contact = thornton_ning_contact_law<dimensional>;

} // namespace ricochet
