#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/body/pair.hpp>
#include <ricochet/closed_form/independent_losses.hpp>
#include <ricochet/closed_form/thornton_ning.hpp>

using namespace ricochet;
using namespace ricochet::units;
namespace closed = ricochet::closed_form;

namespace {

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

struct fixture { // the ice case of reference/published.csv: Krijt 2013 table 2, figure 2
  contact_pair pair =
      between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
  energy_per_area w = work_of_adhesion(materials::water_ice, materials::water_ice);
  duration bulk_time = 1.6e-10 * seconds; // T_vis/nu^2
  speed v = 8.0 * metres_per_second;
};

} // namespace

BOOST_AUTO_TEST_CASE(losses_add) {
  // 1e-16: roundings of numbers below one
  BOOST_TEST(std::abs(*closed::independent_losses({0.9, 0.8}) - std::sqrt(0.45)) < 3e-16);
  BOOST_TEST(std::abs(*closed::independent_losses({0.9, 0.8, 0.95}) - std::sqrt(0.3525)) < 3e-16);
  BOOST_TEST(std::abs(*closed::independent_losses({0.95, 0.9, 0.8}) - std::sqrt(0.3525)) < 3e-16); // in any order
  // 0.36 + 0.64 - 1 = 0: nothing is left to part with, nor is below.
  BOOST_TEST(!closed::independent_losses({0.8, 0.6 - 1e-15}).has_value());
  BOOST_TEST(!closed::independent_losses({0.5, 0.5}).has_value());
  BOOST_TEST(!closed::independent_losses({0.8, 0.8, 0.8}).has_value());
  BOOST_TEST(closed::independent_losses({0.8, 0.6 + 1e-15}).has_value());
}

BOOST_AUTO_TEST_CASE(a_loss_alone_comes_out_as_it_is) {
  for (const double e : {1., 0.7, 1e-3, 1e-10, 1e-100}) {
    // 5e-16: a square and a root, of which nothing is lost even for the smallest
    BOOST_TEST(std::abs(*closed::independent_losses({e}) / e - 1) < 5e-16);
    BOOST_TEST(std::abs(*closed::independent_losses({e, 1.}) / e - 1) < 5e-16);
    BOOST_TEST(std::abs(*closed::independent_losses({1., e}) / e - 1) < 5e-16);
  }
}

BOOST_AUTO_TEST_CASE(what_captures_alone_captures) {
  BOOST_TEST(!closed::independent_losses({std::nullopt, 1.}).has_value());
  BOOST_TEST(!closed::independent_losses({0.9, std::nullopt}).has_value());
  BOOST_TEST(!closed::independent_losses({0., 1.}).has_value());
}

BOOST_FIXTURE_TEST_CASE(adhesion_and_plastic_flow, fixture) {
  const auto yielding = closed::yield_speed(pair, 0.1 * gigapascals);
  const double adhesive = *closed::restitution(pair, w, v), plastic = closed::plastic_restitution(yielding, v);
  BOOST_TEST(plastic < 0.99);
  const auto both = closed::independent_losses({adhesive, plastic});
  BOOST_TEST(std::abs(*both - std::sqrt(adhesive * adhesive + plastic * plastic - 1)) < 1e-15); // roundings
}

BOOST_FIXTURE_TEST_CASE(adhesion_and_viscosity, fixture) {
  // reference/published.csv, of Krijt 2013 3.3: the paper prints 0.92.
  const auto independent = closed::independent_losses(pair, w, bulk_time, v);
  BOOST_TEST_REQUIRE(independent.has_value());
  BOOST_TEST(std::abs(*independent - 0.9172) < 5e-5); // half of the last decimal
  // 1e-15: roundings of numbers below one
  BOOST_TEST(std::abs(*closed::independent_losses(pair, w, duration{}, v) - *closed::restitution(pair, w, v)) < 1e-15);
  BOOST_TEST(std::abs(*closed::independent_losses(pair, energy_per_area{}, bulk_time, v) -
                      closed::weak_damping_restitution(pair, bulk_time, v)) < 1e-15);
  BOOST_TEST(!closed::independent_losses(pair, w, duration{}, 0.999 * closed::sticking_speed(pair, w)).has_value());
  BOOST_TEST(closed::independent_losses(pair, w, duration{}, 1.001 * closed::sticking_speed(pair, w)).has_value());
  // Each loss alone lets them separate, both do not.
  const speed slow = 1.001 * closed::sticking_speed(pair, w);
  BOOST_TEST(closed::weak_damping_restitution(pair, bulk_time, slow) > 0);
  BOOST_TEST(!closed::independent_losses(pair, w, bulk_time, slow).has_value());
  // Beyond A = 0.18 t_H the first order loses more than there is; e_D^2 must not be taken for an energy left.
  const duration huge = 2.0 * closed::contact_time(pair, v);
  BOOST_TEST(closed::weak_damping_restitution(pair, huge, v) < -1);
  BOOST_TEST(!closed::independent_losses(pair, w, huge, v).has_value());
}

BOOST_FIXTURE_TEST_CASE(wrong_input_is_named, fixture) {
  BOOST_CHECK_EXCEPTION(closed::independent_losses({0.9, 1.5}), bad_input, says("restitution", "1.5", "[0, 1]"));
  BOOST_CHECK_EXCEPTION(closed::independent_losses({-0.5, 0.9}), bad_input, says("restitution", "-0.5", "[0, 1]"));
  const duration wrong = -2.0 * seconds;
  BOOST_CHECK_EXCEPTION(closed::independent_losses(pair, w, wrong, v), bad_input,
                        says("bulk_time", "-2 s", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(closed::independent_losses(pair, -w, bulk_time, v), bad_input,
                        says("work_of_adhesion", "-0.74 J/m^2", "[0, inf)"));
}
