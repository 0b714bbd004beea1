#pragma once
#include <ricochet/model/reduced_model.hpp>

namespace ricochet {

/// A reduced model as an odeint System, with what the solver must know of its last evaluations. Copy-free: pass it by
/// std::ref.
template <class Reduced>
struct flow {
  using state_type = typename Reduced::state_type;
  using number = typename Reduced::number;
  using real = real_of<number>;

  const Reduced& model;
  int piece = 0;        ///< of the crack law, or 1 while plastic flow goes on; held during a step: steps are smooth
  int direction = 0;    ///< in which the contact point slides, 0 while it rolls; held likewise
  real least_clock = 0; ///< > 0: time is slowed as the bodies move the edge, not by its own law, and not below this
  bool outside = false; ///< set when a stage left the domain of the equations; its step has to be rejected
  long evaluations = 0;

  /// Plastic flow begins or ends. Where it begins, radius and largest radius are the same in every digit and
  /// derivative.
  void set_plastic(bool begins, state_type& x) requires Reduced::flows {
    piece = begins ? 1 : 0;
    if (begins)
      x[largest_coordinate] = x[Reduced::coordinate];
  }

  void operator()(const state_type& x, state_type& dx, const real&) {
    ++evaluations;
    outside |= !model.derivative(x, dx, piece, direction, least_clock);
  }
};

} // namespace ricochet
