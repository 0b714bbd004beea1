#pragma once
#include <ricochet/solve/edge/slow_edge.hpp>
#include <ricochet/solve/ledger.hpp>

#include <vector>

namespace ricochet {

/// The certificate of capture. No law gives energy back, so that a contact with less energy than it has where it lets
/// go never will; and one with more may be held by an edge too slow to open (slow_edge.hpp).
template <class Reduced>
class capture {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using part = typename Reduced::part;

public:
  explicit capture(const Reduced& model) : model_(model), slow_edge_(model) {}

  bool certain() const { return certain_; }

  /// Looks at the contact where it turns and where it touches again.
  void look(const part& c, ledger<Reduced>& books) {
    steps_since_look_ = 0;
    const T left = look_closely(c, books);
    if (margins_.size() < 64)
      margins_.push_back(value_of(left));
  }

  /// Energy beyond that where the contact lets go, at the first looks: two solutions of one collision are to be
  /// compared look by look, since they may be certain at different ones.
  const std::vector<real>& margins() const { return margins_; }

  /// Looks at a contact between turns.
  T look_closely(const part& c, ledger<Reduced>& books) {
    const T left = model_.kinetic_energy(c.rate) + books.meet(c) - model_.exit_energy(c);
    certain_ = ((Reduced::adhesive || Reduced::attracted) && value_of(left) < real(0)) || never_opens(c);
    if constexpr (Reduced::free_edge)
      if (!certain_) {
        held_by_ = slow_edge_.reserve(c, T(left + model_.exit_energy(c)));
        certain_ = held_by_.has_value();
      }
    return left;
  }

  /// Energy by which a contact is certain to be held that has more than it would have apart; nothing for others.
  const std::optional<real>& held_by() const { return held_by_; }

  /// To be asked after every step: is this contact to be looked at though it has not turned? An overdamped one creeps
  /// to its equilibrium without turning, some even before they have turned once, and an edge at the limit of its law
  /// may take very many steps to the first turn.
  bool is_late(const T& rate, bool has_turned, const ledger<Reduced>& books) {
    constexpr long many = 400;
    if (++steps_since_look_ <= many)
      return false;
    return has_turned || value_of(model_.kinetic_energy(rate)) < real(1e-6f) * books.largest() ||
           steps_since_look_ % many == 0;
  }

private:
  /// Overdamped and held until the overlap vanishes, the contact never gets there: with F ~ delta^q and F_D = c rate, c
  /// ~ delta^p, 2p + 1 <= q, c^2 >= 4(1 + p) m* F/delta holds at every smaller overlap too (if 2p + 1 = q, at every
  /// one), and a rate above -c delta/(2(1 + p)m*) stays so, all the more under a pull.
  bool never_opens(const part& c) const {
    if constexpr (has_powers() && held_to_zero_overlap) {
      if constexpr (Reduced::adhesive)
        if (value_of(T(model_.adhesion.work_of_adhesion)) != real(0)) // it ends at the fold
          return false;
      const real p = real(decltype(model_.damping)::coefficient_power), m = value_of(T(model_.pair.reduced_mass));
      const real stiffness = value_of(model_.elastic.force(model_.pair_of(c), c)) / value_of(c.approach);
      const real coefficient = value_of(model_.damping.coefficient(model_.pair_of(c), c));
      const real enough = 4 * (1 + p) * m * stiffness * (1 - 16 * std::numeric_limits<real>::epsilon());
      const bool deepens = value_of(c.rate) > real(0) && !same_at_every_depth();
      return !deepens && coefficient * coefficient >= enough &&
             value_of(c.rate) >= -coefficient * value_of(c.approach) / (2 * (1 + p) * m);
    } else {
      return false;
    }
  }

  static constexpr bool held_to_zero_overlap =
      (Reduced::adhesive && !Reduced::free_edge && !Reduced::flows) ||
      (!Reduced::cohesive && std::same_as<typename Reduced::model_type::end_condition, end_at_zero_overlap>);

  static constexpr bool has_powers() {
    using elastic = decltype(Reduced::elastic);
    using damping = decltype(Reduced::damping);
    if constexpr (requires { elastic::force_power, damping::coefficient_power; })
      return 2 * damping::coefficient_power + 1 <= elastic::force_power;
    else
      return false;
  }

  static constexpr bool same_at_every_depth() {
    return 2 * decltype(Reduced::damping)::coefficient_power + 1 == decltype(Reduced::elastic)::force_power;
  }

  const Reduced& model_;
  slow_edge<Reduced> slow_edge_;
  bool certain_ = false;
  std::optional<real> held_by_;
  long steps_since_look_ = 0;
  std::vector<real> margins_;
};

} // namespace ricochet
