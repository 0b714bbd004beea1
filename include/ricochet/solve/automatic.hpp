#pragma once
#include <ricochet/solve/rosenbrock.hpp>
#include <ricochet/solve/tsitouras_papakostas.hpp>

namespace ricochet::stepper {

/// Tsitouras-Papakostas 7(5), and Rosenbrock from where the motion proves stiff on: what collide() takes by itself.
struct automatic {
  static constexpr double usual_error = tsitouras_papakostas75::usual_error;

  template <class Flow>
  class method {
    using state_type = typename Flow::state_type;
    using real = typename Flow::real;
    using smooth_method = tsitouras_papakostas75::method<Flow>;
    using reduced_type = std::remove_cvref_t<decltype(std::declval<Flow>().model)>;
    static constexpr bool can_be_stiff = reduced_type::free_edge && std::same_as<double, typename Flow::number>;
    struct none {
      none(const real&, const state_type&) {}
    };
    using stiff_method = typename std::conditional_t<can_be_stiff, std::type_identity<rosenbrock4::method<Flow>>,
                                                     std::type_identity<none>>::type;

  public:
    method(const real& tolerance, const state_type& typical)
        : smooth_(tolerance, typical), stiff_(tolerance, typical), worthwhile_(1 / sqrt(tolerance)) {}

    attempt<state_type, real> try_step(Flow& f, const state_type& x, const real& h) {
      if constexpr (can_be_stiff) {
        if (is_stiff_)
          return stiff_.try_step(f, x, h);
        const auto result = smooth_.try_step(f, x, h);
        if (result.accepted && ++steps_ % 10 == 0)
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
      return smooth_.within(f, x, h);
    }

    void moved() {
      smooth_.moved();
      if constexpr (can_be_stiff)
        stiff_.moved();
      if (hits_ >= 3)
        is_stiff_ = true;
    }

  private:
    /// Counts how often in a row the step was near the explicit method's limit of stability while that is so short that
    /// the implicit method pays.
    void watch(Flow& f, const state_type& x, const real& h) {
      const real rate = rate_of_edge(f, x);
      hits_ = h * rate > 2 && rate > worthwhile_ ? hits_ + 1 : 0;
    }

    /// Rate at which the edge relaxes, |d(dy/d sigma)/dy|, to some digits.
    static real rate_of_edge(Flow& f, const state_type& x) {
      const auto y = reduced_type::coordinate;
      const real part = real(1e-7f) * x[y];
      state_type beside = x, slope{}, slope_beside{};
      beside[y] += part;
      f(x, slope, real(0));
      f(beside, slope_beside, real(0));
      return abs(slope_beside[y] - slope[y]) / part;
    }

    smooth_method smooth_;
    [[no_unique_address]] stiff_method stiff_;
    real worthwhile_;
    long steps_ = 0;
    int hits_ = 0;
    bool is_stiff_ = false;
  };
};

} // namespace ricochet::stepper
