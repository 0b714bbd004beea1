#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>

namespace ricochet::stepper {

/// An explicit Runge-Kutta method as an odeint Stepper, its sums unrolled and without the table's zeros.
/// Table: `order`, `stages`, a[stage][earlier stage], b[stage] the weights; constant expressions. State: an array of
/// numbers.
template <class Table, class State, class Real>
class explicit_method {
  static_assert(std::numeric_limits<Real>::digits <= std::numeric_limits<long double>::digits,
                "the table's coefficients are given to the precision of long double: take stepper::fehlberg78");

public:
  using state_type = State;
  using deriv_type = State;
  using value_type = Real;
  using time_type = Real;
  using order_type = unsigned short;
  using stepper_category = boost::numeric::odeint::stepper_tag;
  static constexpr order_type order_value = Table::order;

  order_type order() const { return order_value; }

  /// One step of size h from x, where the slope is known, to `out`.
  template <class System>
  void do_step(System system, const State& x, const State& slope, const Real& t, State& out, const Real& h) {
    slopes_[0] = slope;
    evaluate(system, x, t, h, every_stage);
    out = x;
    add([] { return Table::b; }, out, h, every_stage);
  }
  template <class System>
  void do_step(System system, const State& x, const Real& t, State& out, const Real& h) {
    State slope{};
    system(x, slope, t);
    do_step(system, x, slope, t, out, h);
  }
  template <class System>
  void do_step(System system, State& x, const Real& t, const Real& h) {
    do_step(system, State(x), t, x, h);
  }

protected:
  using coefficients = std::array<long double, Table::stages>;
  static constexpr auto every_stage = std::make_index_sequence<Table::stages>{};

  /// x += h sum of weight_j slope_j; `weights()` are constant expressions.
  template <class Weights, std::size_t... j>
  void add(Weights, State& x, const Real& h, std::index_sequence<j...>) const {
    static constexpr coefficients weight = Weights{}();
    static constexpr std::size_t first = first_nonzero(weight);
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto sum = static_cast<Real>(weight[first]) * slopes_[first][i];
      ((j <= first || weight[j] == 0 ? void() : void(sum += static_cast<Real>(weight[j]) * slopes_[j][i])), ...);
      x[i] += h * sum;
    }
  }

  static constexpr std::size_t first_nonzero(const coefficients& weight) {
    std::size_t first = 0;
    while (weight[first] == 0)
      ++first;
    return first;
  }

private:
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

  std::array<State, Table::stages> slopes_{};
};

/// Two methods that share their stages as an odeint Error Stepper.
/// Table: that of the method that goes on, and `error_order` of the one it is compared with, e[stage] the differences
/// of their weights.
template <class Table, class State, class Real>
class explicit_pair : public explicit_method<Table, State, Real> {
  using method = explicit_method<Table, State, Real>;

public:
  using typename method::order_type;
  using stepper_category = boost::numeric::odeint::explicit_error_stepper_tag;
  static constexpr order_type stepper_order_value = Table::order, error_order_value = Table::error_order;

  order_type stepper_order() const { return stepper_order_value; }
  order_type error_order() const { return error_order_value; }

  using method::do_step;
  /// One step of size h from x, where the slope is known, to `out`; `error` is what the pair's two results differ by.
  template <class System>
  void do_step(System system, const State& x, const State& slope, const Real& t, State& out, const Real& h,
               State& error) {
    do_step(system, x, slope, t, out, h);
    error = State{};
    this->add([] { return Table::e; }, error, h, this->every_stage);
  }
};

} // namespace ricochet::stepper
