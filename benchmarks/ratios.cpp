// How much faster than its peers, and how near to the machine's limit: time for one collision at the same largest error
// over the same random collisions, all measured in turn in one run, on one thread.
#include "contenders.hpp"
#include "efficiency.hpp"
#include "peer_liggghts.hpp"

#include <ricochet/law/end.hpp>

#include <cstdio>

namespace {
using namespace ricochet;
using namespace ricochet::units;
using contenders::contender;

constexpr std::size_t count = 1000;

std::vector<measure::verdict> verdicts;

/// Ratios wanted at one error: of the batch against odeint's two ways, of lone collisions against the best of odeint
/// and against CVODE; zero where none is.
struct goals {
  double error, batch_bisection, batch_newton, alone_odeint, alone_cvode;
};

/// Goals of batches are for lanes of 512 bits: half as much with 256, and with less, that of a lone collision.
double batch_goal(double full, double alone) {
  constexpr std::size_t lanes = peer::pack::size;
  return lanes >= 8 ? full : lanes == 4 ? full / 2 : std::min(full, alone);
}

void note(const std::string& at, const contender& ours, const contender& theirs, double goal) {
  if (goal > 0 && ours.fits() && theirs.fits())
    verdicts.push_back({at + ours.name + " against " + theirs.name, theirs.seconds / ours.seconds, goal});
}

template <class Instance>
void compare(const Instance& all, const goals& wanted) {
  std::vector<contender> who{contenders::batch(all), contenders::alone(all),
                             contenders::integrated("integrated", all, stepper::automatic{})};
  const auto add = [&](const std::vector<contender>& more) {
    who.insert(who.end(), more.begin(), more.end());
    return who.size() - more.size();
  };
  const std::size_t odeint = add(contenders::of_odeint(all)), cvode = add(contenders::cvode_adams(all));
  add(contenders::in_packs(all));
  for (auto& each : who)
    measure::tune(each, wanted.error, all.expected);
  measure::time_all(who, count, 5, 0.3);
  std::printf("%s, error <= %.0e\n", all.name.c_str(), wanted.error);
  for (const auto& each : who)
    if (each.fits())
      std::printf("  %-48s %9.3f us  (tolerance %.1e, largest error %.1e)\n", each.name.c_str(),
                  1e6 * each.seconds / double(count), each.tolerance, each.error);
    else
      std::printf("  %-48s never gets there\n", each.name.c_str());
  char at[16];
  std::snprintf(at, sizeof at, ", %.0e: ", wanted.error);
  const std::string where = all.name + at;
  note(where, who[0], who[odeint], batch_goal(wanted.batch_bisection, wanted.alone_odeint));
  note(where, who[0], who[odeint + 1], batch_goal(wanted.batch_newton, wanted.alone_odeint));
  note(where, who[1],
       *std::min_element(who.begin() + std::ptrdiff_t(odeint), who.begin() + std::ptrdiff_t(cvode),
                         [](const auto& a, const auto& b) { return a.seconds < b.seconds; }),
       wanted.alone_odeint);
  if (cvode < who.size() && who[cvode].name.starts_with("CVODE"))
    note(where, who[1], who[cvode], wanted.alone_cvode);
}

template <class Instance>
void compare(const Instance& all, const goals& loose, const goals& tight) {
  compare<Instance>(all, loose);
  compare<Instance>(all, tight);
}

/// A discrete-element code's pairs beside the batch, at the code's own error.
template <class Model>
void compare_pairs(const std::string& name, const std::vector<scene<Model>>& kinds,
                   const std::function<peer::discrete_elements_result(double steps_per_contact)>& run) {
  std::vector<scene<Model>> scenes;
  for (std::size_t i = 0; i < peer::pairs_of_spheres::count; ++i)
    scenes.push_back(kinds[i % kinds.size()]);
  std::vector<double> expected;
  for (const auto& s : kinds)
    expected.push_back(integrate(s.model, s.impact, {.tolerance = 1e-11}).restitution.value());
  for (const auto& [steps, goal] : {std::pair{50., 100.}, std::pair{1000., 1000.}}) {
    double theirs = 1e300, ours = 1e300;
    measure::errors error;
    for (int round = 0; round < 5; ++round) {
      const auto found = run(steps);
      if (found.restitution.size() != scenes.size()) {
        std::printf("%s omitted: its run failed\n", name.c_str());
        return;
      }
      theirs = std::min(theirs, found.seconds);
      for (std::size_t i = 0; i < scenes.size(); ++i)
        error.add(found.restitution[i] - expected[i % kinds.size()]);
      for (int repeat = 0; repeat < 20; ++repeat)
        ours = std::min(ours, measure::seconds_of([&] { collide(scenes, {.tolerance = 1e-4, .threads = 1}); }));
    }
    std::printf("%s, t_H/%.0f: %.2f us a collision, largest error %.1e; ricochet, batch: %.3f us\n", name.c_str(),
                steps, 1e6 * theirs / double(scenes.size()), error.largest, 1e6 * ours / double(scenes.size()));
    char at[16];
    std::snprintf(at, sizeof at, "%.0f", steps);
    verdicts.push_back({"batch against " + name + " in steps of t_H/" + at, theirs / ours, goal});
  }
}

/// Pairs of a kind for each damping, ending at zero overlap as both codes have it.
template <class Damping>
auto scenes_of(const peer::pairs_of_spheres& pairs, const std::vector<Damping>& dampings) {
  const contact_pair pair{pairs.reduced_modulus * pascals, pairs.radius / 2 * metres, pairs.mass() / 2 * kilograms};
  std::vector<scene<decltype(compose(pair, hertz{}, dampings[0], end_at_zero_overlap{}))>> scenes;
  for (const auto& damping : dampings)
    scenes.push_back({compose(pair, hertz{}, damping, end_at_zero_overlap{}), impact{pairs.speed * metres_per_second}});
  return scenes;
}

void compare_discrete_elements() {
  const peer::pairs_of_spheres pairs;
  std::vector<double> bulk_times, restitutions;
  std::vector<kuwabara_kono> viscous;
  std::vector<tsuji> constant;
  for (std::size_t i = 0; i < peer::pairs_of_spheres::kinds; ++i) {
    bulk_times.push_back(pairs.contact_time() * 1e-3 * std::pow(100., double(i) / 9));
    viscous.push_back({bulk_times.back() * seconds});
    restitutions.push_back(0.1 + 0.09 * double(i));
    const double log_e = std::log(restitutions.back());
    constant.push_back({-std::sqrt(5.) * log_e / std::hypot(std::numbers::pi, log_e)});
  }
  if (peer::discrete_elements_run::is_installed("lmp"))
    compare_pairs("LAMMPS, Hertz + Kuwabara-Kono", scenes_of(pairs, viscous),
                  [&](double steps) { return peer::lammps(pairs, bulk_times, steps); });
  else
    std::printf("LAMMPS omitted: lmp is not installed (Debian package lammps)\n");
  if (peer::discrete_elements_run::is_installed("liggghts"))
    compare_pairs("LIGGGHTS, Hertz + Tsuji", scenes_of(pairs, constant),
                  [&](double steps) { return peer::liggghts(pairs, restitutions, steps); });
  else
    std::printf("LIGGGHTS omitted: liggghts is not installed (Debian package liggghts)\n");
}

} // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  for (const auto& name : contenders::omitted())
    std::printf("omitted: %s\n", name.c_str());
  efficiency::two_threads threads;
  compare(instances::viscous_hertz(count), {1e-6, 100, 20, 6, 100}, {1e-10, 150, 50, 10, 100});
  threads.again();
  compare(instances::hunt_crossley_hertz(count), {1e-6, 100, 20, 6, 100}, {1e-10, 150, 50, 10, 100});
  compare(instances::tsuji_hertz(count), {1e-6, 0, 0, 6, 100}, {1e-10, 0, 0, 10, 100});
  threads.again();
  compare(instances::brach_dunn(count), {1e-6, 0, 0, 6, 100}, {1e-10, 0, 0, 10, 100});
  compare(instances::static_jkr(count), {1e-6, 0, 0, 6, 100}, {1e-10, 0, 0, 10, 100});
  threads.again();
  compare(instances::viscous_jkr(count), {1e-6, 150, 0, 6, 100}, {1e-10, 150, 0, 10, 100});
  for (const auto& share : efficiency::of_batches())
    verdicts.push_back(share);
  compare_discrete_elements();
  threads.again();
  compare(instances::viscoelastic_jkr_fit(count), {1e-6, 80, 0, 6, 100}, {1e-10, 150, 0, 10, 100});
  threads.again();
  compare(instances::viscoelastic_jkr_exact(count), {1e-6, 80, 0, 6, 100}, {1e-10, 150, 0, 10, 100});
  threads.again();
  std::printf("two threads had %.2f cores at best\n", threads.cores());
  verdicts.push_back({"two threads against one, batch", threads.gain(), 1.9});

  std::size_t met = 0;
  std::printf("\n%-118s %9s %8s\n", "ratio or share", "measured", "goal");
  for (const auto& each : verdicts) {
    std::printf("%-118s %9.3g %2s %5.3g  %s\n", each.name.c_str(), each.figure, each.at_most ? "<=" : ">=", each.goal,
                each.met() ? "met" : "not met");
    met += each.met();
  }
  std::printf("%zu of %zu met\n", met, verdicts.size());
}
