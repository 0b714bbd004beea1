// The laws of many collisions side by side: each lane has its own bodies, parameters and scales.
#pragma once
#include <ricochet/batch/lane_table.hpp>
#include <ricochet/model/reduced_model.hpp>

namespace ricochet {

/// One lane gets the numbers of these laws.
template <class Lanes, class Model>
void put_lane(reduced_laws<Lanes, Model>& to, std::size_t lane, const reduced_laws<double, Model>& from) {
  to.pair.reduced_modulus.put(lane, from.pair.reduced_modulus);
  to.pair.reduced_radius.put(lane, from.pair.reduced_radius);
  to.pair.reduced_mass.put(lane, from.pair.reduced_mass);
  to.for_each_law(from, [&](auto& law, const auto& source) {
    for_each_parameter(law, source, [&](auto& parameter, const auto& x) { parameter.put(lane, x); });
    if constexpr (requires { law.table.put(lane, *source.table); })
      law.table.put(lane, *source.table);
  });
}

/// Laws in SI in the scales of their collisions; of `model` only the quantities' dimensions count.
template <class Lanes, class Model>
reduced_laws<Lanes, Model> in_scales(reduced_laws<Lanes, Model> laws, const Model& model,
                                     const basic_scales<Lanes>& unit) {
  const auto scale = [&](auto& number, const auto& quantity) { number = Lanes(number) / unit.factor(quantity); };
  scale(laws.pair.reduced_modulus, model.pair.reduced_modulus);
  scale(laws.pair.reduced_radius, model.pair.reduced_radius);
  scale(laws.pair.reduced_mass, model.pair.reduced_mass);
  laws.for_each_law(model, [&](auto& law, const auto& source) { for_each_parameter(law, source, scale); });
  return laws;
}

} // namespace ricochet
