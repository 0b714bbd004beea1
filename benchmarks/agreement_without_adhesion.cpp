#include "agreement.hpp"

void agreement::without_adhesion(report& to) {
  compare(instances::viscous_hertz(to.count), to);
  compare(instances::hunt_crossley_hertz(to.count), to);
  compare(instances::tsuji_hertz(to.count), to);
}
