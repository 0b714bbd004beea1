// The same pairs in LIGGGHTS: Hertz with the damping of Tsuji, given by the restitution wanted, as its manual has it.
#pragma once
#include "peer_lammps.hpp"

#include <algorithm>

namespace peer {

/// `restitution` wanted of the kinds; LIGGGHTS takes a Young's modulus and Poisson's ratio.
inline discrete_elements_result liggghts(const pairs_of_spheres& pairs, const std::vector<double>& restitution,
                                         double steps_per_contact) {
  const double nu = 0.25, youngs_modulus = 2 * (1 - nu * nu) * pairs.reduced_modulus;
  const std::size_t kinds = restitution.size();
  std::ostringstream commands;
  commands.precision(17);
  auto property = [&, fix = 0](const std::string& what, std::size_t numbers, const auto& number) mutable {
    commands << "fix m" << ++fix << " all property/global " << what;
    for (std::size_t i = 0; i < numbers; ++i)
      commands << ' ' << number(i);
    commands << '\n';
  };
  commands << "units si\natom_style granular\natom_modify map array\nboundary p p p\nnewton off\n"
              "communicate single vel yes\nread_data data\n";
  property("youngsModulus peratomtype", kinds, [&](std::size_t) { return youngs_modulus; });
  property("poissonsRatio peratomtype", kinds, [&](std::size_t) { return nu; });
  property("coefficientRestitution peratomtypepair " + std::to_string(kinds), kinds * kinds,
           [&](std::size_t i) { return restitution[std::min(i % kinds, i / kinds)]; });
  commands << "pair_style gran model hertz tangential off\npair_coeff * *\nneighbor " << pairs.radius
           << " bin\nfix integrate all nve/sphere\nthermo 1000000\nthermo_modify lost ignore\n";
  return discrete_elements_run(pairs)("liggghts", commands.str(), steps_per_contact, "format");
}

} // namespace peer
