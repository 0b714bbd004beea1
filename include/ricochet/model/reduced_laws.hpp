#pragma once
#include <ricochet/model/contact_model.hpp>

namespace ricochet {

/// The laws of a contact model on plain numbers T in the scales of a collision: forces and energies of a configuration.
template <class T, class Model>
class reduced_laws {
  template <class Law>
  using in_numbers = typename Law::template in<reduced<T>>;
  using elastic_type = in_numbers<decltype(Model::elastic)>;
  using adhesion_type = in_numbers<decltype(Model::adhesion)>;
  using crack_type = in_numbers<decltype(Model::crack)>;
  using damping_type = in_numbers<decltype(Model::damping)>;
  using tangential_type = in_numbers<decltype(Model::tangential)>;
  using plasticity_type = in_numbers<decltype(Model::plasticity)>;

public:
  using number = T;
  using model_type = Model;
  static constexpr bool adhesive = Model::adhesive;
  static constexpr bool attracted = Model::attracted;
  static constexpr bool cohesive = Model::cohesive;
  static constexpr bool opposes_rebound = Model::opposes_rebound;
  static constexpr bool damped = Model::damped;
  static constexpr bool free_edge = Model::has_crack_law;
  static constexpr bool slides = Model::slides;
  static constexpr bool peels = Model::peels;
  static constexpr bool flows = Model::flows;
  using part =
      std::conditional_t<flows, flattened_configuration<reduced<T>>,
                         std::conditional_t<cohesive, cohesive_configuration<reduced<T>>, configuration<reduced<T>>>>;
  static constexpr bool sticks_and_slips = Model::sticks_and_slips;

  basic_pair<reduced<T>> pair;
  [[no_unique_address]] elastic_type elastic;
  [[no_unique_address]] adhesion_type adhesion;
  [[no_unique_address]] crack_type crack;
  [[no_unique_address]] damping_type damping;
  [[no_unique_address]] tangential_type tangential;
  [[no_unique_address]] plasticity_type plasticity;

  /// Every number of the source, which is a model or its laws in another scalar type, passed through `convert`.
  template <class Source, class Convert>
  reduced_laws(const Source& source, const Convert& convert)
      : pair{convert(source.pair.reduced_modulus), convert(source.pair.reduced_radius),
             convert(source.pair.reduced_mass)},
        elastic(rebind_law<reduced<T>>(source.elastic, convert)),
        adhesion(rebind_law<reduced<T>>(source.adhesion, convert)),
        crack(rebind_law<reduced<T>>(source.crack, convert)), damping(rebind_law<reduced<T>>(source.damping, convert)),
        tangential(rebind_law<reduced<T>>(source.tangential, convert)),
        plasticity(rebind_law<reduced<T>>(source.plasticity, convert)) {}

  /// The pair as the contact has it: flattened where plastic flow has been.
  const basic_pair<reduced<T>>& pair_of([[maybe_unused]] const part& c) const {
    if constexpr (flows)
      return c.pair;
    else
      return pair;
  }

  /// Approach of the bodies: that of the contact, and the residual one of a flattened contact.
  T whole_approach(const part& c) const {
    if constexpr (flows)
      return c.approach + c.shape.residual_approach;
    else
      return c.approach;
  }

  /// f(law, its like in `other`) for every law; `other` is a model or its laws in another scalar type.
  template <class Other, class Function>
  void for_each_law(const Other& other, const Function& f) {
    f(elastic, other.elastic);
    f(adhesion, other.adhesion);
    f(crack, other.crack);
    f(damping, other.damping);
    f(tangential, other.tangential);
    f(plasticity, other.plasticity);
  }

  /// Scales of an impact at this speed, of laws in SI.
  basic_scales<T> scales_at(const T& v) const {
    T w = T(0);
    if constexpr (adhesive)
      w = adhesion.work_of_adhesion;
    else if constexpr (attracted)
      w = adhesion.equivalent_work_of_adhesion(pair);
    if constexpr (requires { elastic.scales_of_impact(pair, v, w); })
      return elastic.scales_of_impact(pair, v, w);
    else
      return scales_of<T>(pair, v, w);
  }

  /// Force of the bulk damping law.
  T damping_force(const part& c) const {
    if constexpr (damped)
      return damping.coefficient(pair_of(c), c) * c.rate;
    else
      return T(0);
  }

  /// Force by which an attraction opposes the rebound.
  T rebound_force(const part& c) const {
    if constexpr (opposes_rebound)
      return adhesion.rebound_damping(pair, c) * c.rate;
    else
      return T(0);
  }

  /// Force that derives from potential(), > 0 repulsive.
  T static_force(const part& c) const {
    if constexpr (attracted)
      return elastic.force(pair, c) - adhesion.attraction(pair, c);
    else
      return elastic.force(pair_of(c), c);
  }

  /// Force between the bodies, > 0 repulsive.
  T total_force(const part& c) const {
    T force = static_force(c);
    if constexpr (damped) // not even a term of zero where there is no law: x + 0. may not be left out
      force += damping_force(c);
    if constexpr (opposes_rebound)
      force += rebound_force(c);
    return force;
  }

  T kinetic_energy(const T& rate) const { return pair.reduced_mass * rate * rate / T(2); }

  T surface_energy(const part& c) const {
    if constexpr (adhesive)
      return adhesion.surface_energy(c.radius);
    else if constexpr (attracted)
      return adhesion.potential_energy(pair, c);
    else
      return T(0);
  }

  /// U_E + U_S.
  T potential(const part& c) const { return elastic.stored_energy(pair_of(c), c) + surface_energy(c); }
};

/// The laws of a model in SI, as plain numbers.
template <class T, class Model>
reduced_laws<T, Model> laws_in_si(const Model& model) {
  return {model, [](const auto& quantity) { return T(in_si(quantity)); }};
}

/// Scales in which an impact at this speed is computed.
template <class Model>
scales scales_at(const Model& model, speed v) {
  return laws_in_si<double>(model).scales_at(in_si(v));
}

} // namespace ricochet
