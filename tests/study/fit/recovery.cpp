#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/study/fit/fit.hpp>
#include <ricochet/study/sweep.hpp>
#include <ricochet/study/threshold/threshold.hpp>

using namespace support;

// The materials of the reference collisions come back from their own curves: work of adhesion, relaxation time and bulk
// time from e at twelve speeds above the sticking speed and one below. RICOCHET_MATERIALS: how many rows, 6 unless
// given.
BOOST_AUTO_TEST_CASE(reference_materials_come_back_from_their_own_curves) {
  const char* asked = std::getenv("RICOCHET_MATERIALS");
  std::size_t left = asked ? std::size_t(std::atoi(asked)) : 6;
  double worst = 0;
  for (const auto& row : read_rows("viscoelastic_jkr.csv")) {
    if (left == 0)
      break;
    --left;
    const contact_pair pair = bodies(row);
    const std::array<double, 3> truth{number(row, "work_of_adhesion"), number(row, "relaxation_time"),
                                      number(row, "bulk_time")};
    const auto family = [&](const std::array<double, 3>& p) {
      return compose(pair, hertz{}, jkr{p[0] * joules_per_square_metre},
                     greenwood_fit{.relaxation_time = p[1] * seconds,
                                   .interaction_range = number(row, "interaction_range") * metres},
                     kuwabara_kono{p[2] * seconds});
    };
    const auto model = family(truth);
    const speed jkr_threshold = closed_form::sticking_speed(pair, model.adhesion.work_of_adhesion);
    speed fast = 2.0 * jkr_threshold;
    while (!collide(model, impact{fast}, {.tolerance = 1e-6}).restitution)
      fast *= 2;
    const speed sticks = sticking_speed(model, 0.5 * jkr_threshold, fast, 1e-6).value();
    std::vector<measurement> data{{0.9 * sticks, std::nullopt}};
    for (const speed& v : logarithmic_speeds(1.05 * sticks, 30.0 * sticks, 12))
      data.push_back({v, collide(model, impact{v}, {.tolerance = 1e-11}).restitution});
    std::array<free_parameter, 3> free{free_parameter{"work_of_adhesion", 0, 0},
                                       free_parameter{"relaxation_time", 0, 0}, free_parameter{"bulk_time", 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      free[k].low = truth[k] / 8;
      free[k].high = truth[k] * 12;
    }
    const auto found = fit(family, data, free, {.tolerance = 1e-10, .confidence = 0});
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(found.parameters[k].value / truth[k] - 1);
      worst = std::max(worst, error);
      BOOST_TEST(error < 1e-6, free[k].name << " = " << found.parameters[k].value << ", true is " << truth[k] << ", by "
                                            << found.scatter);
    }
  }
  BOOST_TEST_MESSAGE("largest relative error " << worst);
}
