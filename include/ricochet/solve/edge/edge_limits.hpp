#pragma once
#include <ricochet/model/reduced_model.hpp>

#include <optional>

namespace ricochet {

/// Where a free edge is followed as if it were held: so close to an end of its law's range, where its speed has no
/// bound, that the difference of energy is below the errors of the solution. A slow edge, one of bodies large against
/// the cohesive zone, runs there whenever it moves at all, and its law is as good as JKR's with w k while it closes
/// and w/k while it opens; an explicit method would have to follow its relaxation, the faster the slower the edge is.
template <class Reduced>
class edge_limits {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;

public:
  /// The pieces of an edge that is held; others see reduced_model::at().
  static constexpr int closing = -10, opening = -11;
  static constexpr bool holds(int piece) { return piece == closing || piece == opening; }
  /// Share of the step tolerance that a collision errs by whose edge was held, as tests/campaign/maps has it.
  static constexpr float usual_error = 4;
  static constexpr bool exist = [] {
    if constexpr (Reduced::free_edge)
      return limited_crack_law<decltype(Reduced::crack)>;
    else
      return false;
  }();

  explicit edge_limits(const Reduced& model) : model_(model) {}

  /// Solutions at different step tolerances are held at different places, and their difference shows what that does.
  /// \param kinetic energy at touch, of which the edge's losses may be wrong by about the step tolerance
  void allow(const real& kinetic, const real& tolerance) {
    if constexpr (exist) {
      const real energy = kinetic * std::min<real>(tolerance, sqrt(tolerance * real(1e-6f))) / 2;
      const real widest = sqrt(tolerance) / 8;
      const real a = value_of(T(model_.adhesion.equilibrium_radius(model_.pair)));
      const real area = pi<real>() * (2 * value_of(T(model_.pair.reduced_radius)) + 4 * a * a);
      const real at_rest = value_of(T(model_.adhesion.work_of_adhesion)) * area;
      const T lowest = model_.crack.lowest_ratio(), highest = model_.crack.highest_ratio();
      const auto set = [&](place& limit, const T& ratio, int inwards) {
        const real margin = energy / (at_rest * value_of(ratio));
        if (!(margin > real(1e-12f))) // below, round-off decides
          return;
        const real near = inwards * std::min<real>(margin, widest);
        limit = {sqrt(T(ratio * T(1 + near))), sqrt(T(ratio * T(1 + 2 * near)))};
      };
      set(closing_, lowest, 1);
      set(opening_, highest, -1);
    }
  }

  /// > 0 while sqrt(beta) is above that where a closing edge is held; the like for an opening one before the fold.
  T above_lower(const state_type& x) const {
    return closing_.held > T(0) ? T(model_.root_ratio(x) - closing_.held) : T(1);
  }
  T below_upper(const state_type& x, int piece) const {
    return opening_.held > T(0) && !model_.past_fold(model_.contact(x, piece)) ? T(opening_.held - model_.root_ratio(x))
                                                                               : T(1);
  }

  /// > 0 while the bodies move a held edge faster than its law would, somewhat away from the limit: it cannot get there.
  T driven(const state_type& x, int piece) const {
    const bool closes = piece == closing;
    const T excess = model_.speed_beyond_law(x, closes ? closing_.freed : opening_.freed, closes ? 0 : last_piece());
    return closes ? excess : T(-excess);
  }

  /// The state with sqrt(beta) in every digit as the edge was held; round-off might be beyond the limit.
  void release(state_type& x, int piece) const {
    const T root = piece == closing ? closing_.held : opening_.held;
    for (int n = 0; n < 3; ++n)
      x[Reduced::coordinate] -=
          (model_.approach_at(x[Reduced::coordinate], root) - x[mutual_approach]) / model_.approach_gradient(x);
  }

  /// The piece on the other side of the event that leaves this one; nothing if no limit is there.
  static std::optional<int> beyond(int piece, bool up) {
    if (piece == closing)
      return 0;
    if (piece == opening)
      return last_piece();
    if (piece == 0 && !up)
      return closing;
    if (piece == last_piece() && up)
      return opening;
    return std::nullopt;
  }

private:
  /// sqrt(beta) at which an edge is held, and that which the law must be able to keep for it to be free again: twice as
  /// far from the limit, lest errors of the solution lead it back and forth.
  struct place {
    T held = T(0), freed = T(0);
  };

  static constexpr int last_piece() { return int(decltype(Reduced::crack)::joints.size()); }

  const Reduced& model_;
  place closing_, opening_;
};

} // namespace ricochet
