#include "support/compositions.hpp"

#include "support/greenwood_tables.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>

#include <array>
#include <stdexcept>

namespace support {

namespace {

template <class Outcome>
summary summarised(const Outcome& out) {
  summary s{.ending = out.ending,
            .restitution = out.restitution.value_or(0),
            .error_estimate = out.error_estimate,
            .certain = out.ending_is_certain,
            .duration = 0,
            .crack_loss = 0,
            .bulk_loss = 0,
            .plastic_loss = 0};
  if constexpr (requires { out.crack_loss; })
    s.crack_loss = out.crack_loss, s.bulk_loss = out.bulk_loss, s.duration = in_si(out.contact_duration);
  if constexpr (requires { out.plastic_loss; })
    s.plastic_loss = out.plastic_loss;
  return s;
}

/// `Compose` makes the model of a scene and requests.
template <class Compose>
composition named(const char* name, Compose) {
  return {name,
          [](const scene& s, double tolerance) {
            return summarised(integrate(Compose{}(s, energy_ledger{}, contact_duration{}), impact{s.speed},
                                        {.tolerance = tolerance}));
          },
          [](const scene& s, double tolerance) {
            return summarised(collide(Compose{}(s), impact{s.speed}, {.tolerance = tolerance}));
          }};
}

/// Every bulk damping law beside the laws given by `Laws`.
template <class Laws>
void add_damped(std::vector<composition>& all, const std::array<const char*, 4>& names, Laws) {
  all.push_back(named(names[0], [](const scene& s, auto... also) { return Laws{}(s, also...); }));
  all.push_back(
      named(names[1], [](const scene& s, auto... also) { return Laws{}(s, kuwabara_kono{s.bulk_time}, also...); }));
  all.push_back(named(names[2], [](const scene& s, auto... also) {
    return Laws{}(s, hunt_crossley{s.hunt_crossley_coefficient}, also...);
  }));
  all.push_back(
      named(names[3], [](const scene& s, auto... also) { return Laws{}(s, tsuji{s.tsuji_coefficient}, also...); }));
}

std::vector<composition> list() {
  std::vector<composition> all;
  add_damped(all, {"hertz", "hertz+kuwabara_kono", "hertz+hunt_crossley", "hertz+tsuji"},
             [](const scene& s, auto... also) { return hertzian(s, also...); });
  add_damped(all, {"jkr", "jkr+kuwabara_kono", "jkr+hunt_crossley", "jkr+tsuji"},
             [](const scene& s, auto... also) { return static_jkr(s, also...); });
  add_damped(all, {"dmt", "dmt+kuwabara_kono", "dmt+hunt_crossley", "dmt+tsuji"},
             [](const scene& s, auto... also) { return hertzian(s, dmt{s.work_of_adhesion}, also...); });
  add_damped(all, {"line_force", "line_force+kuwabara_kono", "line_force+hunt_crossley", "line_force+tsuji"},
             [](const scene& s, auto... also) {
               return hertzian(s, line_force{s.force_per_length, s.rebound_coefficient}, also...);
             });
  add_damped(all,
             {"maugis_dugdale", "maugis_dugdale+kuwabara_kono", "maugis_dugdale+hunt_crossley", "maugis_dugdale+tsuji"},
             [](const scene& s, auto... also) {
               return hertzian(s, maugis_dugdale{s.work_of_adhesion, s.interaction_range}, also...);
             });
  all.push_back(named("hertz+end_at_zero_overlap",
                      [](const scene& s, auto... also) { return hertzian(s, end_at_zero_overlap{}, also...); }));
  all.push_back(named("hertz+kuwabara_kono+end_at_zero_overlap",
                      [](const scene& s, auto... also) { return viscous_hertz(s, end_at_zero_overlap{}, also...); }));
  all.push_back(named("hertz+hunt_crossley+end_at_zero_overlap", [](const scene& s, auto... also) {
    return hunt_crossley_hertz(s, end_at_zero_overlap{}, also...);
  }));
  all.push_back(named("hertz+tsuji+end_at_zero_overlap",
                      [](const scene& s, auto... also) { return tsuji_hertz(s, end_at_zero_overlap{}, also...); }));
  all.push_back(named("greenwood", [](const scene& s, auto... also) { return static_jkr(s, edge(s), also...); }));
  all.push_back(
      named("greenwood+kuwabara_kono", [](const scene& s, auto... also) { return viscous_jkr(s, edge(s), also...); }));
  all.push_back(named("greenwood_fit+kuwabara_kono",
                      [](const scene& s, auto... also) { return viscoelastic_jkr_fit(s, also...); }));
  all.push_back(
      named("maugis_barquins+kuwabara_kono", [](const scene& s, auto... also) { return power_law_jkr(s, also...); }));
  all.push_back(named("jkr+thornton_ning", [](const scene& s, auto... also) {
    return static_jkr(s, thornton_ning{s.yield_strength}, also...);
  }));
  all.push_back(named("hertz+thornton_ning_contact", [](const scene& s, auto... also) {
    return hertzian(s, thornton_ning_contact{s.yield_strength}, also...);
  }));
  all.push_back(named("jkr+thornton_ning_contact", [](const scene& s, auto... also) {
    return static_jkr(s, thornton_ning_contact{s.yield_strength}, also...);
  }));
  all.push_back(named("jkr+kuwabara_kono+thornton_ning_contact", [](const scene& s, auto... also) {
    return viscous_jkr(s, thornton_ning_contact{s.yield_strength}, also...);
  }));
  return all;
}

} // namespace

greenwood edge(const scene& s) {
  return {.relaxation_time = s.relaxation_time,
          .modulus_ratio = s.modulus_ratio,
          .interaction_range = s.interaction_range,
          .table = greenwood_table_for(s.modulus_ratio)};
}

const std::vector<composition>& compositions() {
  static const std::vector<composition> all = list();
  return all;
}

const composition& composed_of(const std::string& name) {
  for (const composition& c : compositions())
    if (name == c.name)
      return c;
  throw std::out_of_range("no composition " + name);
}

} // namespace support
