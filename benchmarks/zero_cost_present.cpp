// What each part of a scene costs where it is there.
#include "zero_cost.hpp"

#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

#include <cstdio>

namespace zero_cost {
namespace {

/// A scene's collisions by integration, without a part and with it.
template <class Without, class With>
void part(const char* name, const char* base, const std::vector<drawn>& all, const Without& without, const With& with) {
  const auto models_of = [&](const auto& compose_scene) {
    std::vector<decltype(compose_scene(all[0]))> models;
    for (const auto& d : all)
      models.push_back(compose_scene(d));
    return models;
  };
  const auto bare = models_of(without);
  const auto whole = models_of(with);
  const auto run = [](const auto& models) {
    using model_type = std::remove_cvref_t<decltype(models[0])>;
    impact at{1 * metres_per_second};
    if constexpr (model_type::has_friction)
      at.slip = 0.5 * metres_per_second;
    double sum = 0;
    for (const auto& model : models)
      sum += integrate(model, at, {.tolerance = 1e-8}).restitution.value_or(0);
    measure::keep(sum);
  };
  const auto seconds = measure::least_seconds(15, {[&] { run(bare); }, [&] { run(whole); }});
  const auto unknowns = [](const auto& models) {
    using model_type = std::remove_cvref_t<decltype(models[0])>;
    return reduced_model<double, elastic_part<model_type>>::state_type::names::size;
  };
  std::printf("%-34s %-34s %9.2f %9.2f %7.2f %9zu %5zu\n", name, base, 1e6 * seconds[0] / double(all.size()),
              1e6 * seconds[1] / double(all.size()), seconds[1] / seconds[0], unknowns(bare), unknowns(whole));
}

} // namespace

void present_parts(const std::vector<drawn>& all) {
  std::printf(
      "\nPresent parts: microseconds for a collision by integrate() at a tolerance of 1e-8, without and with, and "
      "unknowns.\n%-34s %-34s %9s %9s %7s %9s %5s\n",
      "part", "added to", "without", "with", "ratio", "unknowns", "with");
  const auto viscous = [](const drawn& d) { return compose(d.pair, hertz{}, d.viscous); };
  const auto crossley = [](const drawn& d) { return compose(d.pair, hertz{}, d.crossley); };
  const auto adhesive = [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion); };
  const auto both = [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, d.viscous); };
  const auto with = [](auto... also) {
    return [=](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, d.viscous, also...); };
  };
  const char* base = "jkr, kuwabara_kono";
  part("damping: kuwabara_kono", "jkr", all, adhesive, both);
  part("adhesion: jkr", "kuwabara_kono", all, viscous, both);
  part("adhesion: line_force", "hunt_crossley", all, crossley,
       [](const drawn& d) { return compose(d.pair, hertz{}, d.crossley, d.ring); });
  part("crack: greenwood", base, all, both,
       [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, d.viscous, d.edge); });
  part("energy_ledger", base, all, both, with(energy_ledger{}));
  part(
      "energy_ledger", "jkr, kuwabara_kono, greenwood", all,
      [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, d.viscous, d.edge); },
      [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, d.viscous, d.edge, energy_ledger{}); });
  part("contact_duration", base, all, both, with(contact_duration{}));
  part("extremes", base, all, both, with(extremes{}));
  part("trajectory", base, all, both, with(trajectory{}));
  part("regime_warnings", base, all, both, with(regime_warnings{}));
  part("tangential: coulomb", "hunt_crossley", all, crossley,
       [](const drawn& d) { return compose(d.pair, hertz{}, d.crossley, coulomb{0.2}); });
  part("tangential: mindlin", "hunt_crossley", all, crossley, [](const drawn& d) {
    return compose(d.pair, hertz{}, d.crossley, mindlin{0.2, 0.85});
  });
  part("plasticity: thornton_ning", "jkr", all, adhesive,
       [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, thornton_ning{d.yield_strength}); });
  part("plasticity: thornton_ning_contact", "jkr", all, adhesive,
       [](const drawn& d) { return compose(d.pair, hertz{}, d.adhesion, thornton_ning_contact{d.yield_strength}); });
}

} // namespace zero_cost
