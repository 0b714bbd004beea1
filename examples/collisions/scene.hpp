// One row's collision, ready to be solved.
#pragma once
#include <ricochet/body/pair.hpp>
#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/end.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

#include <cmath>
#include <variant>

namespace collisions {

using no_law = std::monostate;

/// A law for each role, or none; that they go together has been checked.
struct scene {
  ricochet::contact_pair pair{};
  ricochet::speed speed{}; ///< of the whole relative motion
  double angle = 0;        ///< between it and the normal, rad
  ricochet::angular_speed spin_1{}, spin_2{};
  std::variant<ricochet::hertz, ricochet::linear> elastic;
  std::variant<no_law, ricochet::jkr, ricochet::line_force, ricochet::dmt, ricochet::maugis_dugdale> adhesion;
  std::variant<no_law, ricochet::greenwood, ricochet::greenwood_fit, ricochet::maugis_barquins> crack;
  std::variant<no_law, ricochet::kuwabara_kono, ricochet::hunt_crossley, ricochet::tsuji, ricochet::linear_dashpot>
      damping;
  std::variant<no_law, ricochet::coulomb, ricochet::mindlin, ricochet::coulomb_with_peeling> tangential;
  std::variant<no_law, ricochet::thornton_ning, ricochet::thornton_ning_contact> plasticity;
  std::variant<no_law, ricochet::end_at_zero_overlap> end; ///< none: at zero force, the library's default

  ricochet::speed normal_speed() const { return std::cos(angle) * speed; }
};

} // namespace collisions
