#include "agreement.hpp"

void agreement::with_adhesion(report& to) {
  compare(instances::static_jkr(to.count), to);
  compare(instances::brach_dunn(to.count), to);
  compare(instances::viscous_jkr(to.count), to);
}
