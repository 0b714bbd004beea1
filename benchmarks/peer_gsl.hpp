// Collisions as a competent user of GSL computes them: rk8pd, the last step repeated with Newton's method.
#pragma once
#include "peer_odeint.hpp"

#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace peer {

template <class System>
class gsl_rk8pd {
  using state = typename System::state;
  static constexpr std::size_t size = std::tuple_size_v<state>;

public:
  double operator()(const System& system, double speed, double tolerance, double longest) {
    const gsl_odeiv2_system equations{&slope, nullptr, size, const_cast<System*>(&system)};
    gsl_odeiv2_control_init(control_.get(), tolerance, tolerance, 1, 0);
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_evolve_reset(evolve_.get());
    state x = system.start(speed);
    double t = 0, h = 1e-2;
    while (t < longest) {
      const state before = x;
      const double t_before = t;
      if (gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &equations, &t, longest, &h, x.data()) !=
          GSL_SUCCESS)
        return 0;
      if (has_ended(system, x))
        return newton_at_end(system, speed, t - t_before, [&](double part, state& out) {
          state error;
          out = before;
          gsl_odeiv2_step_apply(step_.get(), 0, part, out.data(), error.data(), nullptr, nullptr, &equations);
        });
    }
    return 0;
  }

private:
  static int slope(double t, const double x[], double dx[], void* system) {
    state at, result;
    std::copy_n(x, size, at.begin());
    (*static_cast<const System*>(system))(at, result, t);
    std::copy_n(result.begin(), size, dx);
    return GSL_SUCCESS;
  }

  template <auto release>
  struct freed {
    void operator()(auto* made) const { release(made); }
  };
  std::unique_ptr<gsl_odeiv2_step, freed<gsl_odeiv2_step_free>> step_{
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size)};
  std::unique_ptr<gsl_odeiv2_control, freed<gsl_odeiv2_control_free>> control_{
      gsl_odeiv2_control_standard_new(1, 1, 1, 0)};
  std::unique_ptr<gsl_odeiv2_evolve, freed<gsl_odeiv2_evolve_free>> evolve_{gsl_odeiv2_evolve_alloc(size)};
};

} // namespace peer
