#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>

using namespace support;

namespace {

using names = variables<approach_rate_t, contact_radius_t, bulk_loss_t>;
using three = state<double, names>;

static_assert(names::size == 3 && names::contains<bulk_loss_t> && !names::contains<crack_loss_t>);
static_assert(names::index_of<approach_rate_t>() == 0 && names::index_of<bulk_loss_t>() == 2);
static_assert(std::same_as<join<>, variables<>>);
static_assert(
    std::same_as<join<variables<approach_rate_t>, variables<>, variables<contact_radius_t, bulk_loss_t>>, names>);
static_assert(std::same_as<optionally<crack_loss_t, true>, variables<crack_loss_t>>);
static_assert(std::same_as<optionally<crack_loss_t, false>, variables<>>);
static_assert(sizeof(three) == 3 * sizeof(double)); // packed
static_assert(sizeof(state<float, names>) == 3 * sizeof(float));

template <class Model>
using unknowns = typename reduced_model<double, Model>::unknowns;

/// The state of a model has these unknowns and no room for others.
template <class... Names, class Model>
consteval bool has_exactly(const Model*) {
  using found = unknowns<Model>;
  return found::size == sizeof...(Names) && (found::template contains<Names> && ...) &&
         sizeof(typename reduced_model<double, Model>::state_type) == sizeof...(Names) * sizeof(double);
}
template <class F>
using model_of = std::remove_cvref_t<std::invoke_result_t<F, scene>> const*;

} // namespace

BOOST_AUTO_TEST_CASE(read_and_written_by_name) {
  three x{};
  x[contact_radius] = 2;
  x[bulk_loss] = 3;
  BOOST_TEST((x[0] == 0 && x[1] == 2 && x[2] == 3));
  const three copy = x;
  BOOST_TEST(copy[contact_radius] == 2);
}

BOOST_AUTO_TEST_CASE(a_scene_pays_only_for_what_is_in_it) {
  using radius = contact_radius_t;
  using root = root_contact_radius_t;
  using rate = approach_rate_t;
  const auto bare = [](const scene& s) { return hertzian(s); };
  static_assert(has_exactly<radius, rate>(model_of<decltype(bare)>{}));
  const auto viscous = [](const scene& s) { return viscous_hertz(s); };
  static_assert(has_exactly<radius, rate>(model_of<decltype(viscous)>{}));
  const auto tsujis = [](const scene& s) { return tsuji_hertz(s); };
  static_assert(has_exactly<root, rate>(model_of<decltype(tsujis)>{}));
  const auto adhesive = [](const scene& s) { return static_jkr(s); };
  static_assert(has_exactly<root, rate>(model_of<decltype(adhesive)>{}));
  const auto crack = [](const scene& s) { return viscoelastic_jkr(s); };
  static_assert(has_exactly<root, rate, mutual_approach_t>(model_of<decltype(crack)>{}));

  const auto timed = [](const scene& s) { return hertzian(s, contact_duration{}); };
  static_assert(has_exactly<radius, rate, elapsed_time_t>(model_of<decltype(timed)>{}));
  const auto traced = [](const scene& s) { return hertzian(s, trajectory{}); };
  static_assert(has_exactly<radius, rate, elapsed_time_t>(model_of<decltype(traced)>{}));
  const auto watched = [](const scene& s) { return viscoelastic_jkr(s, extremes{}); };
  static_assert(has_exactly<root, rate, mutual_approach_t>(model_of<decltype(watched)>{}));
  const auto balanced = [](const scene& s) { return viscous_jkr(s, energy_ledger{}); };
  static_assert(has_exactly<root, rate, bulk_loss_t>(model_of<decltype(balanced)>{}));
  const auto lossless = [](const scene& s) { return static_jkr(s, energy_ledger{}); };
  static_assert(has_exactly<root, rate>(model_of<decltype(lossless)>{}));
  const auto edge_only = [](const scene& s) {
    return static_jkr(s, greenwood_fit{.interaction_range = s.interaction_range}, energy_ledger{});
  };
  static_assert(has_exactly<root, rate, mutual_approach_t, crack_loss_t>(model_of<decltype(edge_only)>{}));
  const auto flowing = [](const scene& s) { return viscous_hertz(s, yielding(s)); };
  static_assert(has_exactly<radius, rate, largest_coordinate_t, plastic_loss_t>(model_of<decltype(flowing)>{}));
  const auto added = [](const scene& s) { return viscous_hertz(s, thornton_ning{}).without_plasticity(); };
  static_assert(has_exactly<radius, rate>(model_of<decltype(added)>{}));
  const auto all = [](const scene& s) {
    return viscoelastic_jkr(s, energy_ledger{}, contact_duration{}, extremes{}, trajectory{});
  };
  constexpr bool last =
      has_exactly<root, rate, mutual_approach_t, elapsed_time_t, bulk_loss_t, crack_loss_t>(model_of<decltype(all)>{});
  BOOST_TEST(last);
}
