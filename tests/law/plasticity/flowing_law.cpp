#include <boost/test/unit_test.hpp>

#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/plasticity/plasticity_law.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

using namespace ricochet;

namespace {

static_assert(flowing_law<thornton_ning_contact> && !flowing_law<thornton_ning> && !flowing_law<tsuji>);
static_assert(!plasticity_law<thornton_ning_contact> && plasticity_law<thornton_ning>);
static_assert(!flowing_law<absent<role::plasticity>>);

} // namespace

BOOST_AUTO_TEST_CASE(a_shape_is_taken_with_the_rest_of_the_pair) {
  flattened_configuration<reduced<double>> c{};
  c.take({.reduced_modulus = 2, .reduced_radius = 3, .reduced_mass = 5},
         {.radius = 7, .residual_approach = 0.5, .radius_slope = 1, .approach_slope = 1});
  BOOST_TEST((c.pair.reduced_modulus == 2 && c.pair.reduced_radius == 7 && c.pair.reduced_mass == 5));
  BOOST_TEST(c.shape.residual_approach == 0.5);
}
