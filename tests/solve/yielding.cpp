#include <boost/test/unit_test.hpp>

#include <ricochet/batch/batch.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>

#include "support/random_scenes.hpp"

using namespace support;

namespace {
/// Scenes in which the added loss leaves a small share of the motion's restitution, some of them nothing.
auto nearly_all_lost() {
  scenes random(31);
  std::vector<ricochet::scene<decltype(viscous_jkr(random.next(), thornton_ning{}))>> all;
  while (all.size() < 40) {
    const support::scene s = random.next();
    const auto elastic = collide(viscous_jkr(s), impact{s.speed}, {.tolerance = 1e-12});
    if (!elastic.restitution || *elastic.restitution < 0.1)
      continue;
    // The strength at which the loss is all, found by bisection in its logarithm; and one next to it.
    const auto left_at = [&](double strength) {
      return square(*elastic.restitution) - thornton_ning{strength * pascals}.loss(s.pair, s.speed);
    };
    double low = 1, high = 1e15;
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(low * high);
      (left_at(middle) < 0 ? low : high) = middle;
    }
    const double next = 1 + (all.size() % 3 == 0 ? -1 : 1) * random.log_uniform(1e-7, 1e-2);
    all.push_back({viscous_jkr(s, thornton_ning{high * next * pascals}), impact{s.speed}});
  }
  return all;
}
} // namespace

BOOST_AUTO_TEST_CASE(what_the_loss_leaves_is_known_to_the_tolerance) {
  const auto all = nearly_all_lost();
  const double tolerance = 1e-7;
  const auto together = collide(all, {.tolerance = tolerance});
  int small = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [model, impact] = all[i];
    const auto fine = collide(model, impact, {.tolerance = 1e-11});
    for (const auto& out : {collide(model, impact, {.tolerance = tolerance}), together[i]}) {
      BOOST_TEST(out.error_estimate <= tolerance);
      BOOST_TEST(std::abs(out.restitution.value_or(0) - fine.restitution.value_or(0)) <=
                 out.error_estimate + fine.error_estimate);
    }
    small += fine.restitution && *fine.restitution < 0.01;
  }
  BOOST_TEST(small > 5);
}

BOOST_AUTO_TEST_CASE(a_loss_that_takes_all_is_capture) {
  scenes random(32);
  const support::scene s = random.next();
  const auto out = [&](double loss) {
    auto added = collide(hertzian(s), impact{s.speed});
    add_plastic_loss(added, loss);
    return added;
  };
  BOOST_TEST(out(0.36).restitution.value() == 0.8, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(name_of(out(0.36).ending) == "separated");
  BOOST_TEST(!out(1.01).restitution);
  BOOST_TEST(name_of(out(1.01).ending) == "captured");
  BOOST_TEST((out(0.99).ending_is_certain && out(1.01).ending_is_certain));
  BOOST_TEST((!out(1 - 1e-16).ending_is_certain && !out(1 + 1e-15).ending_is_certain));
}
