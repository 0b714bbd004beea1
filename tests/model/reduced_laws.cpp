#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/number/autodiff.hpp>

using namespace support;

namespace {

/// The static force is the slope of the potential in the approach, at a constant radius where the edge is free to be
/// elsewhere, along the contact where its radius is Hertzian.
template <class Model>
void force_is_slope_of_potential(const Model& model, bool hertzian) {
  using D = dual<>;
  const reduced_laws<D, Model> laws(model, [](const auto& quantity) { return D(in_si(quantity)); });
  const double R = in_si(model.pair.reduced_radius), a = 0.05 * R;
  const D approach = seeded(hertzian ? a * a / R : 0.6 * a * a / R);
  const D radius = hertzian ? D(sqrt(approach * R)) : D(a);
  const configuration<reduced<D>> c{approach, D(-0.3), radius, sqrt(radius)};
  BOOST_TEST(laws.potential(c).derivative(1) == value_of(laws.static_force(c)), boost::test_tools::tolerance(1e-12));
  const double parts =
      value_of(laws.static_force(c)) + value_of(laws.damping_force(c)) + value_of(laws.rebound_force(c));
  BOOST_TEST(value_of(laws.total_force(c)) == parts, boost::test_tools::tolerance(1e-15));
  BOOST_TEST((value_of(laws.damping_force(c)) < 0) == Model::damped); // opposes the rebound
  BOOST_TEST((value_of(laws.rebound_force(c)) < 0) == Model::attracted);
}

} // namespace

BOOST_AUTO_TEST_CASE(forces_and_energies_belong_together) {
  scenes source(121);
  for (int i = 0; i < 5; ++i) {
    const scene s = source.next();
    force_is_slope_of_potential(hertzian(s), false);
    force_is_slope_of_potential(viscous_jkr(s), false);
    force_is_slope_of_potential(compose(s.pair, hertz{}, line_force{50.0 * newtons_per_metre, 0.1 / s.speed}), true);
  }
}
