// Adhesion between the limits of JKR and DMT: equilibria and quasi-static impact of a contact with a Dugdale zone.
#pragma once
#include <ricochet/closed_form/hertz.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <optional>

namespace ricochet::closed_form {

namespace detail {

/// The equilibria of Maugis 1992 in his reduced units, as functions of t = arccos(a/c), which makes them explicit:
/// lambda g c^2/2 + 4 lambda^2 q c/3 = 1, g = sin t cos t - t cos 2t, q = t sin t - 1 + cos t. At t = pi/2 the contact
/// has just vanished; before, with a = 0, c runs from 0 to c(pi/2).
struct dugdale_equilibria {
  double lambda;
  static constexpr double end = std::numbers::pi / 2;

  struct point {
    double contact_radius, cohesive_radius, approach, load;
  };

  point in_contact(double t) const {
    const double c = cohesive_radius(t), a = c * std::cos(t);
    return {a, c, a * a - 4 * lambda / 3 * c * std::sin(t),
            a * a * a - lambda * c * c * (std::sin(t) * std::cos(t) + t)};
  }

  point before_contact(double c) const {
    return {0, c, c * (c / 2 - fold_before_contact()) + first_touch(), -end * lambda * c * c};
  }

  double cohesive_radius(double t) const {
    const double A = lambda / 2 * g(t), B = 4 * lambda * lambda / 3 * q(t);
    return 2 / (B + std::sqrt(B * B + 4 * A));
  }

  /// Approach, < 0, at which the bodies begin to pull: sigma_0 times the gap is w.
  double first_touch() const { return -2 / (std::numbers::pi * lambda); }

  /// Without contact, approach is least here; if the bodies touch before, it is least at fold_in_contact().
  double fold_before_contact() const { return 8 * lambda / (3 * std::numbers::pi); }
  bool folds_in_contact() const { return fold_before_contact() > cohesive_radius(end); }

  double fold_in_contact() const {
    return root([&](double t) { return slope(t); }, shallow(), end);
  }

  /// t of the stable equilibrium of this approach. \pre it is one in contact
  double in_contact_at(double approach) const {
    double near = folds_in_contact() ? fold_in_contact() : end, far = near;
    do
      far /= 2;
    while (in_contact(far).approach < approach);
    return root([&](double t) { return approach - in_contact(t).approach; }, far, near);
  }

  bool stable_before_contact(double approach) const {
    return !folds_in_contact() && approach < in_contact(end).approach;
  }

  double cohesive_radius_before_contact(double approach) const {
    const double fold = fold_before_contact();
    return fold + std::sqrt(std::max(0., fold * fold + 2 * (approach - first_touch())));
  }

  point at(double approach) const {
    return stable_before_contact(approach) ? before_contact(cohesive_radius_before_contact(approach))
                                           : in_contact(in_contact_at(approach));
  }

  point fold() const {
    return folds_in_contact() ? in_contact(fold_in_contact()) : before_contact(fold_before_contact());
  }

  double pull_off() const {
    const auto deepest = boost::math::tools::brent_find_minima( // for large lambda, t is of order 1/lambda
        [&](double log_t) { return in_contact(std::exp(log_t)).load; }, std::log(shallow()), std::log(end), 50);
    return -std::min(deepest.second, in_contact(end).load);
  }

  /// Area of the loop: -int load d(approach) from the fold, where the bodies jump apart, to the first touch, where they
  /// jump together.
  double hysteresis() const {
    double area = 0;
    if (!folds_in_contact()) {
      const double from = fold_before_contact();
      const bool lands_before = stable_before_contact(first_touch());
      const double to = lands_before ? 2 * from : cohesive_radius(end);
      const auto work = [&](double c) { return end * lambda * cube(c) * (c / 4 - from / 3); };
      area = work(to) - work(from);
      if (lands_before)
        return area;
    }
    const double from = folds_in_contact() ? fold_in_contact() : end;
    const auto work = [&](double t) { return in_contact(t).load * slope(t) * std::cos(t); };
    return area + boost::math::quadrature::gauss_kronrod<double, 61>::integrate(work, in_contact_at(first_touch()),
                                                                                from, 4, 1e-13);
  }

private:
  /// Both without cancellation for small t, which large lambda leads to.
  static double g(double t) {
    const double u = 2 * t;
    return u * u * boost::math::sph_bessel(1, u) / 2;
  }
  static double q(double t) {
    const double h = t / 2, s = std::sin(h);
    return 2 * s * (t * std::cos(h) - s);
  }

  /// d(approach)/dt over cos t.
  double slope(double t) const {
    const double c = cohesive_radius(t), C = std::cos(t), S = std::sin(t);
    const double rate = -(2 * lambda * S * c + 4 * lambda * lambda / 3) * t * c / // (dc/dt)/cos t
                        (lambda * g(t) * c + 4 * lambda * lambda / 3 * q(t));
    return 2 * c * rate * C * C - 2 * c * c * S - 4 * lambda / 3 * (rate * S + c);
  }

  /// A t on the compressed side of every fold.
  double shallow() const {
    double t = end / 2;
    while (!(in_contact(t).approach > 0))
      t /= 2;
    return t;
  }

  template <class Function>
  static double root(const Function& f, double low, double high) {
    std::uintmax_t rounds = 200;
    const auto found =
        boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(), rounds);
    return (found.first + found.second) / 2;
  }
};

} // namespace detail

/// Maugis & Dugdale: adhesion of any range. The surfaces pull with the constant stress w/z0 wherever their gap is below
/// z0: in a ring around the contact, and in a disc before they touch.
/// lambda = (2 w/z0) (R/(pi w K^2))^{1/3}, K = 4E*/3
/// pair: E* (Pa), R (m), m* (kg), all > 0; w: work of adhesion of the pair, J/m^2, > 0; z0: interaction_range, m, > 0.
/// Valid for every Tabor number, 0.89 lambda; tends to JKR for large and to DMT for small ones.
/// Source: Maugis 1992, J. Colloid Interface Sci. 150 243; before contact: Johnson & Greenwood 1997, 192 326.
class maugis_dugdale {
public:
  maugis_dugdale(const contact_pair& pair, energy_per_area w, length z0) : pair_(pair) {
    detail::validate(pair);
    require("work_of_adhesion", w, positive);
    require("interaction_range", z0, positive);
    const modulus K = 4.0 * pair.reduced_modulus / 3.0;
    const length R = pair.reduced_radius;
    radius_ = boost::units::root<3>(pi<double>() * w * R * R / K);
    load_ = pi<double>() * w * R;
    equilibria_.lambda = 2.0 * radius_ / R * (w / z0 * R) / (pi<double>() * w) * (radius_ / R);
    require("transition_parameter", equilibria_.lambda, range{.low = 1e-6, .high = 1e6});
  }

  struct equilibrium {
    length contact_radius, cohesive_radius, approach;
    force load; ///< > 0 repulsive
  };

  double transition_parameter() const { return equilibria_.lambda; }

  /// Largest tension, between 2 pi w R (DMT) and 1.5 pi w R (JKR).
  force pull_off_force() const { return equilibria_.pull_off() * load_; }

  /// The stable equilibrium at this approach; nothing where the bodies have jumped apart.
  std::optional<equilibrium> at(length approach) const {
    const double reduced = approach / depth();
    if (reduced < equilibria_.fold().approach)
      return std::nullopt;
    return in_units(equilibria_.at(reduced));
  }

  /// Where the bodies jump together, -z0, and the equilibrium from which they jump apart, at the least approach.
  length approach_of_jump_in() const { return equilibria_.first_touch() * depth(); }
  equilibrium jump_out() const { return in_units(equilibria_.fold()); }

  /// Lost in one contact without other losses: the area between the paths in and out.
  energy hysteresis() const { return equilibria_.hysteresis() * load_ * depth(); }

  /// Largest speed of impact at which the bodies stay together.
  speed sticking_speed() const { return boost::units::root<2>(2.0 * hysteresis() / pair_.reduced_mass); }

  /// Restitution of an impact at speed v, or nothing if the bodies stay together.
  std::optional<double> restitution(speed v) const {
    require("speed", v, positive);
    const double ratio = sticking_speed() / v;
    return ratio < 1 ? std::optional(std::sqrt((1 - ratio) * (1 + ratio))) : std::nullopt;
  }

private:
  length depth() const { return radius_ * (radius_ / pair_.reduced_radius); }
  equilibrium in_units(const detail::dugdale_equilibria::point& p) const {
    return {p.contact_radius * radius_, p.cohesive_radius * radius_, p.approach * depth(), p.load * load_};
  }

  contact_pair pair_;
  detail::dugdale_equilibria equilibria_{};
  length radius_;
  force load_;
};

} // namespace ricochet::closed_form
