#pragma once
#include <ricochet/body/validate.hpp>

#include <optional>

namespace ricochet {

/// An isotropic linear elastic solid. youngs_modulus > 0, 0 <= poissons_ratio < 0.5, mass_density > 0.
/// surface_free_energy is that of ONE surface (J/m^2); laws take the work of adhesion of a pair, see
/// work_of_adhesion().
struct material {
  modulus youngs_modulus;
  double poissons_ratio = 0;
  density mass_density;
  std::optional<energy_per_area> surface_free_energy = std::nullopt;
};

/// \throws bad_input naming the first quantity outside its range; `whose` goes before its name.
inline void validate(const material& solid, const std::string& whose = "") {
  require(whose + "youngs_modulus", solid.youngs_modulus, positive);
  require(whose + "poissons_ratio", solid.poissons_ratio, poissons_ratio_range);
  require(whose + "density", solid.mass_density, positive);
  if (solid.surface_free_energy)
    require(whose + "surface_free_energy", *solid.surface_free_energy, non_negative);
}

/// Total work of adhesion of two solids, w = 2 sqrt(gamma_1 gamma_2): twice the surface free energy for like bodies
/// [Krijt 2013, footnote 8]. \throws bad_input if either surface free energy is unknown or negative, or the work too
/// large for a number.
inline energy_per_area work_of_adhesion(const material& one, const material& other) {
  if (!one.surface_free_energy || !other.surface_free_energy)
    throw bad_input("surface_free_energy of the material is not known: give the work of adhesion itself");
  require("first surface_free_energy", *one.surface_free_energy, non_negative);
  require("second surface_free_energy", *other.surface_free_energy, non_negative);
  return required("work_of_adhesion",
                  energy_per_area(2.0 * sqrt(*one.surface_free_energy * *other.surface_free_energy)), non_negative);
}

} // namespace ricochet
