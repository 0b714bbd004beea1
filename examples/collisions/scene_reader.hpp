// Row -> scene: the laws that the column `model` names and the quantities that they need.
#pragma once
#include "row.hpp"
#include "scene.hpp"

#include <map>
#include <memory>

namespace collisions {

/// All law names, for messages and help.
std::string known_laws();

class scene_reader {
public:
  /// \throws row_error naming the first column at fault; what the row's model does not need is not looked at.
  scene read(const row& row);

private:
  std::shared_ptr<const ricochet::greenwood_table> table_for(double modulus_ratio);

  std::map<double, std::shared_ptr<const ricochet::greenwood_table>> tables_; ///< by modulus ratio; 9 ms each to make
};

} // namespace collisions
