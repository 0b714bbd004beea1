#pragma once
#include <ricochet/solve/ledger.hpp>

namespace ricochet {

/// The certificate of capture. No law gives energy back, so that a contact with less energy than it has where it lets
/// go never will.
template <class Reduced>
class capture {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using part = configuration<reduced<T>>;

public:
  explicit capture(const Reduced& model) : model_(model) {}

  bool certain() const { return certain_; }

  /// Looks at the contact: where it turns, where it touches again, and where it creeps.
  void look(const part& c, ledger<Reduced>& books) {
    const T left = model_.kinetic_energy(c.rate) + books.meet(c) - model_.exit_energy();
    certain_ = Reduced::adhesive || Reduced::attracted ? value_of(left) < real(0) : never_opens();
  }

  void turned() { steps_since_turning_ = 0; }

  /// To be asked after every step: may this contact be creeping? An overdamped one creeps to its equilibrium without
  /// turning, some even before they have turned once: after many steps, each is to be looked at.
  bool may_creep(const T& rate, bool has_turned, const ledger<Reduced>& books) {
    if (++steps_since_turning_ <= 400)
      return false;
    return has_turned || value_of(model_.kinetic_energy(rate)) < real(1e-6f) * books.largest();
  }

private:
  /// Overdamped without adhesion and pulled until the overlap vanishes, the contact never gets there.
  bool never_opens() const {
    if constexpr (requires { model_.damping.overdamped(); })
      return std::same_as<typename Reduced::model_type::end_condition, end_at_zero_overlap> &&
             model_.damping.overdamped();
    else
      return false;
  }

  const Reduced& model_;
  bool certain_ = false;
  long steps_since_turning_ = 0;
};

} // namespace ricochet
