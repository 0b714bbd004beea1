#pragma once
#include <ricochet/solve/flow.hpp>

namespace ricochet {

/// How a contact that slides or rolls as a whole goes over from one to the other; where no law of the model slides, it
/// is empty and does nothing.
template <class Reduced>
class sliding {
public:
  sliding(const Reduced&, const auto&) {}
  void start(const auto&...) const {}
  const auto& sized(const auto& typical) const { return typical; }
  void touched(const auto&...) const {}
  void flew(const auto&...) const {}
  void report(const auto&...) const {}
};

template <class Reduced>
requires Reduced::slides class sliding<Reduced> {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;

public:
  sliding(const Reduced& model, const real& tolerance)
      : model_(model), soon_(sqrt(tolerance) / 16 * model.typical_time()) {}

  /// First touch. \param spin of a sphere with a peeling moment, else of no consequence
  void start(state_type& x, const T& slip_at_touch, [[maybe_unused]] const T& spin) {
    x[slip] = slip_at_touch;
    if constexpr (Reduced::peels) {
      x[surface_speed] = spin * model_.pair.reduced_radius;
      size_ = max<real>({real(1), abs(value_of(x[slip])), abs(value_of(x[surface_speed]))});
      kinetic_energy_ = model_.kinetic_energy(x[approach_rate]);
    }
  }

  /// Size of the unknowns as the motion along the surface has it, which may be much faster than that along the normal.
  state_type sized(state_type typical) const {
    if constexpr (Reduced::peels) {
      typical[slip] = typical[surface_speed] = typical[slip_distance] = typical[surface_distance] = T(size_);
      typical[friction_loss] = typical[peeling_loss] = T(size_ * size_);
    }
    return typical;
  }

  /// The bodies touch, for the first time or after a flight.
  void touched(flow<Reduced>& flow, state_type& x) const {
    const real speed = value_of(x[slip]);
    flow.direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
    if (flow.direction == 0)
      halted(flow, x);
  }

  /// The contact point stands still: it rolls unless friction could not hold it. It could not near the ends of a
  /// contact, where friction goes as the cube of the contact radius and a peeling moment as the radius; then it slides
  /// the way the sphere turns. Where friction will hold it soon, it rolls at once: it would hardly begin to slide.
  void halted(flow<Reduced>& flow, state_type& x) const {
    x[slip] = T(0);
    flow.direction = 0;
    if constexpr (Reduced::peels) {
      state_type slope{}, then = x;
      flow(x, slope, real(0));
      for (std::size_t i = 0; i < x.size(); ++i)
        then[i] += soon_ * slope[i];
      if (!(value_of(model_.excess_of_friction(model_.contact(then, flow.piece), then[surface_speed])) > 0))
        flow.direction = value_of(x[surface_speed]) > 0 ? 1 : -1;
    }
  }

  /// The bodies have flown freely from x to the touch `next`.
  void flew(const state_type& x, state_type& next) const {
    const T time = next[elapsed_time] - x[elapsed_time];
    next[slip] = x[slip];
    next[slip_distance] = x[slip_distance] + x[slip] * time;
    if constexpr (Reduced::peels) {
      next[surface_speed] = x[surface_speed];
      next[surface_distance] = x[surface_distance] + x[surface_speed] * time;
      next[friction_loss] = x[friction_loss];
      next[peeling_loss] = x[peeling_loss];
    }
  }

  template <class Outcome>
  void report(Outcome& out, const flow<Reduced>& flow, const state_type& x) const {
    out.slip = x[slip];
    out.slip_distance = x[slip_distance];
    out.sticks = flow.direction == 0;
    if constexpr (Reduced::peels) {
      out.spin = x[surface_speed] / model_.pair.reduced_radius;
      out.rotation = x[surface_distance] / model_.pair.reduced_radius;
      if (value_of(x[friction_loss]) > 0) // that of a slip of no more than round-off may be negative
        out.friction_loss = x[friction_loss] / kinetic_energy_;
      out.peeling_loss = x[peeling_loss] / kinetic_energy_;
    }
  }

private:
  const Reduced& model_;
  real soon_, size_ = real(1);
  T kinetic_energy_ = T(1);
};

} // namespace ricochet
