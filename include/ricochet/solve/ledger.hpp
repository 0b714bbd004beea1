#pragma once
#include <ricochet/outcome/outcome.hpp>
#include <ricochet/solve/flow.hpp>

namespace ricochet {

/// Keeps the books of a collision's energy: the jumps at touch and at letting go, which no integral sees, the largest
/// energy met, and what is left at the ending [K appendix C]. Continuous losses are unknowns of the motion.
template <class Reduced>
class ledger {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  using part = typename Reduced::part;

public:
  explicit ledger(const Reduced& model) : model_(model) {}

  void impact(const T& speed) {
    initial_ = model_.kinetic_energy(speed);
    largest_ = value_of(initial_);
  }

  /// The bodies touch, and an adhesive contact jumps to a radius at which it has less than no energy: lost at the edge.
  void touch(const part& c) { jumps_ -= meet(c); }

  /// What is stored when the contact lets go is lost: at the edge with adhesion, in the bulk without.
  void let_go(const part& c) { (Reduced::adhesive || Reduced::attracted ? jumps_ : relaxed_) += meet(c); }

  /// Potential energy of the contact, remembered if it is the largest met.
  T meet(const part& c) {
    const T potential = model_.potential(c);
    largest_ = std::max<real>(largest_, abs(value_of(potential)));
    return potential;
  }

  /// The collision has ended; of separated bodies, what was stored has been booked as lost.
  void close(const part& c, bool separated) {
    remaining_ = model_.kinetic_energy(c.rate);
    excess_ = remaining_;
    if (!separated) {
      remaining_ += model_.potential(c);
      excess_ = remaining_ - model_.exit_energy(c);
    }
  }

  /// Kinetic + elastic + surface energy at the ending, and the largest energy met, kinetic or potential.
  const T& remaining() const { return remaining_; }
  /// What exceeds the energy of a contact that lets go: of separated bodies all, negative when captured.
  const T& excess() const { return excess_; }
  const real& largest() const { return largest_; }

  /// What has been lost so far, at the edge and in the bulk, jumps included.
  T crack_loss_at(const state_type& x) const {
    if constexpr (Reduced::state_type::names::template contains<crack_loss_t>)
      return jumps_ + x[crack_loss];
    else
      return jumps_;
  }
  T bulk_loss_at(const state_type& x) const {
    if constexpr (Reduced::state_type::names::template contains<bulk_loss_t>)
      return relaxed_ + x[bulk_loss];
    else
      return relaxed_;
  }

  T plastic_loss_at([[maybe_unused]] const state_type& x) const {
    if constexpr (Reduced::flows)
      return x[plastic_loss];
    else
      return T(0);
  }

  /// Where the model asks for it: losses and what remains in units of the initial kinetic energy.
  template <class Outcome>
  void report(Outcome& out, const state_type& x) const {
    if constexpr (Reduced::flows) {
      out.plastic_loss = plastic_loss_at(x) / initial_;
      out.residual_approach = model_.contact(x, 0).shape.residual_approach;
    }
    if constexpr (Reduced::model_type::asked.ledger) {
      const T crack = crack_loss_at(x), bulk = bulk_loss_at(x);
      out.crack_loss = crack / initial_;
      out.bulk_loss = bulk / initial_;
      out.remaining_energy = remaining_ / initial_;
      out.ledger_residual = (initial_ - remaining_ - crack - bulk - plastic_loss_at(x)) / largest_;
    }
  }

private:
  const Reduced& model_;
  T initial_ = T(0), jumps_ = T(0), relaxed_ = T(0), remaining_ = T(0), excess_ = T(0);
  real largest_ = 0;
};

} // namespace ricochet
