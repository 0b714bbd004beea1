// Everybody over all tolerances. Instances are compiled in several files, for the compiler's sake.
#pragma once
#include "contenders.hpp"

#include <ricochet/solve/stepper/radau.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <cstdio>

namespace work_precision {
using contenders::contender;
namespace stepper = ricochet::stepper;

/// A row for each tolerance, in decades; nobody is given more than some seconds for one.
inline void scan(const std::string& instance, const contender& who, const std::vector<double>& expected) {
  for (double tolerance = who.loosest; tolerance > 0.99 * who.tightest; tolerance /= 10) {
    std::vector<double> e(expected.size());
    const auto run = [&] {
      for (std::size_t first = 0; first < e.size(); first += who.part)
        who.solve(tolerance, first, std::min(first + who.part, e.size()), e.data());
    };
    double least = 1e300, spent = 0;
    for (int round = 0; round < 5 && spent < 0.3; ++round) {
      const double seconds = measure::seconds_of(run);
      least = std::min(least, seconds);
      spent += seconds;
    }
    measure::errors found;
    for (std::size_t i = 0; i < e.size(); ++i)
      found.add(e[i] - expected[i]);
    std::printf("%s,\"%s\",%.0e,%.2e,%.2e,%.4g\n", instance.c_str(), who.name.c_str(), tolerance, found.largest,
                found.rms(), 1e6 * least / double(e.size()));
    if (spent > 3)
      break;
  }
  std::fflush(stdout);
}

template <class Instance>
std::vector<contender> of_steppers(const Instance& all) {
  using contenders::integrated;
  return {integrated("automatic", all, stepper::automatic{}),
          integrated("tsitouras_papakostas75", all, stepper::tsitouras_papakostas75{}),
          integrated("fehlberg78", all, stepper::fehlberg78{}),
          integrated("dopri5", all, stepper::dopri5{}),
          integrated("cash_karp54", all, stepper::cash_karp54{}),
          integrated("runge_kutta4", all, stepper::runge_kutta4{}),
          integrated("runge_kutta_gill", all, stepper::runge_kutta_gill{}),
          integrated("bulirsch_stoer", all, stepper::bulirsch_stoer{}),
          integrated("bulirsch_stoer_dense_out", all, stepper::bulirsch_stoer_dense_out{}),
          integrated("radau<5>", all, stepper::radau<5>{})};
}

template <class Instance>
void scan_all(const Instance& all) {
  const auto each = [&](const std::vector<contender>& some) {
    for (const auto& who : some) {
      std::fprintf(stderr, "%s: %s\n", all.name.c_str(), who.name.c_str());
      scan(all.name, who, all.expected);
    }
  };
  each({contenders::batch(all), contenders::alone(all)});
  each(of_steppers(all));
  each(contenders::of_odeint(all));
  each(contenders::of_others(all));
  each(contenders::in_packs(all));
}

void without_adhesion(std::size_t count);
void with_adhesion(std::size_t count);
void with_crack_law(std::size_t count);

} // namespace work_precision
