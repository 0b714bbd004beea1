#include "examine.hpp"

namespace campaign {

std::shared_ptr<const greenwood_table> table_for(double modulus_ratio) {
  static std::mutex guard;
  static std::map<double, std::shared_ptr<const greenwood_table>> tables;
  const std::lock_guard lock(guard);
  auto& table = tables[modulus_ratio];
  if (!table)
    table = std::make_shared<const greenwood_table>(modulus_ratio);
  return table;
}

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
