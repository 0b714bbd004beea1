#include "examine.hpp"

namespace campaign {

namespace {
template <class Adhesion>
void add_damped(std::vector<instance>& all) {
  add_normal_with_reference<hertz, Adhesion>(all);
  add_normal_with_reference<hertz, Adhesion, kuwabara_kono>(all);
  add_normal<hertz, Adhesion, hunt_crossley>(all);
  add_normal<hertz, Adhesion, tsuji>(all);
}
} // namespace

void add_adhesive(std::vector<instance>& all) {
  add_damped<jkr>(all);
  add_damped<dmt>(all);
  add_damped<line_force>(all);
  add_normal<hertz, maugis_dugdale>(all);
  add_normal<hertz, maugis_dugdale, kuwabara_kono>(all);
  add_normal<hertz, maugis_dugdale, hunt_crossley>(all);
  add_normal<hertz, maugis_dugdale, tsuji>(all);
}

} // namespace campaign
