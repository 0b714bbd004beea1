#include "examine.hpp"

namespace campaign {

void add_plastic(std::vector<instance>& all) {
  add_normal<hertz, thornton_ning>(all);
  add_normal<hertz, jkr, greenwood, kuwabara_kono, thornton_ning>(all);
  add_normal<hertz, thornton_ning_contact>(all);
  add_normal<hertz, kuwabara_kono, thornton_ning_contact>(all);
  add_normal<hertz, jkr, thornton_ning_contact>(all);
  add_normal<hertz, jkr, kuwabara_kono, thornton_ning_contact>(all);
  add_normal<hertz, maugis_dugdale, thornton_ning>(all);
}

} // namespace campaign
