// Every law's formulas on numbers of one kind: the same text evaluated for each scalar type.
#pragma once
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
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

#include <vector>

namespace support {
using namespace ricochet;

/// A contact and the edge's sqrt(G/w), all of order one.
template <class T>
struct contact_numbers {
  T modulus, radius_of_bodies, mass, work_of_adhesion, approach, rate, radius, root_ratio;

  template <class Other, class Convert>
  contact_numbers<Other> in(const Convert& convert) const {
    return {convert(modulus),          convert(radius_of_bodies), convert(mass),
            convert(work_of_adhesion), convert(approach),         convert(rate),
            convert(radius),           convert(root_ratio)};
  }
};

/// Contacts in tension and in compression, with an edge in every piece of the crack laws for k = 0.02. Force and energy
/// release rate lose less than a digit there to cancellation, the crack laws' logarithms two.
inline std::vector<contact_numbers<double>> contacts() {
  std::vector<contact_numbers<double>> result;
  int i = 0;
  for (const double ratio : {0.03, 0.1, 0.28, 0.31, 0.8, 1.2, 3., 3.8, 20., 40.}) {
    const double a = 0.7 + 0.13 * (i % 5), R = 1.7 - 0.1 * i;
    const double part = i % 3 == 0 ? -0.8 : i % 3 == 1 ? 0.6 : 0.1;
    result.push_back(
        {0.8 + 0.05 * i, R, 1.1, 0.3 + 0.1 * i, part * a * a / R, i % 2 ? -0.4 : 0.9, a, std::sqrt(ratio)});
    ++i;
  }
  return result;
}

/// One table for all scalar types.
inline std::shared_ptr<const greenwood_table> shared_table() {
  static const auto table = std::make_shared<const greenwood_table>(0.02);
  return table;
}

/// What the laws give while a collision runs.
template <class T>
std::vector<T> values_in_the_loop(const contact_numbers<T>& x) {
  using std::sqrt;
  using S = reduced<T>;
  const basic_pair<S> pair{x.modulus, x.radius_of_bodies, x.mass};
  const configuration<S> c{x.approach, x.rate, x.radius, sqrt(x.radius)};
  const configuration<S> rebound{x.approach, -x.rate * x.rate, x.radius, sqrt(x.radius)};
  const jkr_law<S> adhesion{x.work_of_adhesion};
  const line_force_law<S> ring{x.work_of_adhesion, T(0.25)};
  const greenwood_law<S> exact{T(1), T(1) / T(50), T(1), T(1.0078125), shared_table()};
  const greenwood_fit_law<S> fit{T(1), T(1) / T(50), T(1), T(1.0078125)};
  const maugis_barquins_law<S> power{x.modulus, T(0.625)};
  std::vector<T> values{hertz_law<S>::force(pair, c),
                        hertz_law<S>::stored_energy(pair, c),
                        hertz_law<S>::energy_release_rate(pair, c),
                        hertz_law<S>::load_free_approach(pair, c.radius),
                        hertz_law<S>::load_free_slope(pair, c.radius),
                        linear_law<S>{x.modulus}.force(pair, c),
                        linear_law<S>{x.modulus}.stored_energy(pair, c),
                        linear_law<S>::load_free_approach(pair, c.radius),
                        linear_law<S>::load_free_slope(pair, c.radius),
                        adhesion.surface_energy(c.radius),
                        adhesion.flattening(pair),
                        adhesion.pull_off_force(pair),
                        ring.attraction(pair, c),
                        ring.potential_energy(pair, c),
                        ring.rebound_damping(pair, rebound),
                        coulomb_law<S>{T(0.5)}.sliding_force(x.modulus),
                        coulomb_with_peeling_law<S>{T(0.5), x.modulus}.edge_resistance(pair, T(0.25), x.rate),
                        mindlin_law<S>{T(0.5), T(0.75)}.stiffness(pair),
                        mindlin_law<S>{T(0.5), T(0.75)}.largest_stretch(c.radius),
                        dmt_law<S>{x.work_of_adhesion}.attraction(pair, c),
                        dmt_law<S>{x.work_of_adhesion}.potential_energy(pair, c),
                        fit.speed_scale(pair, x.work_of_adhesion),
                        exact.speed_scale(pair, x.work_of_adhesion),
                        kuwabara_kono_law<S>{T(0.375)}.coefficient(pair, c),
                        hunt_crossley_law<S>{T(0.25)}.coefficient(pair, c),
                        tsuji_law<S>{T(0.5)}.coefficient(pair, c),
                        linear_dashpot_law<S>{x.mass}.coefficient(pair, c)};
  const thornton_ning_contact_law<S> flowing{x.modulus / T(8)};
  const T few = x.work_of_adhesion / T(16);
  const contact_shape<S> shape = flowing.shape(pair, few, x.radius / T(2), x.radius);
  flattened_configuration<S> flat{};
  static_cast<configuration<S>&>(flat) = c;
  flat.take(pair, shape);
  values.insert(values.end(), {shape.radius, shape.residual_approach, shape.radius_slope, shape.approach_slope,
                               flowing.lost_force(flat)});
  const auto put = [&](const edge_rate<T>& edge) { values.insert(values.end(), {edge.advance, edge.slowness}); };
  for (int piece = 0; piece < 4; ++piece)
    put(fit.rate(x.root_ratio, piece));
  put(rate_anywhere<T>(fit, x.root_ratio));
  put(rate_anywhere<T>(exact, x.root_ratio));
  put(power.rate(x.root_ratio, 0));
  return values;
}

/// What the laws give before and after: not meant for packs.
template <class T>
std::vector<T> values_at_set_up(const contact_numbers<T>& x) {
  const basic_pair<reduced<T>> pair{x.modulus, x.radius_of_bodies, x.mass};
  const jkr_law<reduced<T>> adhesion{x.work_of_adhesion};
  const maugis_dugdale_law<reduced<T>> ranged{x.work_of_adhesion, x.radius / T(2)};
  const auto branch = ranged.branch(pair, x.radius);
  const auto place = branch.at(x.approach * x.approach / x.radius, true);
  const cohesive_configuration<reduced<T>> c{
      {place.approach, x.rate, place.radius, x.radius}, place.cohesive_radius, place.angle};
  return {ranged.attraction(pair, c),
          ranged.potential_energy(pair, c),
          ranged.equivalent_work_of_adhesion(pair),
          place.slope,
          branch.first(),
          adhesion.touch_radius(pair),
          adhesion.fold_radius(pair),
          adhesion.equilibrium_radius(pair),
          adhesion.contact_radius(pair, x.radius),
          adhesion.exit_energy(pair),
          thornton_ning_contact_law<reduced<T>>{x.modulus}.yield_radius(pair, adhesion.flattening(pair)),
          thornton_ning_contact_law<reduced<T>>{}.least_strength(pair, adhesion.flattening(pair))};
}

} // namespace support
