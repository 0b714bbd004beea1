#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>

namespace ricochet::stepper {

/// An explicit Runge-Kutta pair as an odeint Error Stepper, its sums unrolled and without the table's zeros.
/// Table: `order` of the formula that goes on, `error_order` of the one it is compared with, `stages`, a[stage][earlier
/// stage], b[stage] the weights, e[stage] their differences; constant expressions. State: an array of numbers.
template <class Table, class State, class Real>
class explicit_pair {
  static_assert(std::numeric_limits<Real>::digits <= std::numeric_limits<long double>::digits,
                "the table's coefficients are given to the precision of long double: take stepper::fehlberg78");

public:
  using state_type = State;
  using deriv_type = State;
  using value_type = Real;
  using time_type = Real;
  using order_type = unsigned short;
  using stepper_category = boost::numeric::odeint::explicit_error_stepper_tag;
  static constexpr order_type order_value = Table::order, stepper_order_value = order_value,
                              error_order_value = Table::error_order;

  order_type order() const { return order_value; }
  order_type stepper_order() const { return order_value; }
  order_type error_order() const { return error_order_value; }

  /// One step of size h from x, where the slope is known, to `out`; `error` is what the pair's two results differ by.
  template <class System>
  void do_step(System system, const State& x, const State& slope, const Real& t, State& out, const Real& h,
               State& error) {
    do_step(system, x, slope, t, out, h);
    error = State{};
    add([] { return Table::e; }, error, h, every_stage);
  }
  template <class System>
  void do_step(System system, const State& x, const State& slope, const Real& t, State& out, const Real& h) {
    slopes_[0] = slope;
    evaluate(system, x, t, h, every_stage);
    out = x;
    add([] { return Table::b; }, out, h, every_stage);
  }
  template <class System>
  void do_step(System system, State& x, const Real& t, const Real& h) {
    State slope{};
    system(x, slope, t);
    do_step(system, State(x), slope, t, x, h);
  }

private:
  using coefficients = std::array<long double, Table::stages>;
  static constexpr auto every_stage = std::make_index_sequence<Table::stages>{};

  static constexpr Real node(const coefficients& a) {
    long double sum = 0;
    for (const long double each : a)
      sum += each;
    return static_cast<Real>(sum);
  }

  template <class System, std::size_t first, std::size_t... later>
  void evaluate(System& system, const State& x, const Real& t, const Real& h, std::index_sequence<first, later...>) {
    const auto stage = [&]<std::size_t s>(std::integral_constant<std::size_t, s>) {
      State at = x;
      add([] { return Table::a[s]; }, at, h, std::make_index_sequence<s>{});
      system(at, slopes_[s], t + node(Table::a[s]) * h);
    };
    (stage(std::integral_constant<std::size_t, later>{}), ...);
  }

  /// x += h sum of weight_j slope_j; `weights()` are constant expressions.
  template <class Weights, std::size_t... j>
  void add(Weights, State& x, const Real& h, std::index_sequence<j...>) const {
    static constexpr coefficients weight = Weights{}();
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto sum = x[i] - x[i];
      ((weight[j] == 0 ? void() : void(sum += static_cast<Real>(weight[j]) * slopes_[j][i])), ...);
      x[i] += h * sum;
    }
  }

  std::array<State, Table::stages> slopes_{};
};

} // namespace ricochet::stepper
