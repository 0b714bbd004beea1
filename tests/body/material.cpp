#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr material ice = materials::water_ice;

auto says(const std::string& name, const std::string& value, const std::string& range) {
  return [=](const bad_input& e) {
    const std::string what = e.what();
    return what.find(name + " = ") != std::string::npos && what.find(value) != std::string::npos &&
           what.find(range) != std::string::npos;
  };
}

/// Values that no quantity may have, and how they are printed.
const std::pair<double, std::string> wrong[] = {{-1, "-1"}, {not_a_number, "nan"}, {inf, "inf"}, {-inf, "-inf"}};

} // namespace

BOOST_AUTO_TEST_CASE(every_wrong_quantity_is_named) {
  validate(ice);
  for (const auto& [x, text] : wrong) {
    material bad = ice;
    bad.youngs_modulus = x * pascals;
    BOOST_CHECK_EXCEPTION(validate(bad), bad_input, says("youngs_modulus", text, "(0, inf) Pa"));
    bad = ice;
    bad.poissons_ratio = x;
    BOOST_CHECK_EXCEPTION(validate(bad), bad_input, says("poissons_ratio", text, "[0, 0.5)"));
    bad = ice;
    bad.mass_density = x * kilograms_per_cubic_metre;
    BOOST_CHECK_EXCEPTION(validate(bad), bad_input, says("density", text, "(0, inf) kg/m^3"));
    bad = ice;
    bad.surface_free_energy = x * joules_per_square_metre;
    BOOST_CHECK_EXCEPTION(validate(bad), bad_input, says("surface_free_energy", text, "[0, inf) J/m^2"));
  }
}

BOOST_AUTO_TEST_CASE(zero_and_the_ends_of_ranges) {
  material solid = ice;
  solid.youngs_modulus = modulus{};
  BOOST_CHECK_EXCEPTION(validate(solid), bad_input, says("youngs_modulus", "0 Pa", "(0, inf) Pa"));
  solid = ice;
  solid.mass_density = density{};
  BOOST_CHECK_EXCEPTION(validate(solid), bad_input, says("density", "0 kg/m^3", "(0, inf) kg/m^3"));
  solid = ice;
  solid.poissons_ratio = 0.5;
  BOOST_CHECK_EXCEPTION(validate(solid), bad_input, says("poissons_ratio", "0.5", "[0, 0.5)"));
  solid.poissons_ratio = 0;
  BOOST_CHECK_NO_THROW(validate(solid));
  solid.surface_free_energy = energy_per_area{};
  BOOST_CHECK_NO_THROW(validate(solid));
  solid.surface_free_energy.reset();
  BOOST_CHECK_NO_THROW(validate(solid));
}

BOOST_AUTO_TEST_CASE(the_first_wrong_quantity_is_named_with_its_owner) {
  const material bad{};
  BOOST_CHECK_EXCEPTION(validate(bad, "wall: "), bad_input, says("wall: youngs_modulus", "0 Pa", "(0, inf) Pa"));
}

BOOST_AUTO_TEST_CASE(work_of_adhesion_of_two_solids) {
  // an ulp: the square root of a square
  BOOST_TEST(std::abs(in_si(work_of_adhesion(ice, ice)) - 0.74) < 2e-16);
  const auto w = work_of_adhesion(ice, materials::steel);
  BOOST_TEST(in_si(w) == 2 * std::sqrt(0.37 * 1.62));
  BOOST_TEST((w == work_of_adhesion(materials::steel, ice)));
  material clean = ice;
  clean.surface_free_energy = energy_per_area{};
  BOOST_TEST(in_si(work_of_adhesion(ice, clean)) == 0);
}

BOOST_AUTO_TEST_CASE(work_of_adhesion_needs_both_surface_free_energies) {
  const auto unknown = [](const bad_input& e) {
    return std::string(e.what()).find("surface_free_energy") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(work_of_adhesion(ice, materials::ceramics), bad_input, unknown);
  BOOST_CHECK_EXCEPTION(work_of_adhesion(materials::ceramics, ice), bad_input, unknown);
}

BOOST_AUTO_TEST_CASE(work_of_adhesion_refuses_wrong_surface_free_energies) {
  for (const auto& [x, text] : wrong) {
    material bad = ice;
    bad.surface_free_energy = x * joules_per_square_metre;
    // two negative ones have a positive product
    BOOST_CHECK_EXCEPTION(work_of_adhesion(bad, bad), bad_input, says("surface_free_energy", text, "[0, inf) J/m^2"));
    BOOST_CHECK_EXCEPTION(work_of_adhesion(ice, bad), bad_input, says("surface_free_energy", text, "[0, inf) J/m^2"));
  }
}
