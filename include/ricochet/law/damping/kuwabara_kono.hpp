#pragma once
#include <ricochet/law/damping/bulk_damping_law.hpp>

namespace ricochet {

/// Viscous bulk of Kuwabara & Kono (also Brilliantov et al.): dissipative stress proportional to the elastic stress
/// rate. F_D = 2 A E* a d(delta)/dt bulk_time: A, s, >= 0; a parameter of the pair, see the functions below for the
/// ways it is chosen. Valid while A is short against the contact time. Source: Krijt 2013 (18), (19).
template <class S>
struct kuwabara_kono_law {
  using role = role::damping;
  using number = typename S::number;
  typename S::duration bulk_time{};

  template <class Other>
  using in = kuwabara_kono_law<Other>;
  static constexpr auto parameters() {
    return std::tuple{parameter{"bulk_time", &kuwabara_kono_law::bulk_time, non_negative}};
  }

  typename S::damping coefficient(const basic_pair<S>& pair, const configuration<S>& c) const {
    return number(2) * bulk_time * pair.reduced_modulus * c.radius;
  }
};
using kuwabara_kono = kuwabara_kono_law<dimensional>;

/// A = T_vis/nu^2, the estimate of Krijt 2013 after (18). It diverges for nu -> 0.
/// \throws bad_input unless relaxation_time >= 0 and 0 < poissons_ratio < 0.5.
inline duration bulk_time_of_krijt(duration relaxation_time, double poissons_ratio) {
  require("relaxation_time", relaxation_time, non_negative);
  require("poissons_ratio", poissons_ratio, range{.high = 0.5, .low_included = false});
  return required("bulk_time", duration(relaxation_time / square(poissons_ratio)), non_negative);
}

/// A = (1-k) T_vis, the slow limit of the three-element solid whose edge law `greenwood` is.
/// \throws bad_input unless relaxation_time >= 0 and k in [1e-4, 0.98].
inline duration bulk_time_of_three_element_solid(duration relaxation_time, double modulus_ratio) {
  require("relaxation_time", relaxation_time, non_negative);
  require("modulus_ratio", modulus_ratio, modulus_ratio_range);
  return (1 - modulus_ratio) * relaxation_time;
}

/// A of a pair of unlike bodies, weighted by their compliances C_i = (1-nu_i^2)/E_i: A = sum C_i A_i/sum C_i.
/// \throws bad_input naming the first quantity outside its range.
inline duration bulk_time_of_pair(const material& one, duration time_of_one, const material& other,
                                  duration time_of_other) {
  validate(one, "first material: ");
  validate(other, "second material: ");
  require("first bulk_time", time_of_one, non_negative);
  require("second bulk_time", time_of_other, non_negative);
  const auto first = detail::compliance(one), second = detail::compliance(other);
  return required("bulk_time", duration((first * time_of_one + second * time_of_other) / (first + second)),
                  non_negative);
}

} // namespace ricochet
