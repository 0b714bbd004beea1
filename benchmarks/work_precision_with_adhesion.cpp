#include "work_precision.hpp"

void work_precision::with_adhesion(std::size_t count) {
  scan_all(instances::brach_dunn(count));
  scan_all(instances::static_jkr(count));
  scan_all(instances::viscous_jkr(count));
}
