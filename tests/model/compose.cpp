#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {

const contact_pair pair =
    between(sphere{materials::water_ice, 2.0 * micrometres}, sphere{materials::water_ice, 2.0 * micrometres});
const std::tuple laws{hertz{}, jkr{0.74 * joules_per_square_metre},
                      greenwood_fit{.relaxation_time = 1e-11 * seconds, .interaction_range = 0.3 * nanometres},
                      kuwabara_kono{1.6e-10 * seconds}, energy_ledger{}};

/// The n-th order of five things.
constexpr std::array<std::size_t, 5> order(std::size_t n) {
  std::array<std::size_t, 5> rest{0, 1, 2, 3, 4}, result{};
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t pick = n % (5 - i);
    n /= 5 - i;
    result[i] = rest[pick];
    for (std::size_t j = pick; j + 1 < 5; ++j)
      rest[j] = rest[j + 1];
  }
  return result;
}

template <std::size_t N>
auto composed() {
  constexpr auto o = order(N);
  return compose(pair, std::get<o[0]>(laws), std::get<o[1]>(laws), std::get<o[2]>(laws), std::get<o[3]>(laws),
                 std::get<o[4]>(laws));
}

auto says(const std::string& name, const std::string& value, const std::string& range) {
  return [=](const bad_input& e) {
    const std::string what = e.what();
    return what.find(name + " = " + value) == 0 && what.find(range) != std::string::npos;
  };
}

constexpr double inf = std::numeric_limits<double>::infinity();

} // namespace

BOOST_AUTO_TEST_CASE(any_order_gives_the_same_type_and_values) {
  const auto first = composed<0>();
  [&]<std::size_t... N>(std::index_sequence<N...>) {
    static_assert((std::same_as<decltype(composed<N>()), decltype(composed<0>())> && ...));
    const auto same = [&](const auto& other) {
      BOOST_TEST((other.adhesion.work_of_adhesion == first.adhesion.work_of_adhesion &&
                  other.crack.relaxation_time == first.crack.relaxation_time &&
                  other.damping.bulk_time == first.damping.bulk_time &&
                  other.pair.reduced_mass == first.pair.reduced_mass));
    };
    (same(composed<N>()), ...);
  }
  (std::make_index_sequence<120>());
  BOOST_TEST(in_si(first.damping.bulk_time) == 1.6e-10);
}

BOOST_AUTO_TEST_CASE(parameters_are_validated) {
  const jkr adhesion{0.74 * joules_per_square_metre};
  const greenwood_fit crack{.relaxation_time = seconds, .interaction_range = nanometres};
  const auto edge = [&](const auto& law) { return compose(pair, hertz{}, adhesion, law); };
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, jkr{-1.0 * joules_per_square_metre}), bad_input,
                        says("work_of_adhesion", "-1 J/m^2", "[0, inf) J/m^2"));
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, kuwabara_kono{inf * seconds}), bad_input,
                        says("bulk_time", "inf s", "[0, inf) s"));
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, hunt_crossley{-2.0 * seconds_per_metre}), bad_input,
                        says("damping_coefficient", "-2 s/m", "[0, inf) s/m"));
  BOOST_CHECK_EXCEPTION(compose(pair, hertz{}, tsuji{-0.5}), bad_input,
                        says("damping_coefficient", "-0.5", "[0, inf)"));
  auto wrong = crack;
  wrong.relaxation_time = -1.0 * seconds;
  BOOST_CHECK_EXCEPTION(edge(wrong), bad_input, says("relaxation_time", "-1 s", "[0, inf) s"));
  wrong = crack;
  wrong.interaction_range = length{};
  BOOST_CHECK_EXCEPTION(edge(wrong), bad_input, says("interaction_range", "0 m", "(0, inf) m"));
  wrong = crack;
  wrong.first_ratio_over_k = 1;
  BOOST_CHECK_EXCEPTION(edge(wrong), bad_input, says("first_ratio_over_k", "1", "(1, 1.02)"));
  BOOST_CHECK_EXCEPTION(edge(greenwood{seconds, 0.99, nanometres}), bad_input,
                        says("modulus_ratio", "0.99", "[0.0001, 0.98]"));
}

BOOST_AUTO_TEST_CASE(the_pair_is_validated) {
  for (const double x : {0., -1., inf, std::nan("")}) {
    auto wrong = pair;
    wrong.reduced_modulus = x * pascals;
    BOOST_CHECK_EXCEPTION(compose(wrong, hertz{}), bad_input, says("reduced_modulus", "", "(0, inf) Pa"));
    wrong = pair;
    wrong.reduced_radius = x * metres;
    BOOST_CHECK_EXCEPTION(compose(wrong, hertz{}), bad_input, says("reduced_radius", "", "(0, inf) m"));
    wrong = pair;
    wrong.reduced_mass = x * kilograms;
    BOOST_CHECK_EXCEPTION(compose(wrong, hertz{}), bad_input, says("reduced_mass", "", "(0, inf) kg"));
  }
}

BOOST_AUTO_TEST_CASE(the_table_of_the_exact_law_is_made_or_shared) {
  const greenwood law{1e-11 * seconds, 0.1, 0.3 * nanometres};
  const auto one = compose(pair, hertz{}, jkr{}, law);
  BOOST_TEST_REQUIRE(one.crack.table);
  BOOST_TEST(one.crack.table->modulus_ratio == 0.1);
  auto sharing = law;
  sharing.table = one.crack.table;
  BOOST_TEST(compose(pair, hertz{}, jkr{}, sharing).crack.table == one.crack.table);
  sharing.modulus_ratio = 0.2;
  BOOST_CHECK_THROW(compose(pair, hertz{}, jkr{}, sharing), bad_input);
}
