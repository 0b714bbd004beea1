// Materials of Krijt et al. 2013, J. Phys. D 46 435303, table 2: Young's modulus, Poisson's ratio, density and the
// surface free energy of one surface (the table's gamma_L).
#pragma once
#include <ricochet/body/material.hpp>

namespace ricochet::materials {

namespace detail {
constexpr material solid(double gigapascals, double poissons_ratio, double grams_per_cubic_centimetre, double gamma) {
  return {.youngs_modulus = gigapascals * units::gigapascals,
          .poissons_ratio = poissons_ratio,
          .mass_density = 1000 * grams_per_cubic_centimetre * units::kilograms_per_cubic_metre,
          .surface_free_energy = gamma * units::joules_per_square_metre};
}
} // namespace detail

inline constexpr material aluminium_alloy = detail::solid(70, 0.345, 2.7, 0.59);
inline constexpr material steel = detail::solid(190, 0.28, 7.92, 1.62);
inline constexpr material molybdenum = detail::solid(320, 0.33, 10.28, 2.81);
inline constexpr material quartz = detail::solid(54, 0.17, 2.6, 0.025);
inline constexpr material silicon = detail::solid(180, 0.33, 2.33, 1.42);
inline constexpr material mica = detail::solid(90, 0.33, 3.0, 0.77);
inline constexpr material copper = detail::solid(130, 0.34, 8.94, 1.11);
inline constexpr material silver_coated_glass = detail::solid(72, 0.21, 2.6, 0.61);
inline constexpr material polystyrene_latex = detail::solid(3.4, 0.33, 1.026, 0.025);
inline constexpr material tedlar = detail::solid(2, 0.33, 1.46, 0.018);
inline constexpr material acrylic = detail::solid(3, 0.35, 1.22, 0.02);
inline constexpr material lucite = detail::solid(2.6, 0.3, 1.18, 0.02);
inline constexpr material polyvinyl_toluene = detail::solid(3, 0.33, 1.2, 0.02);
inline constexpr material ammonium_fluorescein = detail::solid(1.17, 0.33, 1.35, 0.01);
inline constexpr material water_ice = detail::solid(7, 0.25, 1.0, 0.37);
/// The table gives 0.04 to 5 J/m^2 for ceramics, which is no value: its surface free energy stays unknown here.
inline constexpr material ceramics{.youngs_modulus = 370.0 * units::gigapascals,
                                   .poissons_ratio = 0.26,
                                   .mass_density = 3860.0 * units::kilograms_per_cubic_metre};

} // namespace ricochet::materials
