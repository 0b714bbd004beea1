#pragma once
#include <ricochet/law/adhesion/attraction_law.hpp>
#include <ricochet/law/adhesion/cohesive_law.hpp>
#include <ricochet/law/end.hpp>
#include <ricochet/law/plasticity/flowing_law.hpp>
#include <ricochet/law/tangential/tangential_law.hpp>
#include <ricochet/model/requests.hpp>

namespace ricochet {

/// The physics of a scene: a pair of bodies and one law for each role that is there. Made by compose(); constant
/// thereafter, so that many threads may use one model.
template <class Elastic, class Adhesion, class Crack, class Damping, class Tangential, class Plasticity, class End,
          requests Asked>
struct contact_model {
  using end_condition = End;
  static constexpr requests asked = Asked;
  static constexpr bool cohesive = cohesive_law<Adhesion>; ///< adhesion is a force that makes the contact
  static constexpr bool attracted = attraction_law<Adhesion> || cohesive; ///< adhesion is a force
  static constexpr bool opposes_rebound = rebound_opposing_law<Adhesion>; ///< likewise, more so against a rebound
  static constexpr bool adhesive = is_present<Adhesion> && !attracted;    ///< adhesion is a work done at the edge
  static constexpr bool damped = is_present<Damping>;
  static constexpr bool has_crack_law = is_present<Crack>;
  static constexpr bool slides = sliding_law<Tangential>;              ///< as a whole, or else rolls
  static constexpr bool sticks_and_slips = stick_slip_law<Tangential>; ///< both at once, at different places
  static constexpr bool peels = peeling_law<Tangential>;               ///< what slides, resists being turned too
  static constexpr bool has_friction = slides || sticks_and_slips;
  static constexpr bool flows = flowing_law<Plasticity>;           ///< plastic flow is part of the motion
  static constexpr bool yields = is_present<Plasticity> && !flows; ///< its loss is added to that of the motion

  contact_pair pair;
  [[no_unique_address]] Elastic elastic;
  [[no_unique_address]] Adhesion adhesion;
  [[no_unique_address]] Crack crack;
  [[no_unique_address]] Damping damping;
  [[no_unique_address]] Tangential tangential;
  [[no_unique_address]] Plasticity plasticity;

  /// The same scene with the static edge: the limit of an infinitely fast crack.
  contact_model<Elastic, Adhesion, absent<role::crack>, Damping, Tangential, Plasticity, End, Asked>
  with_static_edge() const {
    return {pair, elastic, adhesion, {}, damping, tangential, plasticity};
  }

  /// The same scene without plastic flow.
  contact_model<Elastic, Adhesion, Crack, Damping, Tangential, absent<role::plasticity>, End, Asked>
  without_plasticity() const {
    return {pair, elastic, adhesion, crack, damping, tangential, {}};
  }

  /// Elastic force on the pair for one configuration, > 0 repulsive: for authors of codes with their own loop.
  force elastic_force(length approach, length radius) const {
    return elastic.force(pair, {approach, speed{}, radius, root(radius)});
  }

  /// Force by which an adhesion without an edge pulls, >= 0; to be taken from the elastic one.
  force attraction(length approach, length radius) const requires attraction_law<Adhesion> {
    return adhesion.attraction(pair, {approach, speed{}, radius, root(radius)});
  }

  /// Damping force for one configuration, > 0 where it opposes an approach.
  force damping_force(length approach, speed rate, length radius) const requires damped {
    return damping.coefficient(pair, {approach, rate, radius, root(radius)}) * rate;
  }

  /// Contact radius of the static edge at this approach (Hertzian without adhesion, the stable branch with it).
  length static_radius(length approach) const {
    if constexpr (cohesive) {
      const auto branch = adhesion.branch(pair, pair.reduced_radius);
      const double y = branch.y_at(approach);
      return branch.at(y, y >= 0).radius;
    } else if constexpr (adhesive)
      return adhesion.contact_radius(pair, approach);
    else
      return approach > length{} ? length(sqrt(approach * pair.reduced_radius)) : length{};
  }

private:
  static root_length root(length radius) { return boost::units::root<2>(radius); }
};

template <class Model>
using elastic_part = decltype(std::declval<Model>().without_plasticity());

} // namespace ricochet
