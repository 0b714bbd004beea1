#include "work_precision.hpp"

void work_precision::with_crack_law(std::size_t count) {
  scan_all(instances::viscoelastic_jkr_fit(count));
  scan_all(instances::viscoelastic_jkr_exact(count));
}
