// The restitution is a continuous function of speed and of every parameter, wherever the library turns from one way of
// finding it to another. RICOCHET_POINTS sets the number of points of each scan (400 unless given, a hundred times that
// side by side in lanes).
#include <boost/test/unit_test.hpp>

#include "metamorphic/relation.hpp"
#include "support/reference_rows.hpp"

#include <ricochet/batch/batch.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/elastic/linear.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/solve/oblique/oblique.hpp>

using namespace metamorphic;

namespace {

const ice_case ice;

std::size_t points() {
  const char* asked = std::getenv("RICOCHET_POINTS");
  return asked ? std::strtoul(asked, nullptr, 10) : 400;
}

struct point {
  double x, e, error; ///< error: bound of that of e
};

/// Equidistant points on a curve that is smooth but for `bend`, the largest fourth difference that it has itself: a
/// jump shows threefold in the fourth differences, errors add up to 16.
void check_no_jump(const char* name, const std::vector<point>& curve, double bend) {
  double furthest = 0;
  for (std::size_t i = 2; i + 2 < curve.size(); ++i) {
    const double difference =
        std::abs(curve[i - 2].e - 4 * curve[i - 1].e + 6 * curve[i].e - 4 * curve[i + 1].e + curve[i + 2].e);
    double error = 0;
    for (std::size_t j = i - 2; j <= i + 2; ++j)
      error = std::max(error, curve[j].error);
    furthest = std::max(furthest, difference);
    BOOST_TEST(difference <= 16 * error + bend,
               name << " at " << curve[i].x << ": " << difference << ", errors " << error);
  }
  const auto [least, most] =
      std::minmax_element(curve.begin(), curve.end(), [](const point& a, const point& b) { return a.e < b.e; });
  BOOST_TEST_MESSAGE(name << ": fourth differences up to " << furthest << " of values from " << least->e << " to "
                          << most->e);
  BOOST_TEST(most->e > least->e);
}

/// At equal ratios.
template <class Solve>
std::vector<point> scan(double from, double to, const Solve& solve, std::size_t n = points()) {
  std::vector<point> curve;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(n - 1));
    const auto out = solve(x);
    BOOST_TEST_CONTEXT("at " << x)
    BOOST_TEST((out.ending == ending::separated || out.ending == ending::captured), name_of(out.ending));
    curve.push_back({x, out.restitution.value_or(0), out.error_estimate});
  }
  return curve;
}

/// Across a switch at `x`, of collide() and against integrate(); `compose_at(x)` makes the model.
template <class Compose>
void across(const char* name, double x, const Compose& compose_at, speed v) {
  const auto curve = scan( // few points: such damping takes up to 1e7 evaluations where there is no closed form
      x * (1 - 1e-5), x * (1 + 1e-5), [&](double at) { return collide(compose_at(at), impact{v}); }, 30);
  check_no_jump(name, curve, 1e-14);
  for (const double at : {x * (1 - 1e-9), x, x * (1 + 1e-9)}) {
    const auto closed = collide(compose_at(at), impact{v});
    const auto integrated = integrate(compose_at(at), impact{v});
    BOOST_TEST_CONTEXT(name << " at " << at)
    BOOST_TEST(std::abs(closed.restitution.value_or(0) - integrated.restitution.value_or(0)) <=
               closed.error_estimate + integrated.error_estimate + 1e-15);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(closed_forms_go_on_where_they_end) {
  const speed v = 1.0 * metres_per_second;
  const duration A = 1e-9 * seconds;
  const double most = closed_form::largest_damping_number_to_zero_force,
               to_zero_overlap = closed_form::largest_damping_number_to_zero_overlap;
  const auto bulk_time = [&](double number) { return A * (number / closed_form::damping_number(ice.pair, A, v)); };
  const auto viscous = [&](double number, auto... end) {
    return compose(ice.pair, hertz{}, kuwabara_kono{bulk_time(number)}, end...);
  };
  across(
      "Kuwabara and Kono to zero force", most, [&](double y) { return viscous(y); }, v);
  across(
      "to zero overlap", to_zero_overlap, [&](double y) { return viscous(y, end_at_zero_overlap{}); }, v);
  across(
      "Hunt and Crossley", closed_form::detail::hunt_crossley_restitution.last,
      [&](double cv) { return compose(ice.pair, hertz{}, hunt_crossley{cv / v}); }, v);
  across(
      "Tsuji at critical damping", std::sqrt(5.),
      [&](double alpha) { return compose(ice.pair, hertz{}, tsuji{alpha}); }, v);
  const linear spring{1e3 * newtons_per_metre};
  across(
      "spring at critical damping", 2 * std::sqrt(in_si(ice.pair.reduced_mass) * 1e3),
      [&](double c) { return compose(ice.pair, spring, linear_dashpot{c * newtons / metres_per_second}); }, v);
}

BOOST_AUTO_TEST_CASE(yield_sets_in_without_a_jump) {
  const modulus strength = 2e8 * pascals;
  const double yield = in_si(closed_form::yield_speed(ice.pair, strength));
  const auto through_yield = [&](const char* name, const auto& model, double from, double to) {
    // the loss begins as (v - v_y)^2 or steeper: that is the bend allowed
    const auto curve = scan(from, to, [&](double v) { return collide(model, impact{v * metres_per_second}); });
    check_no_jump(name, curve, 20 * square(std::log(to / from) / static_cast<double>(points())));
  };
  through_yield("Hertz with the loss added", compose(ice.pair, hertz{}, thornton_ning{strength}), 0.99 * yield,
                1.01 * yield);
  through_yield("Hertz with plastic flow", compose(ice.pair, hertz{}, thornton_ning_contact{strength}), 0.99 * yield,
                1.01 * yield);
}

BOOST_AUTO_TEST_CASE(speed_and_relaxation_time_through_every_way_of_following_the_edge) {
  // From edges taken as static, over those that the implicit method follows, to such as hug their law's limits.
  greenwood edge = ice.exact(1.0 * seconds);
  edge.table = std::make_shared<const greenwood_table>(edge.modulus_ratio); // else compose() makes one each time
  const auto at = [&](double T, double v, double tolerance) {
    edge.relaxation_time = T * seconds;
    return collide(compose(ice.pair, hertz{}, ice.adhesive, edge), impact{v * metres_per_second},
                   {.tolerance = tolerance});
  };
  check_no_jump("relaxation time at 8 m/s", scan(1e-22, 1e-12, [&](double T) { return at(T, 8, 1e-6); }), 1e-5);
  check_no_jump("slow edges at 8 m/s", scan(1e-12, 3e-11, [&](double T) { return at(T, 8, 1e-8); }), 1e-7);
  check_no_jump("speed, fast edge", scan(3, 60, [&](double v) { return at(1e-14, v, 1e-8); }), 1e-7);
  check_no_jump("speed", scan(8, 60, [&](double v) { return at(1e-11, v, 1e-8); }), 1e-7);
}

BOOST_AUTO_TEST_CASE(range_of_adhesion) {
  // From 4e-9 m on the bodies no longer jump, and nothing is lost: the curve bends into e = 1.
  check_no_jump("range of adhesion at 2 m/s",
                scan(1e-11, 2.5e-9,
                     [](double z0) {
                       return collide(
                           compose(ice.pair, hertz{}, maugis_dugdale{ice.adhesive.work_of_adhesion, z0 * metres}),
                           impact{2.0 * metres_per_second});
                     }),
                1e-6);
}

BOOST_AUTO_TEST_CASE(lanes_and_lone_impacts_lie_on_one_curve) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  const std::size_t n = 100 * points();
  const double from = 2, to = 60;
  std::vector<impact> impacts;
  for (std::size_t i = 0; i < n; ++i)
    impacts.push_back(
        {from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(n - 1)) * metres_per_second});
  const auto outcomes = collide(model, std::span<const impact>(impacts), {.threads = 1});
  std::vector<point> curve;
  for (std::size_t i = 0; i < n; ++i)
    if (outcomes[i].restitution && *outcomes[i].restitution > 0.1) // near sticking e has an infinite slope
      curve.push_back({in_si(impacts[i].speed), *outcomes[i].restitution, outcomes[i].error_estimate});
  check_no_jump("lanes", curve, 1e-12);
}

BOOST_AUTO_TEST_CASE(from_sliding_to_rolling_as_impacts_get_steeper) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, coulomb{0.2});
  std::vector<point> curve;
  const std::size_t n = points();
  double kink = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 0.2 + 1.2 * static_cast<double>(i) / static_cast<double>(n - 1);
    const auto out = collide(model, oblique_impact{.speed = 20.0 * metres_per_second, .angle = angle});
    if (i > 0) // from 5/7 on it rises with a bend, no faster than 2f(1 + e) d(cot angle)
      kink = std::max(kink, std::abs(*out.tangential_restitution - curve.back().e));
    curve.push_back({angle, *out.tangential_restitution, out.normal.slip_error_estimate + out.normal.error_estimate});
  }
  BOOST_TEST(std::abs(curve.front().e - 5. / 7) < 1e-12);
  BOOST_TEST(kink < 2 * 0.2 * 2 * 1.2 / static_cast<double>(n - 1) / square(std::sin(0.6)));
}
