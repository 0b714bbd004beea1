#pragma once
#include <ricochet/law/tangential/tangential_law.hpp>

namespace ricochet {

/// Coulomb friction: a contact slides or rolls.
/// F_t = -f F_E slip/|slip| while it slides, 0 once it rolls; F_E is the elastic force where it presses, else 0
/// friction_coefficient: f, >= 0.
/// Valid where the contact slips as a whole: no creep before sliding. Adhesion and damping do not press.
/// Source: Brach & Dunn 1995, appendix B; coulomb_with_peeling has their peeling moment too.
template <class S>
struct coulomb_law {
  using role = role::tangential;
  using number = typename S::number;
  number friction_coefficient{};

  template <class Other>
  using in = coulomb_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"friction_coefficient", &coulomb_law::friction_coefficient, non_negative}};
  }

  typename S::force sliding_force(typename S::force elastic_force) const {
    using result = typename S::force;
    return select<result>(
        elastic_force > result{}, [&] { return result(friction_coefficient * elastic_force); },
        [] { return result{}; });
  }
};
using coulomb = coulomb_law<dimensional>;

} // namespace ricochet
