// Adhesion between the limits of JKR and DMT: equilibria and quasi-static impact.
#pragma once
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <optional>

#include <boost/math/tools/minima.hpp>

namespace ricochet::closed_form {

/// Contact of a pair under Maugis & Dugdale's adhesion, without other losses; what is not said here, the law says.
class maugis_dugdale_contact {
public:
  /// \throws bad_input where the law is refused by compose().
  maugis_dugdale_contact(const contact_pair& pair, const ricochet::maugis_dugdale& law) : pair_(pair), law_(law) {
    validate(pair);
    validate_law(law);
    law.validate(pair);
    branch_ = law.branch(pair, ricochet::sqrt(pair.reduced_radius * law.interaction_range));
  }

  struct equilibrium {
    length contact_radius, cohesive_radius, approach;
    force load; ///< > 0 repulsive
  };

  /// Largest tension, between 2 pi w R (DMT) and 1.5 pi w R (JKR).
  force pull_off_force() const {
    const double from = branch_.at(branch_.y_at({}), true).angle; // where it is large, t is small
    const auto load = [&](double log_t) { return in_si(load_at(branch_.ring(1 / std::tan(std::exp(log_t))))); };
    const double to = std::log(pi<double>() / 2);
    return -std::min(boost::math::tools::brent_find_minima(load, std::log(from), to, 50).second, load(to)) *
           units::newtons;
  }

  /// The stable equilibrium at this approach; nothing where the bodies have jumped apart.
  std::optional<equilibrium> at(length approach) const {
    if (approach < jump_out().approach)
      return std::nullopt;
    return equilibrium_at(branch_.y_at(approach));
  }

  /// Where the bodies jump together, -z0, and the equilibrium from which they jump apart, at the least approach.
  length approach_of_jump_in() const { return -law_.interaction_range; }
  equilibrium jump_out() const { return equilibrium_at(branch_.fold()); }

  /// Lost in one contact without other losses: the area between the paths in and out.
  energy hysteresis() const { return potential(branch_.fold()) - potential(branch_.first()); }

  /// Largest speed of impact at which the bodies stay together.
  speed sticking_speed() const { return ricochet::sqrt(2.0 * hysteresis() / pair_.reduced_mass); }

  /// Restitution of an impact at speed v, or nothing if the bodies stay together.
  std::optional<double> restitution(speed v) const {
    require("speed", v, positive);
    const double ratio = sticking_speed() / v;
    return ratio < 1 ? std::optional(std::sqrt((1 - ratio) * (1 + ratio))) : std::nullopt;
  }

private:
  using branch = dugdale_branch<dimensional>;

  static cohesive_configuration<dimensional> configure(const branch::point& p) {
    return {{p.approach, speed{}, p.radius, ricochet::sqrt(p.radius)}, p.cohesive_radius, p.angle};
  }
  force load_at(const branch::point& p) const {
    const auto c = configure(p);
    return hertz::force(pair_, c) - law_.attraction(pair_, c);
  }
  equilibrium equilibrium_at(double y) const {
    const auto p = branch_.at(y, y >= 0);
    return {p.radius, p.cohesive_radius, p.approach, load_at(p)};
  }
  energy potential(double y) const {
    const auto c = configure(branch_.at(y, y >= 0));
    return hertz::stored_energy(pair_, c) + law_.potential_energy(pair_, c);
  }

  contact_pair pair_;
  ricochet::maugis_dugdale law_;
  branch branch_;
};

} // namespace ricochet::closed_form
