#include "work_precision.hpp"

void work_precision::without_adhesion(std::size_t count) {
  scan_all(instances::viscous_hertz(count));
  scan_all(instances::hunt_crossley_hertz(count));
  scan_all(instances::tsuji_hertz(count));
}
