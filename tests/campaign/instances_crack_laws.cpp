#include "examine.hpp"

namespace campaign {

void add_crack_laws(std::vector<instance>& all) {
  add_normal_with_reference<hertz, jkr, greenwood>(all);
  add_normal_with_reference<hertz, jkr, greenwood, kuwabara_kono>(all);
  add_normal<hertz, jkr, greenwood, hunt_crossley>(all);
  add_normal<hertz, jkr, greenwood, tsuji>(all);
  add_normal<hertz, jkr, greenwood_fit>(all);
  add_normal<hertz, jkr, greenwood_fit, kuwabara_kono>(all);
  add_normal<hertz, jkr, maugis_barquins>(all);
  add_normal<hertz, jkr, maugis_barquins, kuwabara_kono>(all);
}

} // namespace campaign
