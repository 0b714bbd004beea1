#pragma once
#include <ricochet/law/crack/greenwood.hpp>

#include <map>
#include <memory>
#include <mutex>

namespace support {

/// The table of this k, made where it is first asked for; from any thread.
inline std::shared_ptr<const ricochet::greenwood_table> greenwood_table_for(double modulus_ratio) {
  static std::mutex guard;
  static std::map<double, std::shared_ptr<const ricochet::greenwood_table>> tables;
  const std::lock_guard lock(guard);
  auto& table = tables[modulus_ratio];
  if (!table)
    table = std::make_shared<const ricochet::greenwood_table>(modulus_ratio);
  return table;
}

} // namespace support
