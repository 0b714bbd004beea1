#include "efficiency.hpp"

#include "counted.hpp"
#include "instances.hpp"

#include <ricochet/solve/stepper/tsitouras_papakostas.hpp>

#include <cstdio>
#include <span>

namespace efficiency {
using namespace ricochet;
using measure::counted;
using measure::keep;
using measure::seconds_of;

namespace {
using table = stepper::tsitouras_papakostas75_table;

/// Floating-point operations of one step: slopes, stages and error of the pair; no step control, no events.
template <class Model>
double operations_per_step(const Model& model) {
  const reduced_model<counted, Model> numbers(laws_in_si<counted>(model));
  using state_type = typename reduced_model<counted, Model>::state_type;
  stepper::explicit_pair<table, state_type, counted> pair;
  state_type x{}, slope{}, out{}, error{};
  x[numbers.coordinate] = 1;
  const auto system = [&](const state_type& at, state_type& dx, const counted&) { numbers.derivative(at, dx, 0); };
  counted::operations = 0;
  system(x, slope, 0);
  pair.do_step(system, x, slope, counted(0), out, counted(0.1), error);
  return double(counted::operations);
}

/// Floating-point operations a second of fused multiply-adds that do not wait for each other, in the widest registers
/// compiled for.
inline double peak() {
  using pack = xsimd::batch<double>;
  constexpr long rounds = 2'000'000;
  const auto chains = []<std::size_t... i>(std::index_sequence<i...>) {
    std::array<pack, sizeof...(i)> x{pack(1 + 1e-3 * double(i))...};
    const pack factor(1 - 1e-9), term(1e-9);
    for (long round = 0; round < rounds; ++round)
      ((x[i] = xsimd::fma(x[i], factor, term)), ...);
    keep((xsimd::hadd(x[i]) + ...));
  };
  constexpr std::size_t count = 12; // two at a time for a latency of up to six cycles
  const auto seconds = measure::least_seconds(5, {[&] { chains(std::make_index_sequence<count>{}); }});
  return 2 * double(pack::size * count * rounds) / seconds[0];
}

template <class Model>
long evaluations_of(std::span<const scene<Model>> scenes, double tolerance) {
  long sum = 0;
  for (const auto& out : collide(scenes, {.tolerance = tolerance, .threads = 1}))
    sum += out.evaluations;
  return sum;
}

/// Share of the peak that a batch of these scenes reaches: operations of its steps over those the time would hold.
template <class Model>
double share_of_peak(const std::vector<scene<Model>>& scenes, double tolerance, double peak) {
  const double steps = double(evaluations_of<Model>(scenes, tolerance)) / double(table::stages);
  const double seconds =
      measure::least_seconds(20, {[&] { collide(scenes, {.tolerance = tolerance, .threads = 1}); }})[0];
  return steps * operations_per_step(scenes[0].model) / seconds / peak;
}

struct lanes_in_use {
  double spread;   ///< of steps, largest number over least
  double busy;     ///< share of the lanes' time in which they work on a collision
  double lockstep; ///< the same where the lanes wait for the slowest
};

/// Collisions whose numbers of steps differ as far as lanes take them, up to a thousand: hardly any adhesion, and
/// damping up to where it leaves a thousandth of the speed, and explicit steps are short against the rebound. Lanes are
/// busy where all collisions are the longest one; against the time of a step there, that of the mixed ones says how
/// busy they are.
inline lanes_in_use lanes_with_uneven_collisions(std::size_t count) {
  using namespace units;
  using model_type = decltype(compose(contact_pair{}, hertz{}, jkr{}, hunt_crossley{}));
  std::vector<lane_task<model_type>> mixed, longest;
  instances::random_numbers random;
  while (mixed.size() < count) {
    const auto [pair, numbers] = instances::next_pair(random);
    const double w = instances::work_of_adhesion_at(1e-4, numbers), c = random.log_uniform(0.1, 500);
    const auto model = compose(pair, hertz{}, jkr{w * joules_per_square_metre}, hunt_crossley{c * seconds_per_metre});
    mixed.push_back({laws_in_si<double>(model), 1, 1e-2});
  }
  const model_type any = compose(contact_pair{1 * pascals, 1 * metres, 1 * kilograms}, hertz{}, jkr{}, hunt_crossley{});
  lane_solver<model_type, detail::batch_lanes> solver(any, 1'000'000);
  long steps = 0, least = 1000;
  int most = 0;
  const auto solve = [&](const auto& tasks, std::size_t group) {
    steps = 0;
    for (std::size_t first = 0; first + group <= tasks.size(); first += group)
      solver.solve(
          group, [&](std::size_t i) { return tasks[first + i]; },
          [&](std::size_t i, bool, const lane_solution& solution) {
            steps += solution.steps;
            least = std::min<long>(least, solution.steps);
            if (most < solution.steps && &tasks == &mixed) {
              most = solution.steps;
              longest.assign(count / 10, tasks[first + i]);
            }
          });
  };
  solve(mixed, count);
  const double mixed_steps = double(steps);
  solve(longest, longest.size());
  const double ratio = mixed_steps / double(steps);
  const auto seconds = measure::least_seconds(7, {[&] { solve(longest, longest.size()); }, [&] { solve(mixed, count); },
                                                  [&] { solve(mixed, detail::batch_lanes::size / 2); }});
  return {double(most) / double(least), seconds[0] * ratio / seconds[1], seconds[0] * ratio / seconds[2]};
}

/// Steps of a model's motion until the coordinate is below `end` on the way out, with the same method and control as
/// collide() but without looking for events.
template <class Stepper, class Reduced>
void step_without_events(const Reduced& numbers, double speed, double tolerance, double end) {
  flow<Reduced> f{numbers};
  typename Stepper::template method<flow<Reduced>> method(tolerance, numbers.typical());
  auto x = numbers.touch(speed);
  const double longest = numbers.typical_time() * std::min(0.4, std::pow(tolerance, 0.125));
  for (double h = longest / 32; !(x[approach_rate] < 0 && x[numbers.coordinate] < end);) {
    const auto tried = method.try_step(f, x, std::min(h, longest));
    h = tried.next;
    if (tried.accepted) {
      x = tried.x;
      method.moved();
    }
  }
  keep(x[approach_rate]);
}

/// Time of collisions, solved once each, over that of the same steps without events.
template <class Model>
double cost_of_events(const std::vector<scene<Model>>& scenes, double tolerance) {
  using numbers_type = reduced_model<double, Model>;
  using stepper_type = stepper::tsitouras_papakostas75;
  std::vector<numbers_type> numbers;
  std::vector<double> speed;
  for (const auto& s : scenes) {
    const scales unit = scales_at(s.model, s.impact.speed);
    numbers.emplace_back(s.model, unit);
    speed.push_back(reduce<double>(s.impact.speed, unit));
  }
  const auto seconds = measure::least_seconds(
      20, {[&] {
             for (std::size_t i = 0; i < numbers.size(); ++i)
               collision<numbers_type, stepper_type>(numbers[i], tolerance, 1'000'000).solve(speed[i]);
           },
           [&] {
             for (std::size_t i = 0; i < numbers.size(); ++i)
               step_without_events<stepper_type>(numbers[i], speed[i], tolerance, numbers[i].fold_coordinate());
           }});
  return seconds[0] / seconds[1];
}

/// Steps of one collision in all lanes, at both step tolerances of a batch, without looking for events.
template <class Model>
void step_lanes_without_events(const Model& model, speed v, double tolerance) {
  using lanes = detail::batch_lanes;
  using reduced_type = reduced_model<lanes, Model>;
  using state_type = typename reduced_type::state_type;
  auto laws = laws_in_si<lanes>(model);
  const auto unit = laws.scales_at(lanes(in_si(v)));
  const reduced_type numbers(in_scales(laws, model, unit));
  const auto system = [&](const state_type& at, state_type& dx, const lanes&) { numbers.derivative(at, dx, 0); };
  const double end = numbers.fold_coordinate()[0];
  const state_type typical = numbers.typical();
  stepper::explicit_pair<table, state_type, lanes> pair;
  state_type x = numbers.touch(lanes(in_si(v)) * unit.duration / unit.length), slope, next, error{};
  lanes per_error[2] = {lanes(1) / (typical[0] * lanes(tolerance)), lanes(1) / (typical[1] * lanes(tolerance))};
  const lanes longest = typical[0] * min(lanes(1), lanes(2) * sqrt(sqrt(sqrt(lanes(tolerance)))));
  for (lanes h = longest / lanes(8); !(x[approach_rate][0] < 0 && x[numbers.coordinate][0] < end);) {
    system(x, slope, lanes(0));
    pair.do_step(system, x, slope, lanes(0), next, h, error);
    const lanes largest = max(abs(error[0]) * per_error[0], abs(error[1]) * per_error[1]);
    const auto accepted = largest <= lanes(1);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = where(accepted, next[i], x[i]);
    const lanes root = lanes(0.9) / sqrt(sqrt(sqrt(max(largest, lanes(1e-8)))));
    h = min(h * max(min(root, lanes(5)), lanes(0.1)), longest);
  }
  keep(x[approach_rate][0]);
}

/// Time of a batch over that of the same steps without events, each collision in all lanes.
template <class Model>
double cost_of_events_in_lanes(const std::vector<scene<Model>>& scenes, double tolerance) {
  constexpr std::size_t copies = 16;
  std::vector<std::function<void()>> works;
  std::vector<scene<Model>> repeated;
  for (std::size_t i = 0; i < 16; ++i)
    repeated.insert(repeated.end(), copies * detail::batch_lanes::size, scenes[i]);
  const double fine = detail::lane_tolerance<Model>(tolerance);
  const auto seconds = measure::least_seconds(20, {[&] { collide(repeated, {.tolerance = tolerance, .threads = 1}); },
                                                   [&] {
                                                     for (std::size_t i = 0; i < 16; ++i)
                                                       for (std::size_t copy = 0; copy < copies; ++copy)
                                                         for (const double step_tolerance : {fine, fine / 4})
                                                           step_lanes_without_events(
                                                               scenes[i].model, scenes[i].impact.speed, step_tolerance);
                                                   }});
  return seconds[0] / seconds[1];
}

} // namespace

std::vector<measure::verdict> of_batches() {
  const auto polynomial = instances::viscous_jkr(1000); // in ricochet's coordinate
  const auto& scenes = polynomial.scenes;
  const double most = peak();
  std::printf("fused multiply-adds: %.1f Gflop/s; a step of %s: %.0f flop\n", 1e-9 * most, polynomial.name.c_str(),
              operations_per_step(scenes[0].model));
  std::vector<measure::verdict> found;
  for (const double tolerance : {1e-6, 1e-10}) {
    char at[16];
    std::snprintf(at, sizeof at, " at %.0e", tolerance);
    found.push_back({std::string("share of the SIMD peak") + at, share_of_peak(scenes, tolerance, most), 0.6});
    found.push_back({std::string("events in lanes, time with over without") + at,
                     cost_of_events_in_lanes(scenes, tolerance), 1.1, true});
    found.push_back(
        {std::string("events one by one, time with over without") + at, cost_of_events(scenes, tolerance), 1.1, true});
  }
  const auto lanes = lanes_with_uneven_collisions(8000);
  std::printf("lanes: numbers of steps spread %.0f:1\n", lanes.spread);
  found.push_back({"share of time in which lanes are busy", lanes.busy, 0.85});
  found.push_back({"gain over lanes in lockstep", lanes.busy / lanes.lockstep, 3});
  return found;
}

two_threads::two_threads() {
  const auto few = instances::viscous_jkr(1000);
  auto many = few.scenes;
  for (int i = 1; i < 100; ++i)
    many.insert(many.end(), few.scenes.begin(), few.scenes.end());
  run_ = [scenes = std::move(many)](unsigned threads) { collide(scenes, {.tolerance = 1e-6, .threads = threads}); };
}

void two_threads::again() {
  for (int round = 0; round < 5; ++round)
    for (unsigned threads : {1u, 2u}) {
      double computing = 0;
      const double passed = seconds_of(
          measure::wall_seconds, [&] { computing = seconds_of(measure::process_seconds, [&] { run_(threads); }); });
      double& least = least_[threads - 1];
      if (passed < least && threads == 2)
        cores_ = computing / passed;
      least = std::min(least, passed);
    }
}

} // namespace efficiency
