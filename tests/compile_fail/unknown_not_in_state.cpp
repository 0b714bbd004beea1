// expects: this contact model has no such unknown: no law in it needs it and nothing asked for it

#include "scene.hpp"

int main() {
  const state<double, variables<mutual_approach_t, approach_rate_t>> x{};
  return x[approach_rate] + x[contact_radius] > 0;
}
