#include "examine.hpp"

#include <ricochet/solve/stepper/radau.hpp>

namespace campaign {

namespace {
template <class Stepper>
void add_with(const char* name, std::vector<instance>& all) {
  const auto add = [&]<class... Laws>() {
    all.push_back({joined_names<Laws...>() + " by " + name, solve_normal<Stepper, Laws...>});
  };
  add.template operator()<hertz, kuwabara_kono>();
  add.template operator()<hertz, jkr, kuwabara_kono>();
  add.template operator()<hertz, line_force, hunt_crossley>();
  add.template operator()<hertz, jkr, greenwood, kuwabara_kono>();
}
} // namespace

void add_steppers(std::vector<instance>& all) {
  add_with<stepper::cash_karp54>("cash_karp54", all);
  add_with<stepper::dopri5>("dopri5", all);
  add_with<stepper::fehlberg78>("fehlberg78", all);
  add_with<stepper::runge_kutta4>("runge_kutta4", all);
  add_with<stepper::runge_kutta_gill>("runge_kutta_gill", all);
  add_with<stepper::bulirsch_stoer>("bulirsch_stoer", all);
  add_with<stepper::bulirsch_stoer_dense_out>("bulirsch_stoer_dense_out", all);
  add_with<stepper::radau<5>>("radau<5>", all);
}

} // namespace campaign
