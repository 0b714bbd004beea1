// Everybody who computes an instance's collisions: ricochet in its ways, and the peers there are.
#pragma once
#include "instances.hpp"
#include "measure.hpp"
#include "peer_odeint.hpp"
#include "peer_packs.hpp"
#if RICOCHET_WITH_GSL
#include "peer_gsl.hpp"
#endif
#if RICOCHET_WITH_SUNDIALS
#include "peer_sundials.hpp"
#endif

#include <ricochet/solve/stepper/steppers.hpp>

#include <memory>
#include <span>

namespace contenders {
using measure::contender;

/// A way to compute one collision, `solve(i, tolerance)`.
template <class Solve>
contender one_by_one(const std::string& name, const Solve& solve) {
  return {name, [solve](double tolerance, std::size_t first, std::size_t last, double* e) {
            for (std::size_t i = first; i < last; ++i)
              e[i] = solve(i, tolerance);
          }};
}

template <class Instance>
contender batch(const Instance& all) {
  contender result{"ricochet, batch", [&all](double tolerance, std::size_t first, std::size_t last, double* e) {
                     const auto out = collide(std::span(all.scenes).subspan(first, last - first),
                                              {.tolerance = tolerance, .threads = 1});
                     for (std::size_t i = first; i < last; ++i)
                       e[i] = out[i - first].restitution.value_or(0);
                   }};
  result.tightest = 1e-12;
  result.part = 250;
  return result;
}

template <class Instance>
contender alone(const Instance& all) {
  contender result = one_by_one("ricochet, one by one", [&all](std::size_t i, double tolerance) {
    return collide(all.scenes[i].model, all.scenes[i].impact, {.tolerance = tolerance}).restitution.value_or(0);
  });
  result.tightest = 1e-12;
  return result;
}

/// By integration, even where there is a closed form.
template <class Stepper, class Instance>
contender integrated(const std::string& name, const Instance& all, Stepper stepper) {
  contender result = one_by_one("ricochet, " + name, [&all, stepper](std::size_t i, double tolerance) {
    return integrate(all.scenes[i].model, all.scenes[i].impact, {.tolerance = tolerance}, stepper)
        .restitution.value_or(0);
  });
  result.tightest = 1e-12;
  return result;
}

/// A peer's `solve(system, speed, tolerance, longest)`, in units in which the impact's speed is one.
template <class Instance, class Solve>
contender of_peer(const std::string& name, const Instance& all, const Solve& solve) {
  return one_by_one(name, [&all, solve](std::size_t i, double tolerance) {
    return solve(all.systems[i], 1., tolerance, instances::longest);
  });
}

/// The same of one that keeps its memory from collision to collision.
template <class Solver, class Instance, class... Arguments>
contender of_solver(const std::string& name, const Instance& all, Arguments... arguments) {
  return of_peer(name, all,
                 [solver = std::make_shared<Solver>(arguments...)](const auto&... with) { return (*solver)(with...); });
}

/// A peer's solve() of as many collisions as a pack has lanes.
template <template <class> class Equations, class Instance, class Solve>
contender of_packs(const std::string& name, const Instance& all, const Solve& solve) {
  contender result{name, [&all, solve](double tolerance, std::size_t first, std::size_t last, double* e) {
                     for (std::size_t i = first; i + peer::pack::size <= last; i += peer::pack::size)
                       solve(peer::side_by_side<Equations, peer::pack>(&all.systems[i]), 1., tolerance,
                             instances::longest)
                           .store_unaligned(e + i);
                   }};
  result.part = 40;
  return result;
}

template <class Instance>
struct equations_of;
template <class Model, template <class> class Equations>
struct equations_of<instances::instance<Model, Equations<double>>> {
  template <class T>
  using type = Equations<T>;
};

template <class Instance>
std::vector<contender> of_odeint(const Instance& all) {
  const auto dopri5_bisection = [](const auto&... with) { return peer::dopri5_bisection(with...); };
  const auto dopri5_newton = [](const auto&... with) { return peer::dopri5_newton(with...); };
  const auto bulirsch_stoer = [](const auto&... with) { return peer::bulirsch_stoer_bisection(with...); };
  return {of_peer("odeint dopri5, dense output, bisection", all, dopri5_bisection),
          of_peer("odeint dopri5, Newton", all, dopri5_newton),
          of_peer("odeint bulirsch_stoer, dense output, bisection", all, bulirsch_stoer)};
}

/// CVODE by Adams' method, if it is here.
template <class Instance>
std::vector<contender> cvode_adams([[maybe_unused]] const Instance& all) {
#if RICOCHET_WITH_SUNDIALS
  using system = std::remove_cvref_t<decltype(all.systems[0])>;
  return {of_solver<peer::cvode<system>>("CVODE Adams, root finding", all, CV_ADAMS)};
#else
  return {};
#endif
}

template <class Instance>
std::vector<contender> of_others(const Instance& all) {
  using system [[maybe_unused]] = std::remove_cvref_t<decltype(all.systems[0])>;
  std::vector<contender> result = cvode_adams(all);
#if RICOCHET_WITH_GSL
  result.push_back(of_solver<peer::gsl_rk8pd<system>>("GSL rk8pd, Newton", all));
#endif
#if RICOCHET_WITH_SUNDIALS
  result.push_back(of_solver<peer::cvode<system>>("CVODE BDF, root finding", all, CV_BDF));
  result.push_back(
      of_solver<peer::arkode<system>>("ARKODE Dormand-Prince 5(4), root finding", all, ARKODE_DORMAND_PRINCE_7_4_5));
  result.push_back(of_solver<peer::arkode<system>>("ARKODE Verner 6(5), root finding", all, ARKODE_VERNER_8_5_6));
#endif
  return result;
}

template <class Instance>
std::vector<contender> in_packs(const Instance& all) {
  if constexpr (std::remove_cvref_t<decltype(all.systems[0])>::in_packs) {
    const auto dopri5 = [](const auto&... with) { return peer::dopri5_in_packs(with...); };
    const auto verlet = [](const auto&... with) { return peer::verlet_in_packs(with...); };
    std::vector<contender> result{
        of_packs<equations_of<Instance>::template type>("odeint dopri5, SIMD packs in step", all, dopri5),
        of_packs<equations_of<Instance>::template type>("Verlet, SIMD packs, fixed step", all, verlet)};
    result[1].tightest = 1e-5;
    return result;
  } else
    return {};
}

/// Peers that could be here and are not.
inline std::vector<std::string> omitted() {
  std::vector<std::string> names;
#if !RICOCHET_WITH_GSL
  names.push_back("GSL rk8pd (Debian package libgsl-dev)");
#endif
#if !RICOCHET_WITH_SUNDIALS
  names.push_back("CVODE and ARKODE (Debian package libsundials-dev)");
#endif
  return names;
}

} // namespace contenders
