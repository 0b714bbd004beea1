// The same collisions by roads that share as little as can be: closed forms, ricochet's steppers, lanes and number
// types, and the peers' own equations. Instances are compiled in several files, for the compiler's sake.
#pragma once
#include "contenders.hpp"

#include <ricochet/number/multiprecision.hpp>
#include <ricochet/solve/stepper/radau.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <cstdio>
#include <sstream>

namespace agreement {
using namespace ricochet;

// Tolerances; of ricochet's roads what is wanted, of the peers' what they are asked for.
inline constexpr double of_ricochet = 1e-10, of_long_double = 1e-14, of_fifty_digits = 1e-16, of_peers = 1e-12;

/// Restitutions that somebody found, of the first scenes of an instance; no number where he found no end. Estimates of
/// their errors, unless he has none.
struct road {
  std::string name;
  double tolerance;
  std::vector<double> e, estimate;
  bool bounded() const { return !estimate.empty(); }
};

/// What all found of an instance; `scene(i)` says what scene i is. Prints a table, adds to the CSV, and counts pairs of
/// ricochet's roads and scenes that differ by more than the sum of their estimates.
class report {
public:
  report(std::FILE* csv, std::size_t count);
  void add(const std::string& instance, const std::vector<road>& roads,
           const std::function<std::string(std::size_t)>& scene);

  std::size_t count; ///< of scenes
  std::size_t disagreements = 0;

private:
  std::FILE* csv_;
};

/// By `solve(i)`, which gives an outcome.
template <class Solve>
road by(const std::string& name, double tolerance, std::size_t count, const Solve& solve) {
  road result{name, tolerance, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const auto out = solve(i);
    result.e.push_back(out.restitution ? static_cast<double>(*out.restitution)
                                       : std::numeric_limits<double>::quiet_NaN());
    result.estimate.push_back(out.error_estimate);
  }
  return result;
}

template <class Stepper, class Instance>
road integrated(const std::string& name, const Instance& all, std::size_t count, Stepper stepper) {
  return by(name, of_ricochet, count, [&](std::size_t i) {
    return integrate(all.scenes[i].model, all.scenes[i].impact, {.tolerance = of_ricochet}, stepper);
  });
}

/// ricochet's equations in another number type.
template <class T, class Stepper, class Instance>
road in_numbers(const std::string& name, const Instance& all, double tolerance, std::size_t count, Stepper) {
  return by(name, tolerance, count, [&](std::size_t i) {
    const auto& [model, impact] = all.scenes[i];
    const scales unit = scales_at(model, impact.speed);
    const reduced_model<T, std::remove_cvref_t<decltype(model)>> numbers(model, unit);
    return detail::solve_to_tolerance<Stepper>(numbers, reduce<T>(impact.speed, unit), T(0), T(0),
                                               {.tolerance = tolerance, .max_evaluations = 40'000'000});
  });
}

inline road of_peer(const contenders::contender& who, std::size_t count) {
  road result{who.name, of_peers, std::vector<double>(count), {}};
  for (std::size_t first = 0; first < count; first += who.part)
    who.solve(of_peers, first, std::min(first + who.part, count), result.e.data());
  for (double& e : result.e)
    if (!(e > 0)) // what peers give where they found no end
      e = std::numeric_limits<double>::quiet_NaN();
  return result;
}

/// The numbers of a scene, in SI.
template <class Model>
std::string numbers_of(const scene<Model>& s) {
  std::ostringstream text;
  text.precision(17);
  text << "E* " << in_si(s.model.pair.reduced_modulus) << ", R " << in_si(s.model.pair.reduced_radius) << ", m* "
       << in_si(s.model.pair.reduced_mass) << ", speed " << in_si(s.impact.speed);
  const auto add = [&](const auto& law) {
    if constexpr (requires { law.parameters(); })
      std::apply([&](const auto&... p) { ((text << ", " << p.name << ' ' << in_si(law.*(p.member))), ...); },
                 law.parameters());
  };
  add(s.model.adhesion);
  add(s.model.crack);
  add(s.model.damping);
  return text.str();
}

template <class Instance>
void compare(const Instance& all, report& to) {
  using model_type = std::remove_cvref_t<decltype(all.scenes[0].model)>;
  const std::size_t count = all.scenes.size();
  // The slow ones solve a part of the scenes: those of low order, and numbers of 50 digits, which take seconds each.
  const std::size_t part = count / 5, few = std::min<std::size_t>(count, model_type::has_crack_law ? 3 : 20);
  std::vector<road> roads;
  if constexpr (closed_form::solved<model_type>)
    roads.push_back(by("closed form", of_ricochet, count, [&](std::size_t i) {
      return collide(all.scenes[i].model, all.scenes[i].impact, {.tolerance = of_ricochet});
    }));
  roads.push_back(integrated("automatic", all, count, stepper::automatic{}));
  roads.push_back(integrated("tsitouras_papakostas75", all, count, stepper::tsitouras_papakostas75{}));
  roads.push_back(integrated("fehlberg78", all, count, stepper::fehlberg78{}));
  roads.push_back(integrated("dopri5", all, count, stepper::dopri5{}));
  roads.push_back(integrated("cash_karp54", all, count, stepper::cash_karp54{}));
  roads.push_back(integrated("runge_kutta4", all, part, stepper::runge_kutta4{}));
  roads.push_back(integrated("bulirsch_stoer", all, count, stepper::bulirsch_stoer{}));
  roads.push_back(integrated("bulirsch_stoer_dense_out", all, count, stepper::bulirsch_stoer_dense_out{}));
  roads.push_back(integrated("radau<5>", all, count, stepper::radau<5>{}));
  const auto lanes = collide(all.scenes, {.tolerance = of_ricochet, .threads = 1});
  roads.push_back(by("batch", of_ricochet, count, [&](std::size_t i) { return lanes[i]; }));
  roads.push_back(
      in_numbers<long double>("long double", all, of_long_double, count, stepper::tsitouras_papakostas75{}));
  roads.push_back(in_numbers<multiprecise<50>>("50 digits", all, of_fifty_digits, few, stepper::fehlberg78{}));
  for (const auto& who : contenders::of_odeint(all))
    roads.push_back(of_peer(who, count));
  for (const auto& who : contenders::of_others(all))
    roads.push_back(of_peer(who, who.name.starts_with("CVODE BDF") ? part : count));
  if (const auto packs = contenders::in_packs(all); !packs.empty())
    roads.push_back(of_peer(packs[0], count)); // the other one's steps are fixed
  to.add(all.name, roads, [&](std::size_t i) { return numbers_of(all.scenes[i]); });
}

void without_adhesion(report& to);
void with_adhesion(report& to);
void with_crack_law(report& to);

} // namespace agreement
