// 12 Experiment (builds on 10): at which speeds to measure, to learn work of adhesion, relaxation time and strength.
//
// The derivatives of e by the logarithm of each say at which speed a measurement tells which of them; the D-optimal
// plan says how often to measure where, and what errors a fit then has, compared with as many speeds spread evenly in
// log v.
//
// usage: 12_experiment [directory for experiment.csv]
//
// Try next: other expected values, of which the plan depends; candidates nearer to the sticking speed.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/experiment.hpp>
#include <ricochet/study/sweep.hpp>
#include <ricochet/study/table.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <cstdio>

int main(int count, char** arguments) {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const greenwood edge{.modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres};
  const auto crack_table = std::make_shared<const greenwood_table>(edge.modulus_ratio);
  const auto family = [&](const std::array<double, 3>& p) {
    greenwood moving = edge;
    moving.relaxation_time = p[1] * seconds;
    moving.table = crack_table;
    return compose(between(grain, grain), hertz{}, jkr{.work_of_adhesion = p[0] * joules_per_square_metre}, moving,
                   kuwabara_kono{.bulk_time = bulk_time_of_krijt(moving.relaxation_time, 0.25)},
                   thornton_ning{.yield_strength = p[2] * pascals});
  };

  const std::array<double, 3> expected{0.7, 1.2e-11, 2e8}; // J/m^2, s, Pa
  const speed fastest = 60.0 * metres_per_second;
  const speed sticking = sticking_speed(family(expected), 0.1 * metres_per_second, fastest, 1e-6).smallest_separated;

  std::printf(
      "sticking speed %.3f m/s; derivatives of e by the logarithm of each\n  v (m/s)   e        w        T_vis    Y\n",
      in_si(sticking));
  const std::vector<speed> speeds = logarithmic_speeds(1.001 * sticking, fastest, 61);
  const auto e = family_sensitivities(family, expected, speeds);
  for (std::size_t i = 0; i < speeds.size(); i += 5)
    std::printf("%8.3f  %.4f  %+.4f  %+.4f  %+.4f\n", in_si(speeds[i]), e[i].value, e[i].derivative[0],
                e[i].derivative[1], e[i].derivative[2]);

  // [plan]
  // Next to the sticking speed e(v) is too steep: whether a pair bounces at all would hang on what is expected.
  const std::vector<speed> candidates = logarithmic_speeds(1.1 * sticking, fastest, 61);
  const experiment_plan plan = optimal_speeds(family, expected, candidates, {.measurements = 20, .error = 0.01});
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (plan.measurements[i] > 0)
      std::printf("%d measurements at %.2f m/s, where e = %.3f\n", plan.measurements[i], in_si(candidates[i]),
                  plan.restitution[i]);
  // [plan]

  const std::vector<speed> spread = logarithmic_speeds(1.1 * sticking, fastest, 20);
  const Eigen::VectorXd even =
      promised_errors(derivatives_of(family_sensitivities(family, expected, spread)), std::vector(20, 1), 0.01);
  std::printf("standard errors of w, T_vis, Y with 20 measurements of e to 0.01\n");
  std::printf("  as planned        %5.2f %5.2f %5.2f %%\n", 100 * plan.relative_errors[0],
              100 * plan.relative_errors[1], 100 * plan.relative_errors[2]);
  std::printf("  evenly in log v   %5.2f %5.2f %5.2f %%\n", 100 * even[0], 100 * even[1], 100 * even[2]);
  const double excess = plan.optimum.variance.maxCoeff() / 3 - 1;
  std::printf("largest variance over the number of parameters: 1 + %.1e\n", excess);

  if (count > 1) {
    table out(std::filesystem::path(arguments[1]) / "experiment.csv", "12_experiment " + std::string(arguments[1]),
              "what the restitution of water-ice spheres of 2 micrometres tells of 0.7 J/m^2, 1.2e-11 s and 2e8 Pa: "
              "derivatives by their logarithms; of planned measurements their number and the variance function",
              {{"speed", "m/s"},
               {"restitution", "1"},
               {"by_work_of_adhesion", "1"},
               {"by_relaxation_time", "1"},
               {"by_yield_strength", "1"},
               {"planned_speed", "m/s"},
               {"planned_restitution", "1"},
               {"variance_over_parameters", "1"},
               {"measurements", "1"}});
    for (std::size_t i = 0; i < speeds.size(); ++i)
      out.row({in_si(speeds[i]), e[i].value, e[i].derivative[0], e[i].derivative[1], e[i].derivative[2],
               in_si(candidates[i]), plan.restitution[i], plan.optimum.variance[Eigen::Index(i)] / 3,
               double(plan.measurements[i])});
    out.finish();
  }
  return excess < 1e-5 && (plan.relative_errors.array() < even.array()).all() ? 0 : 1;
}
