#pragma once
#include <ricochet/solve/stepper/radau.hpp>
#include <ricochet/solve/stepper/tsitouras_papakostas.hpp>

namespace ricochet::stepper {

/// Tsitouras-Papakostas 7(5), and Radau IIA from where the edge proves much faster than the bodies on: what collide()
/// takes by itself.
struct automatic {
  static constexpr double usual_error = tsitouras_papakostas75::usual_error;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using smooth_method = tsitouras_papakostas75::method<Flow>;
    using reduced_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;
    static constexpr bool can_be_stiff = reduced_type::free_edge && std::same_as<double, typename Flow::number>;
    using differentiable_model = reduced_model<gradient<real, 1>, typename reduced_type::model_type>;
    struct none {
      none(const real&, const state_type&) {}
    };
    using stiff_method = typename std::conditional_t<can_be_stiff, std::type_identity<radau<5>::method<Flow>>,
                                                     std::type_identity<none>>::type;

  public:
    method(const real& tolerance, const state_type& typical)
        : smooth_(tolerance, typical), stiff_(tolerance, typical), worthwhile_(12 / sqrt(sqrt(sqrt(tolerance)))),
          close_(sqrt(tolerance) / 10) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      if constexpr (can_be_stiff) {
        if (is_stiff_)
          return stiff_.try_step(f, x, h);
        f.least_clock = 0;
        const auto result = smooth_.try_step(f, x, h);
        bounces_ += !result.accepted && f.outside;
        if (result.accepted &&
            h * worthwhile_ < 3 && // an explicit method takes longer steps only where nothing is stiff
            (++steps_ % every == 0 || bounces_ > 8))
          watch(f, x, h);
        return result;
      } else {
        return smooth_.try_step(f, x, h);
      }
    }

    state_type within(Flow& f, const state_type& x, const real& h) {
      if constexpr (can_be_stiff)
        if (is_stiff_)
          return stiff_.within(f, x, h);
      f.least_clock = 0;
      return smooth_.within(f, x, h);
    }

    void moved() {
      smooth_.moved();
      if constexpr (can_be_stiff)
        stiff_.moved();
      is_stiff_ |= proves_stiff_;
    }

    /// Does the edge keep to the motion of the bodies, so that its law's kinks hardly show?
    bool glides() const {
      if constexpr (can_be_stiff)
        return is_stiff_ && stiff_.glides();
      else
        return false;
    }

    /// Of the less exact of the methods that have been used.
    double usual_error() const { return is_stiff_ ? stiff_usual_error : smooth_usual_error; }

  private:
    static constexpr double smooth_usual_error = automatic::usual_error;
    static constexpr double stiff_usual_error = 0.02; ///< of Radau IIA on what is left to it: tests/solve/accuracy.cpp

    /// Is the edge's relaxation so fast that the implicit method pays, and does it limit the step h? Or will it, since
    /// the edge has come so close to rest that what is left of its run hardly matters? A slow edge is stiff only where
    /// it hugs the limit of its law: there explicit steps bounce off, or stay short for very long.
    void watch(Flow& f, const state_type& x, const real& h) {
      if (!edge_) {
        edge_.emplace(f.model);
        differentiable_.emplace(f.model);
      }
      const real clock = f.model.at(x, f.piece).clock, gap = abs(f.model.root_ratio(x) - 1);
      const real rate = relaxation_rate(f, x);
      if (edge_->excess() < radau<5>::fast_enough)
        proves_stiff_ = rate > worthwhile_ * cube(clock) && (gap < close_ || h * rate > real(0.2));
      else
        proves_stiff_ = (rate * close_ > real(0.1) && h * rate > 1) ||
                        (rate > worthwhile_ / 8 && (bounces_ > 8 || (short_steps_ += every) > 300));
    }

    /// Of sqrt(beta), to lowest order: minus the trace of the derivatives of y and delta, on which it depends.
    real relaxation_rate(Flow& f, const state_type& x) {
      const auto derivative_by_itself = [&](auto unknown) -> real {
        typename differentiable_model::state_type seeded{}, slope{};
        std::copy(x.begin(), x.end(), seeded.begin());
        seeded[unknown] = gradient<real, 1>::seeded(x[unknown], 0);
        differentiable_->derivative(seeded, slope, f.piece, f.direction);
        ++f.evaluations;
        return slope[unknown].slope[0];
      };
      const auto y = reduced_type::coordinate;
      return -derivative_by_itself(y) - derivative_by_itself(mutual_approach);
    }

    smooth_method smooth_;
    [[no_unique_address]] stiff_method stiff_;
    std::optional<fast_edge<reduced_type>> edge_;
    std::optional<differentiable_model> differentiable_;
    real worthwhile_, close_;
    static constexpr int every = 4; ///< steps, is the edge watched: that takes as long as three stages
    int steps_ = 0;
    int short_steps_ = 0; ///< explicit ones, of an edge that relaxes faster than that
    int bounces_ = 0;     ///< explicit steps rejected because they led beyond the limit of the edge's law
    bool proves_stiff_ = false, is_stiff_ = false;
  };
};

} // namespace ricochet::stepper
