// What each part of a scene costs where it is there, and that it costs nothing where it is not.
#include "zero_cost.hpp"

#include <cstdio>

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto scenes = zero_cost::draw(200);
  zero_cost::absent_parts(scenes[0]);
  zero_cost::present_parts(scenes);
}
