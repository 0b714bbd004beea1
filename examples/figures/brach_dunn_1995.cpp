// Brach & Dunn 1995, Aerosol Sci. Technol. 23 51: figures 2, 4, 6, 7, 8, 9 and A2, and the tangential motion of the
// impact of table 1, which the paper describes without a figure.
#include "figures.hpp"

#include <ricochet/closed_form/rigid_body.hpp>
#include <ricochet/study/population.hpp>

#include <cstdio>

namespace figures {

namespace {

namespace rigid_body = closed_form::rigid_body;
using rigid_body::coefficients;
using rigid_body::velocities;

// Table 1, and the values named in the text. Of the adhesion's damping ratio the paper prints 12.5; half of it gives
// its results.
const material glass{
    .youngs_modulus = 72.0 * gigapascals, .poissons_ratio = 0.21, .mass_density = 2600.0 * kilograms_per_cubic_metre};
const material steel{
    .youngs_modulus = 207.0 * gigapascals, .poissons_ratio = 0.27, .mass_density = 7800.0 * kilograms_per_cubic_metre};
const energy_per_area force_per_length = 250.0 * newtons_per_metre;
const double zeta_a = 6.25, friction = 0.1;
const speed table_1_speed = 2.8 * metres_per_second, reference_speed = 130.0 * metres_per_second;
const length table_1_diameter = 10.12 * micrometres;
const angular_speed table_1_spin = 1.4557e5 * radians_per_second;
const double table_1_restitution = 0.746;
const std::string about_simulation =
    "silver-coated glass sphere (E 72e9 Pa, nu 0.21, density 2600 kg/m^3) on steel (E 207e9 Pa, nu 0.27), f_0 250 "
    "N/m, zeta_A 6.25, f 0.1";

template <class... Requests>
auto simulation(length diameter, speed v, double zeta_h, Requests... requests) {
  using closed_form::damping_coefficient_of_brach_dunn;
  const contact_pair pair = between(sphere{glass, 0.5 * diameter}, flat_wall{steel});
  return compose(pair, hertz{},
                 line_force{.force_per_length = force_per_length,
                            .rebound_coefficient = damping_coefficient_of_brach_dunn(zeta_a, pair, v)},
                 hunt_crossley{.damping_coefficient = damping_coefficient_of_brach_dunn(zeta_h, pair, v)},
                 coulomb{.friction_coefficient = friction}, requests...);
}

rigid_body::solid_sphere ball(length diameter) {
  const auto pair = between(sphere{glass, 0.5 * diameter}, flat_wall{steel});
  return {.mass = pair.reduced_mass, .radius = pair.reduced_radius};
}

/// mu_0, counted > 0 where it slows the sphere, for an impact at `angle` between path and wall.
double limiting_ratio(double restitution, speed v, double angle, speed surface_speed) {
  const auto sphere = ball(table_1_diameter); // any: its size does not count
  const velocities before{
      .normal = v * std::sin(angle), .tangential = v * std::cos(angle), .angular = surface_speed / sphere.radius};
  return -rigid_body::limiting_impulse_ratio(sphere, before, coefficients{.restitution_without_adhesion = restitution});
}

void figure_2(const std::string& directory) {
  sheet out(
      directory, "brach_dunn_1995_figure_2",
      "limiting impulse ratio over angle of incidence at 2.8 m/s, without spin and with that of table 1 (+-1.4557e5 "
      "rad/s); last column: impulse ratio with friction 0.1, without spin, e 0.746",
      {{"angle", "deg"},
       {"no_spin_R_0", "1"},
       {"no_spin_R_1", "1"},
       {"forespin_R_0", "1"},
       {"forespin_R_1", "1"},
       {"backspin_R_0", "1"},
       {"backspin_R_1", "1"},
       {"with_friction", "1"}});
  const auto sphere = ball(table_1_diameter);
  const speed spin = sphere.radius * table_1_spin, none{};
  for (const double angle : even(5, 90, 171)) {
    std::vector<double> row;
    for (const speed& surface : {none, spin, -spin})
      for (const double restitution : {0., 1.})
        row.push_back(limiting_ratio(restitution, table_1_speed, angle * degrees, surface));
    const velocities before{.normal = table_1_speed * std::sin(angle * degrees),
                            .tangential = table_1_speed * std::cos(angle * degrees),
                            .angular = {}};
    row.push_back(-rigid_body::coulomb_impulse_ratio(
                       sphere, before, coefficients{.restitution_without_adhesion = table_1_restitution}, friction)
                       .impulse_ratio);
    out.row(angle, 1, row);
  }
  out.finish();
}

void figure_4(const std::string& directory) {
  sheet out(directory, "brach_dunn_1995_figure_4",
            "limiting impulse ratio over angle of incidence at 2.3 m/s, e 0.601, for the spins that give +-0.12 at "
            "normal incidence; last column: these",
            {{"angle", "deg"}, {"backspin", "1"}, {"forespin", "1"}, {"no_spin", "1"}, {"measured_at_normal", "1"}});
  const speed v = 2.3 * metres_per_second;
  const double e = 0.601, measured = 0.12;
  const speed unit = 1.0 * metres_per_second; // the ratio is linear in r omega
  const speed spin = measured / limiting_ratio(e, v, 90 * degrees, -unit) * unit;
  std::printf("  Brach & Dunn 1995, figure 4: r omega %.3f m/s, final tangential velocity %.3f m/s\n", in_si(spin),
              measured * (1 + e) * in_si(v));
  for (const double angle : even(15, 90, 151))
    out.row(angle, 1,
            {limiting_ratio(e, v, angle * degrees, -spin), limiting_ratio(e, v, angle * degrees, spin),
             limiting_ratio(e, v, angle * degrees, speed())});
  for (const double sign : {-1, 1})
    out.row(90, 4, {sign * measured});
  out.finish();
}

/// R, and e of the rigid body whose work of adhesion is that of table 1 (A34).
std::vector<double> rigid_body_restitutions(speed v) {
  const auto sphere = ball(table_1_diameter);
  const double R_1 = rigid_body::restitution_without_adhesion(reference_speed, table_1_speed);
  const energy work = rigid_body::works_of_adhesion(sphere, {table_1_speed, {}, {}},
                                                    coefficients{.restitution_without_adhesion = R_1,
                                                                 .adhesion_coefficient = 1 - table_1_restitution / R_1})
                          .by_restitution;
  const double R = rigid_body::restitution_without_adhesion(reference_speed, v);
  const double B = work / rigid_body::kinetic_energy(sphere, {v, {}, {}});
  return {R, std::sqrt(std::max(0., R * R - B))};
}

void figure_6(const std::string& directory) {
  sheet out(directory, "brach_dunn_1995_figure_6",
            "restitution of " + about_simulation +
                ", zeta_H 10.45; rigid body of table 1; 0 = captured; last: measured, "
                "as printed in the text",
            {{"speed", "m/s"},
             {"simulated_5_um", "1"},
             {"simulated_10.12_um", "1"},
             {"simulated_13_um", "1"},
             {"rigid_body", "1"},
             {"measured_8.6_um", "1"},
             {"measured_10.12_um", "1"}});
  for (const double v : logarithmic(0.5, 30, 241)) {
    std::vector<double> row;
    for (const double diameter : {5., 10.12, 13.})
      row.push_back(collide(simulation(diameter * micrometres, v * metres_per_second, 10.45),
                            oblique_impact{.speed = v * metres_per_second})
                        .normal.restitution.value_or(0));
    row.push_back(rigid_body_restitutions(v * metres_per_second)[1]);
    out.row(v, 1, row);
  }
  out.row(in_si(table_1_speed), 5, {0.62, table_1_restitution});
  out.finish();
}

/// Figure 6 of all sizes. Assumed: diameters are lognormal, nine tenths between those of its curves, 5 and 13 um.
void population(const std::string& directory) {
  using closed_form::damping_coefficient_of_brach_dunn;
  sheet out(directory, "brach_dunn_1995_population",
            "restitutions that 5, 25, 50, 75 and 95 % of the spheres stay below, and the share that sticks; " +
                about_simulation +
                ", zeta_H 10.45, diameters assumed lognormal, nine tenths from 5 to 13 um, 4000 spheres at each speed; last: "
                "measured, as printed in the text",
            {{"speed", "m/s"},
             {"e_of_5_percent", "1"},
             {"e_of_25_percent", "1"},
             {"e_of_50_percent", "1"},
             {"e_of_75_percent", "1"},
             {"e_of_95_percent", "1"},
             {"captured_fraction", "1"},
             {"measured_8.6_um", "1"},
             {"measured_10.12_um", "1"}});
  for (const double v : logarithmic(0.5, 30, 81)) {
    const speed at = v * metres_per_second;
    const auto draw = [&](std::mt19937_64& random) {
      std::lognormal_distribution<double> diameter(std::log(std::sqrt(5. * 13.)), std::log(13. / 5.) / (2 * 1.6449));
      const auto pair = between(sphere{glass, 0.5 * diameter(random) * micrometres}, flat_wall{steel});
      return scene{compose(pair, hertz{},
                           line_force{.force_per_length = force_per_length,
                                      .rebound_coefficient = damping_coefficient_of_brach_dunn(zeta_a, pair, at)},
                           hunt_crossley{.damping_coefficient = damping_coefficient_of_brach_dunn(10.45, pair, at)}),
                   impact{.speed = at}};
    };
    const auto beam = sample_population(draw, 4000);
    std::vector<double> row;
    for (const double p : {0.05, 0.25, 0.5, 0.75, 0.95})
      row.push_back(beam.quantile(p).value);
    row.push_back(beam.captured_fraction().value);
    out.row(v, 1, row);
  }
  out.row(in_si(table_1_speed), 7, {0.62, table_1_restitution});
  out.finish();
}

void figure_A2(const std::string& directory) {
  sheet out(directory, "brach_dunn_1995_figure_A2",
            "energy restitutions of the rigid body of table 1: R = k/(k + v), k 130 m/s, e^2 = R^2 - B",
            {{"speed", "m/s"}, {"R_squared", "1"}, {"e_squared", "1"}, {"adhesion", "1"}});
  for (const double v : logarithmic(0.5, 100, 241)) {
    const auto both = rigid_body_restitutions(v * metres_per_second);
    const double R_squared = square(both[0]), e_squared = square(both[1]);
    out.row(v, 1, {R_squared, e_squared, e_squared / R_squared}); // (1 - rho)^2, (A32)
  }
  out.finish();
}

void figures_7_to_9(const std::string& directory) {
  const auto model = simulation(table_1_diameter, table_1_speed, 10.54, energy_ledger{}, extremes{}, trajectory{});
  const auto out = collide(model, oblique_impact{.speed = table_1_speed, .spin_1 = table_1_spin});
  const auto& t = out.normal.trajectory;
  const std::size_t rows = t.time.size() - 1; // not that of the bodies apart
  const std::string about =
      "table 1: diameter 10.12e-6 m, 2.8 m/s, spin 1.4557e5 rad/s; " + about_simulation + ", zeta_H 10.54";
  const double radius = in_si(model.pair.reduced_radius), mass = in_si(model.pair.reduced_mass);

  sheet force(directory, "brach_dunn_1995_figure_7", about,
              {{"time", "s"}, {"body", "N"}, {"adhesion", "N"}, {"net", "N"}});
  sheet displacement(directory, "brach_dunn_1995_figure_8", about,
                     {{"time", "s"},
                      {"displacement", "m"},
                      {"velocity", "m/s"},
                      {"displacement_over_largest", "1"},
                      {"velocity_over_initial", "1"}});
  sheet loop(directory, "brach_dunn_1995_figure_9", about, {{"displacement", "m"}, {"net_force", "N"}});
  sheet sideways(
      directory, "brach_dunn_1995_tangential_motion", about,
      {{"time", "s"}, {"tangential_velocity", "m/s"}, {"surface_speed", "m/s"}, {"slip", "m/s"}, {"rotation", "deg"}});
  // The trajectory has the motion along the normal; friction adds m d(v_t)/dt = -f F_E while the contact slides and, on
  // a homogeneous sphere, d(slip)/dt = -(7/2) f F_E/m (B7)-(B9), summed here by trapezoids.
  const double slip_before = -radius * in_si(table_1_spin);
  double sliding = std::abs(slip_before), rotation = 0, pressing_before = 0, spin_before = in_si(table_1_spin);
  for (std::size_t i = 0; i < rows; ++i) {
    const length approach = t.mutual_approach[i] * metres, contact = t.contact_radius[i] * metres;
    const double elastic = in_si(model.elastic_force(approach, contact));
    const double damping = in_si(model.damping_force(approach, t.approach_rate[i] * metres_per_second, contact));
    const double net = t.elastic_force[i] + t.damping_force[i];
    force.row(t.time[i], 1, {elastic + damping, net - elastic - damping, net});
    displacement.row(t.time[i], 1,
                     {t.mutual_approach[i], t.approach_rate[i], t.mutual_approach[i] / in_si(out.normal.max_approach),
                      t.approach_rate[i] / in_si(table_1_speed)});
    loop.row(t.mutual_approach[i], 1, {net});

    const double step = i ? t.time[i] - t.time[i - 1] : 0, pressing = friction * elastic;
    sliding = std::max(0., sliding - 3.5 * step * (pressing_before + pressing) / 2 / mass);
    const double slip = std::copysign(sliding, slip_before), taken = 2. / 7 * (slip_before - slip); // impulse/m
    const double spin = in_si(table_1_spin) + 2.5 * taken / radius;
    rotation += step * (spin_before + spin) / 2;
    pressing_before = pressing;
    spin_before = spin;
    sideways.row(t.time[i], 1, {-taken, spin * radius, slip, rotation / degrees});
    if (i + 1 == rows)
      std::printf("  Brach & Dunn 1995, table 1: e %.4f, deepest %.4g m, rebound at %.2f deg, turned by %.4f deg, spin "
                  "%.4g rad/s, lost in adhesion %.3g J\n  summed here: tangential velocity %.4f m/s (collide: %.4f), "
                  "turned by %.4f deg\n",
                  out.normal.restitution.value_or(0), in_si(out.normal.max_approach),
                  out.rebound_angle.value_or(0) / degrees, out.rotation_1 / degrees, in_si(out.spin_1),
                  out.normal.crack_loss * mass * square(in_si(table_1_speed)) / 2, -taken, in_si(out.tangential_speed),
                  rotation / degrees);
  }
  for (sheet* each : {&force, &displacement, &loop, &sideways})
    each->finish();
}

} // namespace

void brach_dunn_1995(const std::string& directory) {
  figures_7_to_9(directory);
  figure_2(directory);
  figure_4(directory);
  figure_6(directory);
  population(directory);
  figure_A2(directory);
}

} // namespace figures
