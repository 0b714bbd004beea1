#pragma once
#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/law/plasticity/plasticity_law.hpp>

namespace ricochet {

/// Thornton & Ning: the pressure in the contact is cut off at that of first yield.
/// loss = 1 - e_P^2(v_y/v), none up to the yield speed v_y (closed_form/thornton_ning.hpp)
/// yield_strength: Y of the weaker body, Pa, > 0; of a small body, closed_form::yield_strength() gives it.
/// Valid where plastic flow hardly changes the other losses: they are added, and the motion in the outcome is elastic.
/// Source: Krijt 2013 (28)-(30) after Thornton & Ning 1998.
template <class S>
struct thornton_ning_law {
  using role = role::plasticity;
  typename S::modulus yield_strength{};

  template <class Other>
  using in = thornton_ning_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"yield_strength", &thornton_ning_law::yield_strength, positive}};
  }

  double loss(const contact_pair& pair, speed v) const {
    return closed_form::plastic_loss(closed_form::yield_speed(pair, yield_strength), v);
  }
};
using thornton_ning = thornton_ning_law<dimensional>;

} // namespace ricochet
