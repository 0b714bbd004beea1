// The motion along the surface of a contact that sticks and slips, marched beside the normal motion, which it never
// changes.
#pragma once
#include <ricochet/solve/flow.hpp>
#include <ricochet/solve/oblique/spring_bed.hpp>

#include <array>
#include <utility>

namespace ricochet {

/// Speed and way of the contact point over a bed of springs, by steps of second order (Verlet's).
template <class Reduced>
class stick_slip_motion {
  using T = typename Reduced::number;

public:
  explicit stick_slip_motion(const Reduced& model)
      : bed_(model.tangential, model.pair), mass_(T(2) / T(7) * model.pair.reduced_mass), // of homogeneous spheres
        friction_slope_(model.tangential.largest_stretch(T(1))) {}

  /// First touch.
  void start(const T& slip) { slip_ = slip; }

  /// The bodies touch, for the first time or after a flight.
  void touch(const T& time, const T& rate) {
    limit_rate_ = friction_slope_ * rate;
    way_ += slip_ * (time - time_);
    time_ = time;
    acceleration_ = T(0);
    bed_.touch();
  }

  void advance(const configuration<reduced<T>>& c, const T& time) {
    const T dt = time - time_;
    const T moved = (slip_ + acceleration_ * dt / T(2)) * dt;
    const T slip_now = slip_ + acceleration_ * dt, limit_now = friction_slope_ * c.rate;
    const T forwards = come_back(slip_ - limit_rate_, slip_now - limit_now, dt);
    const T backwards = come_back(-slip_ - limit_rate_, -slip_now - limit_now, dt);
    const T before = std::exchange(acceleration_, -bed_.force(c, moved, forwards, backwards) / mass_);
    limit_rate_ = limit_now;
    slip_ += (before + acceleration_) * dt / T(2);
    way_ += moved;
    time_ = time;
  }

  const T& slip() const { return slip_; }
  const T& way() const { return way_; }
  bool sticks() const { return bed_.sticks(); }

private:
  /// Springs slip while the contact point runs ahead of friction's limit, by this excess of speed. Where it falls below
  /// zero within the step, they have come back from the limit by this much at its end.
  static T come_back(const T& excess, const T& excess_now, const T& dt) {
    if (!(value_of(excess) > 0 && value_of(excess_now) < 0))
      return T(0);
    return excess_now * excess_now * dt / (T(2) * (excess - excess_now));
  }

  spring_bed<T, std::remove_cvref_t<decltype(std::declval<Reduced>().tangential)>> bed_;
  T mass_, friction_slope_, limit_rate_ = T(0), slip_ = T(0), way_ = T(0), time_ = T(0), acceleration_ = T(0);
};

/// Watches a collision step by step for the motion along its surface; where no law of the model sticks and slips, it is
/// empty and does nothing.
template <class Reduced>
class stick_slip {
public:
  stick_slip(const Reduced&, const auto&) {}
  void start(const auto&) {}
  void touched(const auto&) {}
  void stepped(const auto&...) {}
  void report(const auto&) const {}
};

/// Three beds, each of twice as many springs as the one before. Their errors go as 1/springs^2, so that two together
/// give a better result than either, and how much the third betters it is the measure of the error.
template <class Reduced>
requires Reduced::sticks_and_slips class stick_slip<Reduced> {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  using motion = stick_slip_motion<Reduced>;

public:
  /// tolerance: of the steps. The cost goes as springs^2: the error is let go as tolerance^(2/3).
  stick_slip(const Reduced& model, const real& tolerance)
      : springs_(min<real>(exp(-log(tolerance) / 3), real(4096))),
        longest_part_(model.typical_time() / springs_), motions_{motion(model), motion(model), motion(model)} {}

  void start(const T& slip) {
    first_slip_ = value_of(slip);
    for (motion& each : motions_)
      each.start(slip);
  }

  void touched(const state_type& x) {
    for (motion& each : motions_)
      each.touch(x[elapsed_time], x[approach_rate]);
  }

  /// A step of size h of the normal motion has led from x to `reached`.
  template <class Method>
  void stepped(flow<Reduced>& flow, Method& method, const state_type& x, const state_type& reached, const real& h) {
    const long parts = 4 * (static_cast<long>(h / (4 * longest_part_)) + 1);
    for (long i = 1; i <= parts; ++i) {
      const state_type now = i == parts ? reached : method.within(flow, x, h * real(i) / real(parts));
      const auto c = flow.model.contact(now, flow.piece);
      for (const long coarsening : {0, 1, 2})
        if (i % (1 << coarsening) == 0)
          motions_[2 - std::size_t(coarsening)].advance(c, now[elapsed_time]);
    }
  }

  template <class Outcome>
  void report(Outcome& out) const {
    const auto& [coarsest, coarse, fine] = motions_;
    const auto better = [](const T& finer, const T& coarser) { return T(finer + (finer - coarser) / T(3)); };
    out.slip = better(fine.slip(), coarse.slip());
    out.slip_distance = better(fine.way(), coarse.way());
    out.sticks = fine.sticks();
    const real bettered = abs(value_of(out.slip - better(coarse.slip(), coarsest.slip())));
    if (first_slip_ > real(0)) // now and then, both are the same by chance
      out.slip_error_estimate =
          static_cast<double>(real(1.5f) * bettered / first_slip_ + usual_error / (springs_ * springs_));
  }

private:
  static constexpr real usual_error = real(0.03f);

  real springs_, longest_part_, first_slip_ = 0;
  std::array<motion, 3> motions_;
};

} // namespace ricochet
