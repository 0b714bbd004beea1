#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <ricochet/model/physical_system.hpp>

using namespace support;

namespace {

template <class Model>
using state_of = typename physical_system<Model>::state_type;

/// Compares d/dt of the two systems at the reduced model's state x.
template <class Model, class State>
void agree(const Model& model, const scales& unit, const reduced_model<double, Model>& numbers, const State& x,
           int piece) {
  auto dx = x;
  BOOST_TEST_REQUIRE(numbers.derivative(x, dx, piece));
  const auto now = numbers.at(x, piece);
  const double metre = unit.length, second = unit.duration;
  const physical_system<Model> system(model);
  state_of<Model> z{}, dz{};
  z[mutual_approach] = now.c.approach * metre;
  z[approach_rate] = now.c.rate * metre / second;
  if constexpr (Model::has_crack_law)
    z[contact_radius] = now.c.radius * metre;
  system(z, dz, 0);
  // 1e-10: the approach is a difference of a^2/R and c sqrt(a), and the physical system has the radius, or beta, from
  // it
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-10 * std::abs(b); };
  BOOST_TEST_REQUIRE(dz[mutual_approach] == z[approach_rate]);
  BOOST_TEST_REQUIRE(same(dz[approach_rate], dx[approach_rate] / now.clock * metre / second / second));
  if constexpr (Model::has_crack_law) { // da/dt = 2y dy/dt
    BOOST_TEST_REQUIRE(
        same(dz[contact_radius], 2 * x[numbers.coordinate] * now.coordinate_rate / now.clock * metre / second));
    BOOST_TEST_REQUIRE(same(system.energy_release_ratio(z), square(now.root_ratio)));
  }
  if constexpr (Model::adhesive)
    BOOST_TEST_REQUIRE(system.past_fold(z) == numbers.past_fold(now.c));
}

} // namespace

BOOST_AUTO_TEST_CASE(same_motion_as_the_smooth_coordinates) {
  scenes random(5);
  for (int i = 0; i < 30; ++i) {
    const scene s = random.next();
    const auto visit = [&](const auto& model) {
      using Model = std::remove_cvref_t<decltype(model)>;
      const scales unit = scales_at(model, s.speed);
      const reduced_model<double, Model> numbers(model, unit);
      auto x = numbers.touch(i % 2 ? 0.7 : -0.5);
      x[numbers.coordinate] = numbers.typical()[numbers.coordinate] * random.log_uniform(0.3, 2);
      if constexpr (!Model::has_crack_law) {
        if constexpr (Model::adhesive)
          x[numbers.coordinate] = numbers.fold_coordinate() * random.log_uniform(1.05, 5);
        agree(model, unit, numbers, x, 0);
      } else {
        const double y = x[numbers.coordinate], fits = decltype(numbers.crack)::joints.size() == 3;
        for (const double beta : {0.5, 2.}) { // of the pieces next to 1
          x[mutual_approach] = numbers.elastic.load_free_approach(numbers.pair, y * y) -
                               std::sqrt(beta) * numbers.adhesion.flattening(numbers.pair) * y;
          agree(model, unit, numbers, x, int(fits) + (beta > 1));
        }
      }
    };
    visit(viscous_hertz(s));
    visit(tsuji_hertz(s));
    visit(static_jkr(s));
    visit(viscous_jkr(s));
    visit(viscoelastic_jkr_fit(s));
    auto exact = s;
    exact.modulus_ratio = std::min(s.modulus_ratio, 0.3); // beta = 2 and 0.5 lie in its range
    visit(viscoelastic_jkr(exact));
  }
}

BOOST_AUTO_TEST_CASE(unknowns) {
  static_assert(state_of<decltype(hertzian(scene{}))>::names::size == 2);
  static_assert(state_of<decltype(viscous_jkr(scene{}))>::names::size == 2);
  const scene s = scenes(3).next();
  const auto model = viscoelastic_jkr_fit(s);
  const physical_system<std::remove_cvref_t<decltype(model)>> system(model);
  const auto x = system.touch(s.speed);
  BOOST_TEST(x.size() == 3u);
  BOOST_TEST(x[mutual_approach] == 0);
  BOOST_TEST(x[approach_rate] == in_si(s.speed));
  // a = (2 pi R^2 beta_0 w/E)^{1/3}, so that beta = 1.01 k; three roots of rounding
  BOOST_TEST(std::abs(system.energy_release_ratio(x) / (1.01 * 0.02) - 1) < 1e-14);
  BOOST_TEST(!system.past_fold(x));
}

BOOST_AUTO_TEST_CASE(is_a_system_of_odeint) {
  const scene s = scenes(4).next();
  const auto model = hertzian(s);
  const physical_system<std::remove_cvref_t<decltype(model)>> system(model);
  const double m = in_si(s.pair.reduced_mass), E = in_si(s.pair.reduced_modulus), R = in_si(s.pair.reduced_radius);
  const double v = in_si(s.speed), contact_time = 2.8682656992 * std::pow(m * m / (R * E * E * v), 0.2);
  auto x = system.touch(s.speed);
  boost::numeric::odeint::runge_kutta4<decltype(x)> stepper;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i)
    stepper.do_step(system, x, i * contact_time / steps, contact_time / steps);
  // At Hertz's contact time the spheres part with the speed of approach. In these unknowns the method's order drops to
  // 2.5 at touch: 2000^-2.5 = 6e-9, and ten of it.
  BOOST_TEST(std::abs(x[approach_rate] / v + 1) < 1e-7);
  BOOST_TEST(std::abs(x[mutual_approach]) < 1e-7 * v * contact_time);
}
