#include "agreement.hpp"

void agreement::with_crack_law(report& to) {
  compare(instances::viscoelastic_jkr_fit(to.count), to);
  compare(instances::viscoelastic_jkr_exact(to.count), to);
}
