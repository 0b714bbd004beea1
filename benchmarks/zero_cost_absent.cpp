// That a part of a scene costs nothing where it is not: composed models beside the same equations written by hand.
#include "zero_cost.hpp"

#include "by_hand.hpp"

#include <ricochet/solve/stepper/tsitouras_papakostas.hpp>

#include <cstdio>

namespace zero_cost {
namespace {

bool all_within = true;

/// Seconds for slopes at many states, and for the same steps of the same method, of any system with odeint's call.
template <class Flow, class State>
std::array<std::function<void()>, 2> works_of(Flow& f, const std::vector<State>& states, const State& touch,
                                              const State& typical) {
  return {[&f, &states] {
            State slope{};
            double sum = 0;
            for (int repeat = 0; repeat < 50; ++repeat)
              for (const State& x : states) {
                f(x, slope, 0);
                for (const double each : slope)
                  sum += each;
              }
            measure::keep(sum);
          },
          [&f, touch, typical] {
            using stepper_type = stepper::tsitouras_papakostas75;
            double sum = 0;
            for (int repeat = 0; repeat < 200; ++repeat) {
              typename stepper_type::template method<Flow> method(1e-9, typical);
              State x = touch;
              double h = 1e-3;
              for (int step = 0; step < 40; ++step) {
                const auto tried = method.try_step(f, x, h);
                h = tried.next;
                if (tried.accepted) {
                  x = tried.x;
                  method.moved();
                }
              }
              sum += x[0];
            }
            measure::keep(sum);
          }};
}

/// A composed model's slopes and steps beside those of equations by hand, `piece` of the crack law.
template <class Equations, class Model>
void compare(const char* name, const scene<Model>& s, const std::vector<double>& start, int piece = 0) {
  using numbers_type = reduced_model<double, Model>;
  using state_type = typename numbers_type::state_type;
  static_assert(std::tuple_size_v<typename by_hand::motion<Equations, Equations::size>::state_type> ==
                    state_type::names::size,
                "the model has unknowns that the equations do not need");
  const numbers_type numbers(s.model, scales_at(s.model, s.impact.speed));
  const Equations equations(numbers);
  flow<numbers_type> composed{numbers, piece};
  by_hand::motion<Equations, Equations::size> written{equations};

  std::vector<state_type> states(1000);
  std::vector<std::array<double, Equations::size>> same_states(states.size());
  double difference = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    for (std::size_t j = 0; j < start.size(); ++j)
      same_states[i][j] = states[i][j] = start[j] * (1 + 1e-4 * double(i));
    state_type slope{};
    std::array<double, Equations::size> same_slope{};
    composed(states[i], slope, 0);
    written(same_states[i], same_slope, 0);
    for (std::size_t j = 0; j < start.size(); ++j)
      difference = std::max(difference, std::abs(slope[j] - same_slope[j]) / (1 + std::abs(slope[j])));
  }
  std::array<double, Equations::size> typical{};
  std::copy_n(numbers.typical().begin(), typical.size(), typical.begin());
  const auto ours = works_of(composed, states, states[0], numbers.typical());
  const auto theirs = works_of(written, same_states, same_states[0], typical);
  const auto seconds = measure::least_seconds(200, {ours[0], theirs[0], ours[1], theirs[1]});
  const double slopes = seconds[0] / seconds[1], steps = seconds[2] / seconds[3];
  const bool within = slopes <= 1.03 && steps <= 1.03;
  all_within &= within;
  std::printf("%-38s %8.2f %8.2f %7.3f %9.1f %9.1f %7.3f   %-5s %8.0e\n", name, 1e9 * seconds[0] / 50e3,
              1e9 * seconds[1] / 50e3, slopes, 1e9 * seconds[2] / 8e3, 1e9 * seconds[3] / 8e3, steps,
              within ? "yes" : "no", difference);
}

} // namespace

void absent_parts(const drawn& d) {
  const impact at{1 * metres_per_second};
  std::printf("Absent parts: composed models beside the same equations by hand. Slopes and steps in nanoseconds, least "
              "of 200 interleaved repeats.\n%-38s %8s %8s %7s %9s %9s %7s   %-5s %8s\n",
              "model", "slope", "by hand", "ratio", "step", "by hand", "ratio", "<= 3%", "differ");
  compare<by_hand::hertz_kuwabara_kono>("hertz + kuwabara_kono", scene{compose(d.pair, hertz{}, d.viscous), at},
                                        {0.5, 1});
  compare<by_hand::hertz_hunt_crossley>("hertz + hunt_crossley", scene{compose(d.pair, hertz{}, d.crossley), at},
                                        {0.5, 1});
  compare<by_hand::jkr>("hertz + jkr", scene{compose(d.pair, hertz{}, d.adhesion), at}, {1, 1});
  compare<by_hand::jkr_kuwabara_kono>("hertz + jkr + kuwabara_kono",
                                      scene{compose(d.pair, hertz{}, d.adhesion, d.viscous), at}, {1, 1});
  const scene edge{compose(d.pair, hertz{}, d.adhesion, d.viscous, d.edge), at};
  const reduced_model<double, decltype(edge.model)> n(edge.model, scales_at(edge.model, at.speed));
  const double y = 1.2, c = std::sqrt(2 * std::numbers::pi * n.adhesion.work_of_adhesion / n.pair.reduced_modulus);
  const double approach = y * y * y * y / n.pair.reduced_radius - c * y * 1.5; // G = 2.25 w
  compare<by_hand::opening_edge>("hertz + jkr + kuwabara_kono + greenwood", edge, {y, -0.5, approach}, 1);
  std::printf("all within 3 %%: %s\n", all_within ? "yes" : "no");
}

} // namespace zero_cost
