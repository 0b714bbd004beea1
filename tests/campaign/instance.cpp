#include "examine.hpp"

namespace campaign {

std::vector<instance> all_instances() {
  std::vector<instance> all;
  add_hertzian(all);
  add_adhesive(all);
  add_crack_laws(all);
  add_plastic(all);
  add_oblique(all);
  add_steppers(all);
  return all;
}

} // namespace campaign
