#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/sensitivity.hpp>

using namespace support;

namespace {
const ice_case ice;

double by(const auto& result, const std::string& quantity) {
  for (const auto& each : result.by)
    if (each.quantity == quantity)
      return each.relative();
  throw std::runtime_error("no " + quantity);
}

/// The restitution has no dimension: it stays when lengths, masses and times are scaled. `exponents` of each quantity.
void has_no_dimension(const auto& result, const std::map<std::string, std::array<double, 3>>& exponents) {
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (const auto& each : result.by)
      if (exponents.contains(each.quantity))
        sum += exponents.at(each.quantity)[k] * each.relative();
    BOOST_TEST(std::abs(sum) < 1e-7, "dimension " << k << ": " << sum);
  }
}
const std::map<std::string, std::array<double, 3>> length_mass_time{{"reduced_modulus", {-1, 1, -2}},
                                                                    {"reduced_radius", {1, 0, 0}},
                                                                    {"reduced_mass", {0, 1, 0}},
                                                                    {"work_of_adhesion", {0, 1, -2}},
                                                                    {"speed", {1, 0, -1}},
                                                                    {"bulk_time", {0, 0, 1}},
                                                                    {"relaxation_time", {0, 0, 1}},
                                                                    {"interaction_range", {1, 0, 0}},
                                                                    {"damping_coefficient", {-1, 0, 1}},
                                                                    {"yield_strength", {-1, 1, -2}}};

/// Relative derivatives by central differences of collisions that are known to 1e-12.
void agrees_with_differences(const auto& model, speed v) {
  constexpr std::size_t count = detail::quantity_count<std::remove_cvref_t<decltype(model)>> + 1;
  detail::moving_scene<count, std::remove_cvref_t<decltype(model)>> scene{
      model, impact{v}, std::vector<std::array<double, count>>(count)};
  for (std::size_t i = 0; i < count; ++i)
    scene.slope[i][i] = 1;
  const auto found = sensitivities(model, impact{v}, {.tolerance = 1e-8});
  for (std::size_t i = 0; i < count; ++i) {
    const double expected = *detail::derivative_by_differences(scene, i) * found.by[i].value;
    BOOST_TEST(std::abs(found.by[i].relative() - expected) < 3e-8,
               found.by[i].quantity << ": " << found.by[i].relative() << " by differences " << expected);
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(of_static_jkr_as_its_closed_form) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive);
  const speed v = 5.0 * metres_per_second;
  const auto found = sensitivities(model, impact{v}, {.tolerance = 1e-9});
  const double e = *found.outcome.restitution, sticking = (1 - e * e) / e; // e^2 = 1 - (v_s/v)^2
  BOOST_TEST(std::abs(by(found, "speed") - sticking) < 1e-8);
  // v_s^2 ~ w^(5/3) R^(4/3) E^(-2/3)/m
  BOOST_TEST(std::abs(by(found, "work_of_adhesion") + sticking * 5 / 6) < 1e-8);
  BOOST_TEST(std::abs(by(found, "reduced_modulus") - sticking / 3) < 1e-8);
  BOOST_TEST(std::abs(by(found, "reduced_radius") + sticking * 2 / 3) < 1e-8);
  BOOST_TEST(std::abs(by(found, "reduced_mass") - sticking / 2) < 1e-8);
  BOOST_TEST(found.error_estimate < 1e-8);
}

BOOST_AUTO_TEST_CASE(restitution_has_no_dimension) {
  const impact fast{12.0 * metres_per_second};
  const thornton_ning flow{5e8 * pascals};
  has_no_dimension(sensitivities(compose(ice.pair, hertz{}, ice.viscous), fast), length_mass_time);
  has_no_dimension(sensitivities(compose(ice.pair, hertz{}, hunt_crossley{0.01 / metres_per_second}), fast),
                   length_mass_time);
  has_no_dimension(sensitivities(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), fast), length_mass_time);
  has_no_dimension(sensitivities(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.fitted()), fast),
                   length_mass_time);
  has_no_dimension(
      sensitivities(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.exact(1e-11 * seconds)), fast),
      length_mass_time);
  has_no_dimension(
      sensitivities(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-15 * seconds)), fast), // by differences
      length_mass_time);
  has_no_dimension(
      sensitivities(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.exact(1e-11 * seconds), flow), fast),
      length_mass_time);
}

BOOST_AUTO_TEST_CASE(dual_numbers_and_differences_agree) {
  const speed v = 9.0 * metres_per_second;
  agrees_with_differences(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), v);
  agrees_with_differences(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.exact(1e-11 * seconds)), v);
  agrees_with_differences(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, thornton_ning{5e8 * pascals}), v);
}

BOOST_AUTO_TEST_CASE(where_a_quantity_is_zero_the_others_are_as_without_it) {
  const speed v = 8.0 * metres_per_second;
  const auto same = [&](const auto& with, const auto& without, const std::string& at_zero) {
    const auto found = sensitivities(with, impact{v}), expected = sensitivities(without, impact{v});
    BOOST_TEST(found.error_estimate < 1e-7);
    for (const sensitivity& each : expected.by)
      BOOST_TEST(std::abs(by(found, each.quantity) - each.relative()) < 1e-7, each.quantity);
    for (const sensitivity& each : found.by)
      BOOST_TEST((std::isfinite(each.derivative) || each.quantity == at_zero), each.quantity);
  };
  const kuwabara_kono viscous{1e-10 * seconds};
  const thornton_ning plastic{3e8 * pascals};
  same(compose(ice.pair, hertz{}, jkr{}, viscous), compose(ice.pair, hertz{}, viscous, end_at_zero_overlap{}), "work_of_adhesion");
  same(compose(ice.pair, hertz{}, ice.adhesive, kuwabara_kono{}, plastic),
       compose(ice.pair, hertz{}, ice.adhesive, plastic), "");
  same(compose(ice.pair, hertz{}, ice.adhesive, ice.exact(0.0 * seconds), viscous),
       compose(ice.pair, hertz{}, ice.adhesive, viscous), "relaxation_time");
}

BOOST_AUTO_TEST_CASE(of_a_cohesive_zone) {
  agrees_with_differences(compose(ice.pair, hertz{}, maugis_dugdale{0.1 * joules_per_square_metre, 2e-9 * metres},
                                  kuwabara_kono{1e-10 * seconds}),
                          20.0 * metres_per_second);
}

BOOST_AUTO_TEST_CASE(a_captured_pair_depends_on_nothing) {
  const auto found = sensitivities(compose(ice.pair, hertz{}, ice.adhesive), impact{0.1 * metres_per_second});
  BOOST_TEST(name_of(found.outcome.ending) == "captured");
  for (const auto& each : found.by)
    BOOST_TEST(each.derivative == 0);
}
