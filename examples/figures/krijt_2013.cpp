// Krijt et al. 2013, J. Phys. D 46 435303: figures 2, 3, 5, C1 and C2, the crack-velocity law (16), (17),
// and whether plastic and adhesive losses may be added (30).
#include "figures.hpp"

#include <ricochet/study/threshold/threshold_map.hpp>

#include <array>
#include <cstdio>

#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace figures {

namespace {

// The paper's section 3 and table 2; radius and z0 are not printed there, these reproduce its numbers.
const duration relaxation_time = 1e-11 * seconds;
const length interaction_range = 0.3 * nanometres;
const jkr adhesive{.work_of_adhesion = work_of_adhesion(materials::water_ice, materials::water_ice)};
const std::string about_ice = "two water-ice spheres: E 7e9 Pa, nu 0.25, density 1000 kg/m^3, work of adhesion 0.74 "
                              "J/m^2, k 0.02, z0 3e-10 m, A = T_vis/nu^2, published fits of the crack-velocity law";

contact_pair ice(length radius) {
  const sphere grain{.solid = materials::water_ice, .radius = radius};
  return between(grain, grain);
}
const contact_pair pair = ice(2.0 * micrometres);

greenwood_fit edge(duration T_vis) { return {.relaxation_time = T_vis, .interaction_range = interaction_range}; }
kuwabara_kono bulk(duration T_vis) {
  return {.bulk_time = bulk_time_of_krijt(T_vis, materials::water_ice.poissons_ratio)};
}

/// Both (16), (17) and the exact law, against the edge's speed in units of E* z0^2/(w T_vis).
void crack_velocity_law(const std::string& directory) {
  sheet out(directory, "krijt_2013_crack_velocity_law", "G/w at the edge of a contact against the edge's speed, k 0.02",
            {{"energy_release_ratio", "1"},
             {"closing_speed_fit", "1"},
             {"closing_speed_exact", "1"},
             {"opening_speed_fit", "1"},
             {"opening_speed_exact", "1"}});
  const double k = 0.02;
  const greenwood_fit fit = edge(relaxation_time);
  greenwood exact{.relaxation_time = relaxation_time, .modulus_ratio = k, .interaction_range = interaction_range};
  exact.tabulate();
  const auto speed_at = [](const auto& law, double ratio) {
    const auto rate = rate_anywhere<double>(law, std::sqrt(ratio));
    return std::abs(rate.advance / rate.slowness);
  };
  for (const double x : logarithmic(1e-3, 1e4, 200)) // approaches both ends of k < beta < 1 in equal ratios
    if (const double ratio = (k + x) / (1 + x); ratio > k)
      out.row(ratio, 1, {speed_at(fit, ratio), speed_at(exact, ratio)});
  for (const double x : logarithmic(1e-4, 1e3, 200))
    if (const double ratio = (1 + x / k) / (1 + x); ratio < 1 / k)
      out.row(ratio, 3, {speed_at(fit, ratio), speed_at(exact, ratio)});
  out.finish();
}

struct motion {
  std::vector<double> time, approach, radius, elastic_force;
  std::vector<double> kinetic, elastic, surface, crack, bulk; ///< in units of the initial kinetic energy
  void keep(std::size_t rows) {
    for (auto* each : {&time, &approach, &radius, &elastic_force, &kinetic, &elastic, &surface, &crack, &bulk})
      each->resize(rows);
  }
};

/// The motion that collide() ends where capture is certain, on for `longer` with the same equations in time.
template <class Model>
void follow(const Model& model, motion& m, double last_rate, double unit, double longer) {
  namespace odeint = boost::numeric::odeint;
  using unknowns = std::array<double, 5>; // approach, rate, radius, both losses
  const physical_system system(model);
  const double w = in_si(model.adhesion.work_of_adhesion), mass = in_si(model.pair.reduced_mass);
  const auto part_of = [](const unknowns& y) {
    typename physical_system<Model>::state_type x{};
    x[mutual_approach] = y[0];
    x[approach_rate] = y[1];
    x[contact_radius] = y[2];
    return x;
  };
  const auto equations = [&](const unknowns& y, unknowns& dy, double t) {
    const auto x = part_of(y);
    auto dx = x;
    system(x, dx, t);
    const force damping = model.damping_force(y[0] * metres, y[1] * metres_per_second, y[2] * metres);
    dy = {dx[mutual_approach], dx[approach_rate], dx[contact_radius],
          2 * pi<double>() * y[2] * (1 - system.energy_release_ratio(x)) * w * dx[contact_radius] / unit, // (C.2)
          in_si(damping) * y[1] / unit};                                                                  // (C.3)
  };
  const auto note = [&](const unknowns& y, double t) {
    const configuration<dimensional> c{y[0] * metres, y[1] * metres_per_second, y[2] * metres,
                                       boost::units::root<2>(y[2] * metres)};
    m.time.push_back(t);
    m.approach.push_back(y[0]);
    m.radius.push_back(y[2]);
    m.elastic_force.push_back(in_si(model.elastic_force(c.approach, c.radius)));
    m.kinetic.push_back(0.5 * mass * y[1] * y[1] / unit);
    m.elastic.push_back(in_si(model.elastic.stored_energy(model.pair, c)) / unit);
    m.surface.push_back(in_si(model.adhesion.surface_energy(c.radius)) / unit);
    m.crack.push_back(y[3]);
    m.bulk.push_back(y[4]);
  };
  unknowns y{m.approach.back(), last_rate, m.radius.back(), m.crack.back(), m.bulk.back()};
  odeint::integrate_const(odeint::make_controlled(1e-16, 1e-9, odeint::runge_kutta_dopri5<unknowns>()), equations, y,
                          m.time.back(), m.time.back() + longer, longer / 600, note);
}

motion collision(speed v, duration until) {
  const auto model =
      compose(pair, hertz{}, adhesive, edge(relaxation_time), bulk(relaxation_time), energy_ledger{}, trajectory{});
  const auto out = collide(model, impact{.speed = v});
  const auto& t = out.trajectory;
  const double unit = t.kinetic_energy.front();
  motion m{t.time,           t.mutual_approach, t.contact_radius, t.elastic_force, t.kinetic_energy,
           t.elastic_energy, t.surface_energy,  t.crack_loss,     t.bulk_loss};
  for (auto* each : {&m.kinetic, &m.elastic, &m.surface, &m.crack, &m.bulk})
    for (double& value : *each)
      value /= unit;
  if (out.ending == ending::captured)
    follow(model, m, t.approach_rate.back(), unit, in_si(until) - m.time.back());
  else
    m.keep(m.time.size() - 1); // not the row of the bodies apart
  std::printf("  Krijt 2013, %g m/s: %s after %.3g ns, lost at the edge %.3f (and %.3f at touch), in the bulk %.3f\n",
              in_si(v), name_of(out.ending), 1e9 * t.time.back(), m.crack.back() - m.crack.front(), m.crack.front(),
              m.bulk.back());
  return m;
}

/// Contact radius and elastic force against mutual approach, with the static theories.
void contact_of(const motion& m, const std::string& directory, const std::string& name, const std::string& about) {
  sheet out(directory, name, about + "; sphere radius 2e-6 m, T_vis 1e-11 s; " + about_ice,
            {{"mutual_approach", "m"},
             {"contact_radius", "m"},
             {"elastic_force", "N"},
             {"hertz_contact_radius", "m"},
             {"hertz_force", "N"},
             {"jkr_contact_radius", "m"},
             {"jkr_force", "N"},
             {"jkr_snap_on_contact_radius", "m"},
             {"jkr_snap_on_force", "N"},
             {"jkr_equilibrium_contact_radius", "m"},
             {"jkr_equilibrium_force", "N"}});
  const auto without = compose(pair, hertz{});
  const auto with = compose(pair, hertz{}, adhesive);
  const auto fixed = [](const auto& model, length approach) -> std::vector<double> {
    const length radius = model.static_radius(approach);
    return {in_si(radius), in_si(model.elastic_force(approach, radius))};
  };
  for (std::size_t i = 0; i < m.time.size(); ++i)
    out.row(m.approach[i], 1, {m.radius[i], m.elastic_force[i]});
  const double deepest = 1.05 * *std::max_element(m.approach.begin(), m.approach.end());
  for (const double x : even(0, 1, 101))
    out.row(deepest * x * x, 3, fixed(without, deepest * x * x * metres));
  const auto on_curve = [&](length radius) { // (8)
    return hertz::load_free_approach(pair, radius) - adhesive.flattening(pair) * boost::units::root<2>(radius);
  };
  const double fold = in_si(adhesive.fold_radius(pair)), last = in_si(with.static_radius(deepest * metres));
  for (const double a : even(fold, last, 151)) {
    const length approach = on_curve(a * metres);
    out.row(in_si(approach), 5, {a, in_si(with.elastic_force(approach, a * metres))});
  }
  out.row(0, 7, {0, 0});
  out.row(0, 7, fixed(with, length()));
  const length rest = adhesive.equilibrium_radius(pair);
  out.row(in_si(on_curve(rest)), 9, {in_si(rest), in_si(with.elastic_force(on_curve(rest), rest))});
  out.finish();
}

/// Energies during the collision; the loss at the edge counted, as in the paper, from after the first touch.
void energies_of(const motion& m, const std::string& directory, const std::string& name, const std::string& about) {
  sheet out(directory, name,
            about + "; energies in units of the initial kinetic energy; sphere radius 2e-6 m, T_vis 1e-11 s; " +
                about_ice,
            {{"time", "s"},
             {"kinetic_energy", "1"},
             {"elastic_energy", "1"},
             {"surface_energy", "1"},
             {"crack_loss", "1"},
             {"bulk_loss", "1"},
             {"crack_loss_with_touch", "1"}});
  for (std::size_t i = 0; i < m.time.size(); ++i)
    out.row(m.time[i], 1,
            {m.kinetic[i], m.elastic[i], m.surface[i], m.crack[i] - m.crack.front(), m.bulk[i], m.crack[i]});
  out.finish();
}

void restitution_over_radius(const std::string& directory) {
  const speed v = 8.0 * metres_per_second; // the paper does not print the speed of its figure
  sheet out(directory, "krijt_2013_figure_5_left", "restitution at 8 m/s, T_vis 1e-11 s; 0 = captured; " + about_ice,
            {{"reduced_radius", "m"}, {"viscoelastic_jkr", "1"}, {"jkr", "1"}, {"viscous", "1"}, {"independent", "1"}});
  const kuwabara_kono viscous = bulk(relaxation_time);
  for (const double R : logarithmic(1e-7, 1e-4, 121)) {
    const contact_pair at = ice(2 * R * metres);
    const auto solved = collide(compose(at, hertz{}, adhesive, edge(relaxation_time), viscous), impact{.speed = v},
                                {.tolerance = 1e-6});
    const bool ended = solved.ending == ending::separated || solved.ending == ending::captured;
    out.row(R, 1,
            {ended ? solved.restitution.value_or(0) : std::numeric_limits<double>::quiet_NaN(),
             closed_form::restitution(at, adhesive.work_of_adhesion, v).value_or(0),
             std::max(0., closed_form::weak_damping_restitution(at, viscous.bulk_time, v)),
             closed_form::independent_losses(at, adhesive.work_of_adhesion, viscous.bulk_time, v).value_or(0)});
  }
  out.finish();
}

/// No number where the pair sticks up to a tenth of ice's speed of sound.
void sticking_speed_over_radius(const std::string& directory) {
  const std::array relaxation_times{1e-13, 1e-12, 1e-11, 1e-10};
  std::vector<column> columns{{"reduced_radius", "m"}, {"jkr", "m/s"}};
  for (const double T : relaxation_times)
    columns.push_back({"T_vis_" + shown(T) + "_s", "m/s"});
  sheet out(directory, "krijt_2013_figure_5_right", "sticking speed; " + about_ice, columns);
  struct point {
    length reduced_radius;
    duration T_vis;
  };
  std::vector<point> points;
  for (const double R : logarithmic(1e-7, 1e-5, 41))
    for (const double T : relaxation_times)
      points.push_back({R * metres, T * seconds});
  // [sticking speeds]
  const auto found = sticking_speeds(
      [](const point& p) {
        return compose(ice(2.0 * p.reduced_radius), hertz{}, adhesive, edge(p.T_vis), bulk(p.T_vis));
      },
      points, {.relative_width = 1e-6, .fastest = 265.0 * metres_per_second});
  // [sticking speeds]
  for (std::size_t i = 0; i < points.size(); i += relaxation_times.size()) {
    const length R = points[i].reduced_radius;
    std::vector<double> row{in_si(closed_form::sticking_speed(ice(2.0 * R), adhesive.work_of_adhesion))};
    for (std::size_t j = i; j < i + relaxation_times.size(); ++j) {
      if (found[j].at == sought_threshold::place::failed)
        throw std::runtime_error("figure 5: " + found[j].reason);
      const auto value = found[j].value();
      row.push_back(value ? in_si(*value) : std::numeric_limits<double>::quiet_NaN());
    }
    out.row(in_si(R), 1, row);
  }
  out.finish();
}

/// Restitution where adhesion and plastic flow act in one motion, and where their losses are added (30). Two numbers
/// decide: the speed, and JKR's sticking speed, both in units of the yield speed.
void plastic_and_adhesive_losses(const std::string& directory) {
  const std::array ratios{0.03, 0.1, 0.3, 1.0};
  std::vector<column> columns{{"speed_over_yield_speed", "1"}, {"plastic", "1"}};
  for (const double ratio : ratios)
    for (const char* what : {"motion_", "added_", "added_minus_motion_"})
      columns.push_back({what + shown(ratio), "1"});
  sheet out(directory, "krijt_2013_losses_added",
            "restitution with adhesion and plastic flow, in one motion and by (30), for JKR's sticking speed over the "
            "yield speed as the columns say; 0 = captured",
            columns);
  const speed sticking = closed_form::sticking_speed(pair, adhesive.work_of_adhesion);
  for (const double v : logarithmic(0.2, 1000, 281)) {
    const speed one = 1.0 * metres_per_second;
    std::vector<double> row{closed_form::plastic_restitution(one, v * one)};
    for (const double ratio : ratios) {
      // v_y goes as Y^{5/2}.
      const speed yield = sticking / ratio, of_one = closed_form::yield_speed(pair, 1.0 * pascals);
      const modulus strength = std::pow(double(yield / of_one), 0.4) * pascals;
      const impact at{.speed = v * yield};
      const double motion =
          collide(compose(pair, hertz{}, adhesive, thornton_ning_contact{strength}), at).restitution.value_or(0);
      const double added =
          collide(compose(pair, hertz{}, adhesive, thornton_ning{strength}), at).restitution.value_or(0);
      const double excess = added - motion;
      row.insert(row.end(),
                 {motion, added, excess > 1e-7 ? excess : std::numeric_limits<double>::quiet_NaN()}); // > tolerance
    }
    out.row(v, 1, row);
  }
  out.finish();
}

} // namespace

void krijt_2013(const std::string& directory) {
  const motion bouncing = collision(8.0 * metres_per_second, {}),
               sticking = collision(2.0 * metres_per_second, 1e-7 * seconds);
  contact_of(bouncing, directory, "krijt_2013_figure_2", "contact of a collision at 8 m/s");
  contact_of(sticking, directory, "krijt_2013_figure_3", "contact of a collision at 2 m/s");
  restitution_over_radius(directory);
  sticking_speed_over_radius(directory);
  energies_of(bouncing, directory, "krijt_2013_figure_C1", "energies of a collision at 8 m/s");
  energies_of(sticking, directory, "krijt_2013_figure_C2", "energies of a collision at 2 m/s");
  crack_velocity_law(directory);
  plastic_and_adhesive_losses(directory);
}

} // namespace figures
