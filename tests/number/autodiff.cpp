#include <boost/test/unit_test.hpp>

#include <ricochet/number/autodiff.hpp>
#include <ricochet/number/multiprecision.hpp>

#include "support/every_law.hpp"
#include "support/reference_rows.hpp"

using namespace support;
using fine = multiprecise<50>;

namespace {

double deviation(double found, double expected) { return std::abs(found / expected - 1); }

/// de/dp of a collision at this speed by dual numbers, and by central differences in 50 digits. `parameter(model,
/// speed)` is a reference to p.
template <class Model, class Parameter>
std::pair<double, double> derivative_of_restitution(const Model& model, speed v, const Parameter& parameter) {
  const scales unit = scales_at(model, v);
  reduced_model<dual<>, Model> numbers(model, unit);
  dual<> u = reduce<double>(v, unit);
  auto& p = parameter(numbers, u);
  const double at = value_of(p);
  p = seeded(at);
  numbers.prepare();
  const auto out = collision<decltype(numbers), stepper::fehlberg78>(numbers, 1e-11, 10'000'000).solve(u);
  BOOST_TEST_REQUIRE(out.restitution.has_value());

  const fine step = 1e-7 * at; // its square is the error of the difference, 1e-17/1e-7 that of the solutions
  const auto solve = [&](const fine& shift) {
    reduced_model<fine, Model> shifted(model, unit);
    fine w = reduce<fine>(v, unit);
    parameter(shifted, w) += shift;
    shifted.prepare();
    return *collision<decltype(shifted), stepper::fehlberg78>(shifted, fine(1e-17), 10'000'000).solve(w).restitution;
  };
  return {static_cast<double>(out.restitution->derivative(1)),
          static_cast<double>((solve(step) - solve(-step)) / (2 * step))};
}

template <class Model, class Parameter>
void agrees(const Model& model, const Parameter& parameter) {
  const auto [dual_numbers, differences] = derivative_of_restitution(model, 8.0 * metres_per_second, parameter);
  BOOST_TEST_MESSAGE(dual_numbers << " and " << differences);
  BOOST_TEST(deviation(dual_numbers, differences) < 1e-8); // a thousand times the step tolerance of the dual solution
}

const auto work_of_adhesion_of = [](auto& model, auto&) -> auto& { return model.adhesion.work_of_adhesion; };
const auto relaxation_time_of = [](auto& model, auto&) -> auto& { return model.crack.relaxation_time; };
const auto speed_of = [](auto&, auto& v) -> auto& { return v; };

} // namespace

BOOST_AUTO_TEST_CASE(every_law_has_the_same_values_on_dual_numbers) {
  for (const auto& contact : contacts()) {
    const auto duals = contact.in<dual<>>([](double x) { return seeded(x); });
    const auto compare = [](const std::vector<dual<>>& found, const std::vector<double>& expected) {
      for (std::size_t i = 0; i < found.size(); ++i)
        BOOST_TEST(deviation(value_of(found[i]), expected[i]) < 2e-15); // dual numbers divide and take powers otherwise
    };
    compare(values_in_the_loop(duals), values_in_the_loop(contact));
    compare(values_at_set_up(duals), values_at_set_up(contact));
  }
}

BOOST_AUTO_TEST_CASE(every_law_has_its_derivative) {
  const fine h = 1e-15; // relative step of everything together; h^2 is the error
  for (const auto& contact : contacts()) {
    // d/d(ln scale) with every input scaled by (1+s)
    const auto duals = contact.in<dual<>>([](double x) { return x * seeded(1.0); });
    const auto up = contact.in<fine>([&](double x) { return fine(x) * (1 + h); });
    const auto down = contact.in<fine>([&](double x) { return fine(x) * (1 - h); });
    const auto compare = [&](const std::vector<dual<>>& found, const std::vector<fine>& above,
                             const std::vector<fine>& below) {
      for (std::size_t i = 0; i < found.size(); ++i) {
        const auto expected = static_cast<double>((above[i] - below[i]) / (2 * h));
        const double size = std::abs(expected) + std::abs(value_of(found[i]));
        // 1e-10: the table's polynomials lose two or three digits when differentiated, the logarithms two
        BOOST_TEST_REQUIRE(std::abs(static_cast<double>(found[i].derivative(1)) - expected) < 1e-10 * size);
      }
    };
    compare(values_in_the_loop(duals), values_in_the_loop(up), values_in_the_loop(down));
    compare(values_at_set_up(duals), values_at_set_up(up), values_at_set_up(down));
  }
}

BOOST_AUTO_TEST_CASE(restitution_of_viscoelastic_jkr) {
  const ice_case ice;
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.fitted(), ice.viscous);
  agrees(model, work_of_adhesion_of);
  agrees(model, relaxation_time_of);
  agrees(model, speed_of);
}

BOOST_AUTO_TEST_CASE(restitution_of_an_edge_without_bound) {
  const ice_case ice;
  const maugis_barquins edge{.reference_speed = 100.0 * metres_per_second, .exponent = 0.6};
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, edge);
  agrees(
      model, [](auto& numbers, auto&) -> auto& { return numbers.crack.reference_speed; });
  agrees(
      model, [](auto& numbers, auto&) -> auto& { return numbers.crack.exponent; });
  agrees(model, speed_of);
}

BOOST_AUTO_TEST_CASE(restitution_of_a_spring_and_a_dashpot) {
  const ice_case ice;
  const auto model =
      compose(ice.pair, linear{40.0 * newtons_per_metre}, linear_dashpot{1e-7 * newtons / metres_per_second});
  agrees(
      model, [](auto& numbers, auto&) -> auto& { return numbers.elastic.stiffness; });
  agrees(
      model, [](auto& numbers, auto&) -> auto& { return numbers.damping.damping_coefficient; });
}

BOOST_AUTO_TEST_CASE(restitution_of_viscous_jkr) {
  const ice_case ice;
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  agrees(model, work_of_adhesion_of);
  agrees(model, speed_of);
}

BOOST_AUTO_TEST_CASE(restitution_of_a_yielding_contact) {
  const ice_case ice;
  const auto yield_strength_of = [](auto& numbers, auto&) -> auto& { return numbers.plasticity.yield_strength; };
  const thornton_ning_contact law{200.0 * megapascals};
  const auto adhesive = compose(ice.pair, hertz{}, ice.adhesive, law);
  agrees(adhesive, work_of_adhesion_of);
  agrees(adhesive, yield_strength_of);
  agrees(adhesive, speed_of);
  agrees(compose(ice.pair, hertz{}, ice.viscous, law), yield_strength_of);
}

BOOST_AUTO_TEST_CASE(traits) {
  static_assert(std::same_as<real_of<dual<>>, double>);
  static_assert(number_traits<dual<fine>>::inverts_exactly && !number_traits<dual<>>::inverts_exactly);
  BOOST_TEST(value_of(seeded(2.5)) == 2.5);
  BOOST_TEST(static_cast<double>(seeded(2.5).derivative(1)) == 1);
  BOOST_TEST(static_cast<double>(dual<>(2.5).derivative(1)) == 0);
  BOOST_TEST(static_cast<double>(square(seeded(3.0)).derivative(1)) == 6);
  // [K (10)]-like set-up: d(x^{1/3})/dx = 1/12 at 8, to a rounding of the exponent
  BOOST_TEST(std::abs(static_cast<double>(cube_root(seeded(8.0)).derivative(1)) - 1. / 12) < 1e-16);
}
