#include "examine.hpp"

namespace campaign {

void add_hertzian(std::vector<instance>& all) {
  add_normal_with_reference<hertz>(all);
  add_normal_with_reference<hertz, kuwabara_kono>(all);
  add_normal<hertz, kuwabara_kono, end_at_zero_overlap>(all);
  add_normal_with_reference<hertz, hunt_crossley>(all);
  add_normal<hertz, hunt_crossley, end_at_zero_overlap>(all);
  add_normal_with_reference<hertz, tsuji>(all);
  add_normal<hertz, tsuji, end_at_zero_overlap>(all);
  add_normal<linear>(all);
  add_normal<linear, linear_dashpot>(all);
  add_normal<linear, linear_dashpot, end_at_zero_overlap>(all);
}

} // namespace campaign
