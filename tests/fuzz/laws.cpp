// Whatever numbers are given to bodies and laws: they are refused with a sentence, or every parameter of what is
// accepted is finite and within the range that its law states.
#include "harness.hpp"
#include "numbers.hpp"

#include <ricochet/ricochet.hpp>

#include <array>
#include <cmath>
#include <tuple>

namespace {

using namespace ricochet;
using fuzz::demand, fuzz::demand_sentence, fuzz::numbers;

template <class Quantity>
void demand_in_range(const std::string& name, const Quantity& x, const range& allowed) {
  demand(std::isfinite(in_si(x)) && allowed.contains(in_si(x)), name + " = " + shown(in_si(x)) + " was accepted");
}

template <class Law>
Law law_from(numbers& from) {
  Law law{};
  if constexpr (requires { Law::parameters(); })
    std::apply([&](const auto&... p) { (from.fill(law.*(p.member)), ...); }, Law::parameters());
  return law;
}

template <class Law>
void demand_valid(const Law& law) {
  if constexpr (requires { Law::parameters(); })
    std::apply([&](const auto&... p) { (demand_in_range(p.name, law.*(p.member), p.allowed), ...); },
               Law::parameters());
}

material material_from(numbers& from) {
  material solid{};
  from.fill(solid.youngs_modulus);
  from.fill(solid.poissons_ratio);
  from.fill(solid.mass_density);
  if (from.choice(2) == 0)
    from.fill(solid.surface_free_energy.emplace());
  return solid;
}

sphere sphere_from(numbers& from) {
  sphere body{material_from(from), {}};
  from.fill(body.radius);
  return body;
}

contact_pair pair_from(numbers& from) {
  const sphere body = sphere_from(from);
  const bool wall = from.choice(2) == 0;
  const contact_pair pair = wall ? between(body, flat_wall{material_from(from)}) : between(body, sphere_from(from));
  demand_in_range("reduced_modulus", pair.reduced_modulus, positive);
  demand_in_range("reduced_radius", pair.reduced_radius, positive);
  demand_in_range("reduced_mass", pair.reduced_mass, positive);
  demand_in_range("mass_1", pair.bodies.mass_1, positive);
  demand(wall == std::isinf(in_si(pair.bodies.radius_2)) && wall == std::isinf(in_si(pair.bodies.mass_2)),
         "a wall and nothing else is infinite");
  return pair;
}

template <class... Laws>
void compose_from(numbers& from) {
  const contact_pair pair = pair_from(from);
  const auto model = compose(pair, law_from<Laws>(from)...);
  demand_valid(model.elastic);
  demand_valid(model.adhesion);
  demand_valid(model.crack);
  demand_valid(model.damping);
  demand_valid(model.tangential);
  demand_valid(model.plasticity);
  speed v;
  from.fill(v);
  for (const std::string& warning : regime_of(model, v).warnings())
    demand_sentence(warning);
}

/// What makes a law's parameter from other numbers: within the law's range, or refused.
void derive_from(numbers& from) {
  const material one = material_from(from), other = material_from(from);
  duration time, other_time;
  from.fill(time);
  from.fill(other_time);
  double x = 0;
  from.fill(x);
  switch (from.choice(8)) {
  case 0:
    return demand_in_range("work_of_adhesion", work_of_adhesion(one, other), non_negative);
  case 1:
    return demand_in_range("stiffness_ratio", stiffness_ratio_of(one, other), stiffness_ratio_range);
  case 2:
    return demand_in_range("bulk_time", bulk_time_of_krijt(time, x), non_negative);
  case 3:
    return demand_in_range("bulk_time", bulk_time_of_three_element_solid(time, x), non_negative);
  case 4:
    return demand_in_range("bulk_time", bulk_time_of_pair(one, time, other, other_time), non_negative);
  case 5:
    return demand_in_range("damping_coefficient", closed_form::damping_coefficient_for(x), non_negative);
  case 6: {
    const auto spring = law_from<linear>(from);
    return demand_in_range("damping_coefficient", closed_form::damping_coefficient_of(x, pair_from(from), spring),
                           non_negative);
  }
  default: {
    speed v;
    from.fill(v);
    return demand_in_range("coefficient", closed_form::damping_coefficient_of_brach_dunn(x, pair_from(from), v),
                           non_negative);
  }
  }
}

constexpr std::array actions{derive_from,
                             compose_from<hertz>,
                             compose_from<linear, linear_dashpot>,
                             compose_from<hertz, jkr, kuwabara_kono>,
                             compose_from<hertz, jkr, greenwood>,
                             compose_from<hertz, jkr, greenwood_fit>,
                             compose_from<hertz, jkr, maugis_barquins>,
                             compose_from<hertz, dmt, hunt_crossley>,
                             compose_from<hertz, maugis_dugdale, tsuji>,
                             compose_from<hertz, line_force, coulomb>,
                             compose_from<hertz, line_force, coulomb_with_peeling>,
                             compose_from<hertz, mindlin>,
                             compose_from<hertz, thornton_ning>,
                             compose_from<hertz, jkr, thornton_ning_contact>};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  numbers from(bytes, size);
  try {
    actions[from.choice(actions.size())](from);
  } catch (const bad_input& refused) {
    demand_sentence(refused.what());
  }
  return 0;
}
