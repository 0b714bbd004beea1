// Which laws go together: one predicate and one table.
#pragma once
#include <ricochet/law/adhesion/adhesion_law.hpp>
#include <ricochet/law/adhesion/attraction_law.hpp>
#include <ricochet/law/adhesion/cohesive_law.hpp>
#include <ricochet/law/crack/crack_velocity_law.hpp>
#include <ricochet/law/damping/bulk_damping_law.hpp>
#include <ricochet/law/elastic/elastic_law.hpp>
#include <ricochet/law/plasticity/flowing_law.hpp>
#include <ricochet/law/plasticity/plasticity_law.hpp>
#include <ricochet/law/tangential/tangential_law.hpp>

#include <string_view>

namespace ricochet {

/// How many laws of each role a composition names; `attraction` of the adhesion laws are forces without an edge, `flow`
/// of the plasticity laws act within the motion, `stick_slip` of the tangential ones stick and slip at once, `peeling`
/// of them resist rolling; `rebounding` of the adhesion laws can be peeled, `edgeless` of the elastic ones have an
/// energy that does not depend on the contact radius, `cohesion` of the adhesion laws forces of a range of their own.
struct role_count {
  int elastic = 0, adhesion = 0, crack = 0, damping = 0, end = 0, attraction = 0, tangential = 0, plasticity = 0,
      flow = 0, stick_slip = 0, peeling = 0, rebounding = 0, edgeless = 0, cohesion = 0;
};

/// Empty if laws in these numbers go together, else the sentence of refusal.
constexpr std::string_view refusal(const role_count& n) {
  if (n.elastic == 0)
    return "a contact model needs an elastic law: add hertz";
  if (n.elastic > 1)
    return "two elastic laws were given: keep one";
  if (n.adhesion > 1)
    return "two adhesion laws were given: keep one";
  if (n.crack > 1)
    return "two crack-velocity laws were given: keep one";
  if (n.damping > 1)
    return "two bulk damping laws were given: keep one";
  if (n.tangential > 1)
    return "two tangential laws were given: keep one";
  if (n.plasticity > 1)
    return "two plasticity laws were given: keep one";
  if (n.plasticity == 1 && n.tangential == 1)
    return "plastic flow is added to the normal motion only: drop the tangential law or the plasticity law";
  if (n.flow == 1 && n.crack == 1)
    return "plastic flow within the motion goes with a static edge: drop the crack-velocity law or take thornton_ning";
  if (n.cohesion == 1 && n.tangential == 1)
    return "a contact with a cohesive zone moves along its normal only: drop the tangential law or take jkr or dmt";
  if (n.flow == 1 && n.attraction + n.cohesion == 1)
    return "plastic flow within the motion goes with an adhesion law with a surface energy: take jkr or thornton_ning";
  if (n.stick_slip == 1 && n.adhesion != n.attraction)
    return "a tangential law with stick and slip needs a Hertzian contact: drop the adhesion law or take coulomb";
  if (n.peeling == 1 && n.rebounding == 0)
    return "a peeling moment needs an adhesion law with a rebound coefficient: add line_force or take coulomb";
  if (n.end > 1)
    return "two end conditions were given: keep one";
  if (n.crack == 1 && n.adhesion == n.attraction + n.cohesion)
    return "a crack-velocity law needs an adhesion law with a surface energy: add jkr";
  if (n.edgeless == 1 && n.adhesion > n.attraction)
    return "an adhesion law with a surface energy needs an elastic law with an edge: take hertz, or dmt or line_force";
  if (n.edgeless == 1 && n.stick_slip == 1)
    return "stick and slip is that of a Hertzian contact: take hertz or coulomb";
  if (n.edgeless == 1 && n.plasticity == 1)
    return "plastic flow is added to Hertzian contacts only: drop the plasticity law or take hertz";
  if (n.end == 1 && n.adhesion == 1)
    return "an end condition is only for contacts without adhesion: with adhesion the contact lets go where it tears";
  return "";
}

template <class... Laws>
constexpr role_count count_roles() {
  return {.elastic = (int(plays<Laws, role::elastic>) + ... + 0),
          .adhesion = (int(plays<Laws, role::adhesion>) + ... + 0),
          .crack = (int(plays<Laws, role::crack>) + ... + 0),
          .damping = (int(plays<Laws, role::damping>) + ... + 0),
          .end = (int(plays<Laws, role::end>) + ... + 0),
          .attraction = (int(attraction_law<Laws>) + ... + 0),
          .tangential = (int(plays<Laws, role::tangential>) + ... + 0),
          .plasticity = (int(plays<Laws, role::plasticity>) + ... + 0),
          .flow = (int(flowing_law<Laws>) + ... + 0),
          .stick_slip = (int(stick_slip_law<Laws>) + ... + 0),
          .peeling = (int(peeling_law<Laws>) + ... + 0),
          .rebounding = (int(rebounding_law<Laws>) + ... + 0),
          .edgeless = (int(is_edgeless<Laws>) + ... + 0),
          .cohesion = (int(cohesive_law<Laws>) + ... + 0)};
}

/// Can these laws be composed?
template <class... Laws>
inline constexpr bool composable = (has_role<Laws> && ...) && refusal(count_roles<Laws...>()).empty();

} // namespace ricochet
