#include <boost/test/unit_test.hpp>

#include <ricochet/body/materials.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/end.hpp>

using namespace ricochet;
using namespace ricochet::units;

// Each law plays its own role and no other.
static_assert(plays<hertz, role::elastic> && !plays<hertz, role::adhesion>);
static_assert(plays<jkr, role::adhesion> && !plays<jkr, role::crack>);
static_assert(plays<greenwood, role::crack> && plays<greenwood_fit, role::crack>);
static_assert(plays<kuwabara_kono, role::damping> && plays<hunt_crossley, role::damping>);
static_assert(plays<tsuji, role::damping> && !plays<tsuji, role::elastic>);
static_assert(plays<end_at_zero_force, role::end> && plays<absent<role::crack>, role::crack>);
static_assert(!has_role<int> && !has_role<contact_pair> && !plays<int, role::elastic>);

static_assert(is_present<hertz> && is_present<greenwood> && !is_present<absent<role::crack>>);
static_assert(needs_root_radius<jkr> && needs_root_radius<tsuji>);
static_assert(!needs_root_radius<hertz> && !needs_root_radius<kuwabara_kono> &&
              !needs_root_radius<absent<role::damping>>);

// A law in other numbers is the same law; where there is none, there is none.
static_assert(std::same_as<jkr::in<reduced<float>>, jkr_law<reduced<float>>>);
static_assert(std::same_as<absent<role::crack>::in<reduced<float>>, absent<role::crack>>);
static_assert(std::tuple_size_v<decltype(absent<role::crack>::parameters())> == 0);

BOOST_AUTO_TEST_CASE(rebinding_converts_every_parameter) {
  const scales unit{.length = 1e-9, .duration = 1e-9, .mass = 1e-15};
  const greenwood_fit law{.relaxation_time = 2e-11 * seconds,
                          .modulus_ratio = 0.02,
                          .interaction_range = 0.3 * nanometres,
                          .first_ratio_over_k = 1.005};
  const auto numbers =
      rebind_law<reduced<double>>(law, [&](const auto& quantity) { return reduce<double>(quantity, unit); });
  static_assert(std::same_as<const greenwood_fit_law<reduced<double>>, decltype(numbers)>);
  // an ulp: one division
  BOOST_TEST(std::abs(numbers.relaxation_time / 0.02 - 1) < 5e-16);
  BOOST_TEST(numbers.modulus_ratio == 0.02);
  BOOST_TEST(std::abs(numbers.interaction_range / 0.3 - 1) < 5e-16);
  BOOST_TEST(numbers.first_ratio_over_k == 1.005);
}

BOOST_AUTO_TEST_CASE(rebinding_shares_the_table) {
  greenwood law{.relaxation_time = seconds, .modulus_ratio = 0.1, .interaction_range = nanometres};
  law.tabulate();
  const auto numbers =
      rebind_law<reduced<float>>(law, [](const auto& quantity) { return reduce<float>(quantity, {}); });
  BOOST_TEST(numbers.table == law.table);
  BOOST_TEST(law.table.use_count() == 2);
}

BOOST_AUTO_TEST_CASE(rebinding_the_absent_law) {
  const auto none = rebind_law<reduced<double>>(absent<role::damping>{}, [](double x) { return x; });
  static_assert(std::same_as<const absent<role::damping>, decltype(none)>);
  BOOST_CHECK_NO_THROW(validate_law(none));
}

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

/// Walks the parameters of a valid law: each value outside its range is refused by name.
template <class Law>
void refuses_each_wrong_parameter(const Law& good) {
  BOOST_CHECK_NO_THROW(validate_law(good));
  std::apply(
      [&](const auto&... p) {
        [[maybe_unused]] const auto one = [&](const auto& parameter) {
          for (const double x : {-1., not_a_number, inf, parameter.allowed.low_included ? -1e-300 : 0.}) {
            Law bad = good;
            auto& member = bad.*(parameter.member);
            member = std::remove_reference_t<decltype(member)>();
            if constexpr (requires { member.value(); })
              member = std::remove_reference_t<decltype(member)>::from_value(x);
            else
              member = x;
            BOOST_CHECK_EXCEPTION(validate_law(bad), bad_input, [&](const bad_input& e) {
              const std::string what = e.what();
              return what.starts_with(std::string(parameter.name) + " = ") &&
                     what.find(parameter.allowed.text()) != std::string::npos;
            });
          }
        };
        (one(p), ...);
      },
      Law::parameters());
}

} // namespace

BOOST_AUTO_TEST_CASE(every_wrong_parameter_of_every_law_is_named) {
  refuses_each_wrong_parameter(hertz{});
  refuses_each_wrong_parameter(jkr{joules_per_square_metre});
  refuses_each_wrong_parameter(greenwood{seconds, 0.5, nanometres});
  refuses_each_wrong_parameter(greenwood_fit{.relaxation_time = seconds, .interaction_range = nanometres});
  refuses_each_wrong_parameter(kuwabara_kono{seconds});
  refuses_each_wrong_parameter(hunt_crossley{seconds_per_metre});
  refuses_each_wrong_parameter(tsuji{0.5});
  // zero is allowed where a law then does nothing
  validate_law(jkr{});
  validate_law(kuwabara_kono{});
  validate_law(hunt_crossley{});
  validate_law(tsuji{});
}
