#include "examine.hpp"

namespace campaign {

/// Not mindlin with dmt: a slow impact takes 1e5 steps, and each of them moves all springs.
void add_oblique(std::vector<instance>& all) {
  add_oblique<hertz, coulomb>(all);
  add_oblique<hertz, kuwabara_kono, coulomb>(all);
  add_oblique<hertz, tsuji, end_at_zero_overlap, coulomb>(all);
  add_oblique<linear, linear_dashpot, coulomb>(all);
  add_oblique<hertz, jkr, kuwabara_kono, coulomb>(all);
  add_oblique<hertz, jkr, greenwood, kuwabara_kono, coulomb>(all);
  add_oblique<hertz, jkr, maugis_barquins, coulomb>(all);
  add_oblique<hertz, dmt, hunt_crossley, coulomb>(all);
  add_oblique<hertz, line_force, hunt_crossley, coulomb>(all);
  add_oblique<hertz, line_force, hunt_crossley, coulomb_with_peeling>(all);
  add_oblique<hertz, mindlin>(all);
  add_oblique<hertz, tsuji, mindlin>(all);
}

} // namespace campaign
