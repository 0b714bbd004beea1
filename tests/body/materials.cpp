#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>

using namespace ricochet;

namespace {

/// A row of Krijt 2013, table 2, with its column of sound speeds, which catches a slip in either modulus or density.
struct row {
  const char* name;
  material solid;
  double gigapascals, poissons_ratio, grams_per_cubic_centimetre, sound_speed, surface_free_energy;
};

using namespace materials;
const row table_2[] = {
    {"aluminium alloy", aluminium_alloy, 70, 0.345, 2.7, 5092, 0.59},
    {"steel", steel, 190, 0.28, 7.92, 4898, 1.62},
    {"molybdenum", molybdenum, 320, 0.33, 10.28, 5579, 2.81},
    {"polished quartz", quartz, 54, 0.17, 2.6, 4557, 0.025},
    {"silicon", silicon, 180, 0.33, 2.33, 8789, 1.42},
    {"mica", mica, 90, 0.33, 3, 5477, 0.77},
    {"copper", copper, 130, 0.34, 8.94, 3813, 1.11},
    {"silver-coated glass", silver_coated_glass, 72, 0.21, 2.6, 5261, 0.61},
    {"polystyrene latex", polystyrene_latex, 3.4, 0.33, 1.026, 1820, 0.025},
    {"tedlar", tedlar, 2, 0.33, 1.46, 1170, 0.018},
    {"acrylic", acrylic, 3, 0.35, 1.22, 1568, 0.02},
    {"lucite", lucite, 2.6, 0.3, 1.18, 1484, 0.02},
    {"polyvinyl toluene", polyvinyl_toluene, 3, 0.33, 1.2, 1581, 0.02},
    {"ammonium fluorescein", ammonium_fluorescein, 1.17, 0.33, 1.35, 931, 0.01},
    {"water ice", water_ice, 7, 0.25, 1, 2645, 0.37},
};

bool same(double a, double b) { return std::abs(a - b) <= 4e-16 * std::abs(b); } // an ulp or two of the powers of ten

} // namespace

BOOST_AUTO_TEST_CASE(values_of_table_2) {
  for (const row& each : table_2)
    BOOST_TEST_CONTEXT(each.name) {
      BOOST_TEST(same(in_si(each.solid.youngs_modulus), 1e9 * each.gigapascals));
      BOOST_TEST(each.solid.poissons_ratio == each.poissons_ratio);
      BOOST_TEST(same(in_si(each.solid.mass_density), 1e3 * each.grams_per_cubic_centimetre));
      BOOST_TEST(same(in_si(*each.solid.surface_free_energy), each.surface_free_energy));
      // The table's own rounding: whole metres per second, off by 1.35 for silver-coated glass.
      const double sound = std::sqrt(in_si(each.solid.youngs_modulus) / in_si(each.solid.mass_density));
      BOOST_TEST(std::abs(sound - each.sound_speed) <= 1.5);
      BOOST_CHECK_NO_THROW(validate(each.solid));
    }
}

BOOST_AUTO_TEST_CASE(ceramics_have_no_single_surface_free_energy) {
  BOOST_TEST(in_si(ceramics.youngs_modulus) == 370e9);
  BOOST_TEST(ceramics.poissons_ratio == 0.26);
  BOOST_TEST(in_si(ceramics.mass_density) == 3860);
  BOOST_TEST(!ceramics.surface_free_energy.has_value());
  BOOST_CHECK_NO_THROW(validate(ceramics));
}
