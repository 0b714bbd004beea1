#include <boost/test/unit_test.hpp>

#include "support/odeint_rosenbrock.hpp"
#include "support/reference_rows.hpp"

using namespace support;

namespace {
const ice_case ice;

/// The reduced model of a stiff scene, and a state on its way.
template <class Use>
void on_a_stiff_motion(const Use& use) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-13 * seconds), ice.viscous, energy_ledger{});
  using reduced_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
  const reduced_type numbers(model, scales_at(model, 8.0 * metres_per_second));
  flow<reduced_type> f{numbers};
  stepper::fehlberg78::method<flow<reduced_type>> start(1e-10, numbers.typical());
  auto x = numbers.touch(1.0);
  double h = 1e-3;
  for (int i = 0; i < 60 && numbers.at(x, 0).root_ratio < 0.9; ++i) {
    const auto tried = start.try_step(f, x, std::min(h, 0.02));
    if (tried.accepted)
      x = tried.x;
    start.moved();
    h = tried.next;
  }
  use(numbers, f, x);
}
} // namespace

BOOST_AUTO_TEST_CASE(a_step_is_that_of_odeints_own_class) {
  on_a_stiff_motion([](const auto& numbers, auto& f, const auto& x) {
    using flow_type = std::remove_reference_t<decltype(f)>;
    constexpr std::size_t n = std::remove_cvref_t<decltype(x)>::names::size;
    const auto slope = [&](const double* from, double* to) {
      std::remove_cvref_t<decltype(x)> state{}, dx{};
      std::copy(from, from + n, state.begin());
      f(state, dx, 0.0);
      std::copy(dx.begin(), dx.end(), to);
    };
    // The Jacobian by differences from the reference's side, so that the dual numbers are checked too.
    std::vector<double> jacobian(n * n), low(n), high(n);
    for (std::size_t j = 0; j < n; ++j) {
      auto below = x, above = x;
      const double step = 1e-7 * std::max(std::abs(x[j]), 1e-3);
      below[j] -= step;
      above[j] += step;
      slope(below.data(), low.data());
      slope(above.data(), high.data());
      for (std::size_t i = 0; i < n; ++i)
        jacobian[i * n + j] = (high[i] - low[i]) / (2 * step);
    }
    for (const double h : {1e-3, 1e-2, 0.1}) {
      stepper::rosenbrock4::method<flow_type> ours(1e3, numbers.typical());
      const auto mine = ours.try_step(f, x, h).x;
      std::vector<double> theirs(n);
      odeint_rosenbrock_step(n, slope, jacobian.data(), x.data(), h, theirs.data());
      for (std::size_t i = 0; i < n; ++i) // differences of the Jacobian by differences, 1e-8 relative
        BOOST_TEST(std::abs(mine[i] - theirs[i]) < 1e-6 * h);
    }
  });
}

BOOST_AUTO_TEST_CASE(steps_are_of_order_four) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  using reduced_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
  const reduced_type numbers(model, scales_at(model, 8.0 * metres_per_second));
  flow<reduced_type> f{numbers};
  const auto after = [&](int steps) {
    stepper::rosenbrock4::method<flow<reduced_type>> method(1e3, numbers.typical());
    auto x = numbers.touch(1.0);
    for (int i = 0; i < steps; ++i) {
      x = method.try_step(f, x, 0.5 / steps).x;
      method.moved();
    }
    return x[approach_rate];
  };
  const double exact = after(2048), order = std::log2(std::abs(after(32) - exact) / std::abs(after(64) - exact));
  BOOST_TEST_MESSAGE("order " << order);
  BOOST_TEST(std::abs(order - 4) < 0.3);
}
