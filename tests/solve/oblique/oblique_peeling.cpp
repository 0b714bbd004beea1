#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/number/autodiff.hpp>
#include <ricochet/solve/oblique/oblique.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

using namespace support;
using closed_form::damping_coefficient_of_brach_dunn;
using Eigen::Vector3d;

namespace {

const speed normal_speed = 2.8 * metres_per_second;

/// Glass on steel, the case of Brach & Dunn's table 1.
const contact_pair table_1 =
    between(sphere{{72.0 * gigapascals, 0.21, 2600.0 * kilograms_per_cubic_metre}, 5.06 * micrometres},
            flat_wall{{207.0 * gigapascals, 0.27, 7800.0 * kilograms_per_cubic_metre}});

auto simulation(const contact_pair& pair, speed v, const auto& tangential, double zeta_a = 6.25) {
  return compose(pair, hertz{},
                 line_force{250.0 * newtons_per_metre, damping_coefficient_of_brach_dunn(zeta_a, pair, v)},
                 hunt_crossley{damping_coefficient_of_brach_dunn(10.54, pair, v)}, tangential);
}
auto peeling(double f, double lambda) { return coulomb_with_peeling{f, lambda * newton_metres}; }

/// Brach and Dunn's equations (B6)-(B10), with their signs put right, in time, by Runge and Kutta's fourth-order steps:
/// in parts of the contact time, shorter at its ends, where the forces go as the root of the depth.
class equations_in_time {
public:
  /// Penetration depth and its rate, tangential velocity, spin, angle, work of friction and of the moment.
  struct state {
    long double d, rate, v, spin, angle, friction, peeling;
  };
  state x{};
  std::string modes; ///< as they followed: + and - sliding either way, 0 rolling

  template <class Model>
  equations_in_time(const Model& model, double v_n, double v_t, double spin, long double lambda, long double f)
      : x{0, v_n, v_t, spin, 0, 0, 0}, r_(in_si(model.pair.reduced_radius)), m_(in_si(model.pair.reduced_mass)),
        K_(4.L / 3 * in_si(model.pair.reduced_modulus)), f_0_(in_si(model.adhesion.force_per_length)),
        c_a_(in_si(model.adhesion.rebound_coefficient)), c_h_(in_si(model.damping.damping_coefficient)), f_(f),
        lambda_(lambda) {
    const long double slip = v_t - r_ * x.spin;
    slide(slip > 0 ? 1 : slip < 0 ? -1 : spin == 0 || lambda == 0 ? 0 : spin > 0 ? 1 : -1);
    const long double time = std::pow(m_ * m_ / (K_ * K_ * r_ * v_n), 0.2L), depth = v_n * time;
    for (long double h = 0; x.d >= 0 || x.rate > 0;) {
      h = 1e-4L * time * std::min(1.L, 1e-6L + x.d / depth);
      const state before = x;
      step(h);
      const bool turned = before.rate > 0 && x.rate <= 0, left = x.d < 0;
      const bool halted = direction_ != 0 && direction_ * slip_of(before) > 0 && direction_ * slip_of(x) <= 0;
      const bool freed = direction_ == 0 && !holds(x);
      if (!(turned || left || halted || freed))
        continue;
      // the earliest of them, by halving
      const auto happened = [&] {
        return (turned && x.rate <= 0) || (left && x.d < 0) || (halted && direction_ * slip_of(x) <= 0) ||
               (freed && !holds(x));
      };
      long double low = 0, high = h;
      for (int i = 0; i < 60; ++i) {
        x = before;
        step((low + high) / 2);
        (happened() ? high : low) = (low + high) / 2;
      }
      x = before;
      step(high);
      if (x.d < 0)
        break;
      if (halted && direction_ * slip_of(x) <= 0) {
        x.v = r_ * x.spin;
        slide(holds(x) ? 0 : x.spin > 0 ? 1 : -1);
      } else if (freed && !holds(x)) {
        slide(x.spin > 0 ? 1 : -1);
      }
    }
  }

private:
  long double press(const state& s) const { return std::sqrt(r_) * K_ * s.d * std::sqrt(s.d); }
  long double moment(const state& s) const { return -lambda_ * c_a_ * std::sqrt(r_ * s.d) * s.spin; }
  long double slip_of(const state& s) const { return s.v - r_ * s.spin; }
  bool holds(const state& s) const { return s.d <= 0 || 5 * std::abs(moment(s)) / (7 * r_) <= f_ * press(s); }
  void slide(int direction) {
    direction_ = direction;
    modes += direction > 0 ? '+' : direction < 0 ? '-' : '0';
  }

  state slope(state s) const {
    s.d = std::max(s.d, 0.L);
    const long double pull = 2 * pi<long double>() * f_0_ * std::sqrt(r_ * s.d), g = moment(s);
    const long double force = direction_ == 0 ? 5 * g / (7 * r_) : -direction_ * f_ * press(s);
    return {s.rate,     (-press(s) * (1 + c_h_ * s.rate) + pull * (s.rate < 0 ? 1 - c_a_ * s.rate : 1)) / m_,
            force / m_, (-r_ * force + g) / (0.4L * m_ * r_ * r_),
            s.spin,     direction_ == 0 ? 0 : -force * slip_of(s),
            -g * s.spin};
  }

  static state moved(const state& s, const state& k, long double h) {
    return {s.d + h * k.d,
            s.rate + h * k.rate,
            s.v + h * k.v,
            s.spin + h * k.spin,
            s.angle + h * k.angle,
            s.friction + h * k.friction,
            s.peeling + h * k.peeling};
  }

  void step(long double h) {
    const state k1 = slope(x), k2 = slope(moved(x, k1, h / 2)), k3 = slope(moved(x, k2, h / 2)),
                k4 = slope(moved(x, k3, h));
    x = moved(moved(moved(moved(x, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }

  long double r_, m_, K_, f_0_, c_a_, c_h_, f_, lambda_;
  int direction_ = 0;
};

// Only a model with the moment has its unknowns and what the outcome says of it.
template <class Outcome>
concept tells_of_peeling = requires(const Outcome& out) {
  out.peeling_loss;
};
using with_moment = decltype(simulation(table_1, normal_speed, peeling(0.1, 1e-7)));
using without_moment = decltype(simulation(table_1, normal_speed, coulomb{0.1}));
static_assert(tells_of_peeling<oblique_outcome<with_moment>> && tells_of_peeling<outcome_of<with_moment>>);
static_assert(!tells_of_peeling<oblique_outcome<without_moment>> && !tells_of_peeling<outcome_of<without_moment>>);
static_assert(reduced_model<double, with_moment>::unknowns::size ==
              reduced_model<double, without_moment>::unknowns::size + 4);
static_assert(sizeof(outcome_of<with_moment>) == sizeof(outcome_of<without_moment>) + 4 * sizeof(double));

} // namespace

BOOST_AUTO_TEST_CASE(the_published_equations_integrated_in_time) {
  struct row {
    double angle, surface_spin, friction; ///< degrees; r spin in units of the speed along the normal
    std::vector<double> lambdas;
    const char* modes;
  };
  const double r = in_si(table_1.reduced_radius), v_n = in_si(normal_speed);
  for (const row& each :
       {row{0, r * 1.4557e5 / v_n, 0.1, {0}, "-0"}, row{0, r * 1.4557e5 / v_n, 0.1, {1e-9, 1e-8, 1e-7, 1e-6}, "-0+"},
        row{40, 0, 0.1, {1e-8, 1e-7}, "+0+"}, row{20, -0.5, 0.1, {1e-8, 1e-7, 1e-6}, "+0+"}, // backspin
        row{5, -0.5, 0.02, {3e-6}, "+0+"}, row{70, 1, 0.1, {1e-7}, "+"},
        row{45, 1.01, 0.1, {1e-7}, "-+0+"}, // the moment turns the slip round
        row{45, 1.01, 0.01, {1e-6}, "-+"}, row{0, 0.7, 0.05, {3e-6}, "-0+"}})
    for (const double lambda : each.lambdas) {
      const auto model = simulation(table_1, normal_speed, peeling(each.friction, lambda));
      const double v_t = v_n * std::tan(each.angle * degrees), spin = each.surface_spin * v_n / r;
      const auto out = collide(
          model,
          spatial_impact{.normal = Vector3d::UnitX(), .velocity = {v_n, v_t, 0}, .spin_1 = -spin * Vector3d::UnitZ()},
          {.tolerance = 1e-11});
      const equations_in_time motion(model, v_n, v_t, spin, lambda, each.friction);
      const auto& x = motion.x;
      const double joules_at_first = in_si(table_1.reduced_mass) / 2 * v_n * v_n;
      const auto near = [](double found, long double expected, double size) {
        return std::abs(found - double(expected)) <= 1e-11 * size; // the tolerance; both come to 5e-14
      };
      const double u = std::max({v_n, v_t, std::abs(r * spin)});
      BOOST_TEST_CONTEXT(each.angle << " degrees, r omega/v_n " << each.surface_spin << ", f " << each.friction
                                    << ", lambda " << lambda << ": " << motion.modes) {
        BOOST_TEST(motion.modes == each.modes);
        BOOST_TEST(near(*out.normal.restitution * v_n, -x.rate, v_n));
        BOOST_TEST(near(out.velocity.y(), x.v, u));
        BOOST_TEST(near(-r * out.spin_1.z(), r * x.spin, u));
        BOOST_TEST(near(out.slip.y(), x.v - r * x.spin, u));
        BOOST_TEST(near(out.rotation_1, std::abs(x.angle), std::abs(double(x.angle))));
        BOOST_TEST(near(out.friction_loss * joules_at_first, x.friction, joules_at_first));
        BOOST_TEST(near(out.peeling_loss * joules_at_first, x.peeling, joules_at_first));
      }
    }
}

BOOST_AUTO_TEST_CASE(a_sphere_that_rolls_slides_again_at_the_very_end) {
  // Near the end the approach rate and the spin stay: integrating friction's 7/2 f F_E and the moment's over the radius
  // from where they balance, a_c^2 = (5/7) lambda c_A omega R^2/(f K R), to zero leaves a slip of (2/3) P a_c^3/(m v
  // R), P = lambda c_A omega/R.
  const double r = in_si(table_1.reduced_radius), m = in_si(table_1.reduced_mass), f = 0.1;
  const double K = 4. / 3 * in_si(table_1.reduced_modulus);
  for (const double lambda : {1e-14, 1e-12, 1e-10}) {
    const auto model = simulation(table_1, normal_speed, peeling(f, lambda));
    for (const double spin : {1.4557e5, -1.4557e5}) {
      const auto out = collide(
          model, oblique_impact{.speed = normal_speed, .angle = 30 * degrees, .spin_1 = spin * radians_per_second});
      const double P = lambda * in_si(model.adhesion.rebound_coefficient) * in_si(out.spin_1) / r;
      const double balance = std::sqrt(5. / 7 * P * r / (f * K));
      const double rate = *out.normal.restitution * in_si(normal_speed) * std::cos(30 * degrees);
      const double expected = 2. / 3 * P * cube(balance) / (m * rate * r);
      BOOST_TEST(!out.rolls);
      BOOST_TEST(std::abs(in_si(out.normal.slip) / expected - 1) < 50 * balance / r); // of higher order in the radius
    }
  }
}

BOOST_AUTO_TEST_CASE(without_a_moment_it_is_coulombs_law) {
  scenes source(131);
  for (int i = 0; i < 200; ++i) {
    const scene s = source.next();
    const auto pair = std::isinf(in_si(s.pair.bodies.radius_2)) ? s.pair : table_1;
    const line_force ring{1e-3 * s.work_of_adhesion / std::sqrt(in_si(s.work_of_adhesion)), 0.3 / s.speed};
    const hunt_crossley damping{s.hunt_crossley_coefficient};
    const double f = source.log_uniform(1e-3, 3), spin = source.log_uniform(1e-3, 10) * (i % 2 ? 1 : -1);
    const oblique_impact impact{.speed = s.speed,
                                .angle = i % 5 ? source.log_uniform(1e-3, 1.5) : 0,
                                .spin_1 = i % 3 ? spin * s.speed / pair.reduced_radius : angular_speed{}};
    const auto mine = collide(compose(pair, hertz{}, ring, damping, peeling(f, 0)), impact, {.tolerance = 1e-12});
    const auto coulombs = collide(compose(pair, hertz{}, ring, damping, coulomb{f}), impact, {.tolerance = 1e-12});
    BOOST_TEST_REQUIRE((mine.normal.ending == coulombs.normal.ending));
    BOOST_TEST_REQUIRE(mine.rolls == coulombs.rolls);
    BOOST_TEST_REQUIRE(mine.peeling_loss == 0);
    const double size = in_si(s.speed) * std::max(1., std::abs(spin)), r = in_si(pair.reduced_radius);
    BOOST_TEST(std::abs(mine.normal.restitution.value_or(0) - coulombs.normal.restitution.value_or(0)) < 1e-12);
    BOOST_TEST(std::abs(in_si(mine.tangential_speed - coulombs.tangential_speed)) < 1e-12 * size);
    BOOST_TEST(std::abs(in_si(mine.spin_1 - coulombs.spin_1)) * r < 1e-12 * size);
    BOOST_TEST(std::abs(in_si(mine.normal.slip - coulombs.normal.slip)) < 1e-12 * size);
    BOOST_TEST(std::abs(mine.rotation_1 - coulombs.rotation_1) < 1e-12 * std::max(1., coulombs.rotation_1));
  }
}

namespace {
/// A random sphere on a wall: adhesion from next to none to capture, any friction, moments from none to such as stop
/// the turning at once, grazing impacts and fast spins.
struct random_impact {
  contact_pair pair;
  line_force ring;
  hunt_crossley damping;
  coulomb_with_peeling tangential;
  oblique_impact at;

  explicit random_impact(scenes& source) {
    scene s = source.next();
    while (!std::isinf(in_si(s.pair.bodies.radius_2)))
      s = source.next();
    pair = s.pair;
    const double angle = source.log_uniform(1e-3, 1.57), v = in_si(s.speed), normal = v * std::cos(angle);
    const double R = in_si(pair.reduced_radius), m = in_si(pair.reduced_mass), kinetic = m * normal * normal;
    const double radius = std::pow(kinetic / (in_si(pair.reduced_modulus) * cube(R)), 0.2); // of the contact, in R
    ring = {source.log_uniform(1e-4, 1) * kinetic / (R * R * cube(radius)) * newtons_per_metre,
            source.log_uniform(1e-2, 10) / normal * seconds_per_metre};
    damping = {source.log_uniform(1e-3, 1) / normal * seconds_per_metre};
    tangential = {source.log_uniform(1e-4, 3), source.log_uniform(1e-4, 30) * kinetic / cube(radius) * joules};
    const double turning = source.log_uniform(1e-3, 1e2) * v / R;
    at = {.speed = s.speed,
          .angle = angle,
          .spin_1 = (source.log_uniform(1, 4) < 2 ? turning : -turning) * radians_per_second};
    if (source.log_uniform(1, 10) < 1.2) // it rolls as it comes
      at.spin_1 = v * std::sin(angle) / R * radians_per_second;
  }
  auto model() const { return compose(pair, hertz{}, ring, damping, tangential); }
};
} // namespace

BOOST_AUTO_TEST_CASE(the_energies_balance_and_none_is_gained) {
  scenes source(132);
  int captured = 0, held = 0, peeled = 0;
  for (int i = 0; i < 10000; ++i) {
    const random_impact s(source);
    const auto out = collide(s.model(), s.at, {.tolerance = 1e-6});
    BOOST_TEST_REQUIRE((out.normal.ending == ending::separated || out.normal.ending == ending::captured));
    captured += out.normal.ending == ending::captured;
    held += out.rolls;
    peeled += out.peeling_loss > 0.01;
    const double v = in_si(s.at.speed), R = in_si(s.pair.reduced_radius), normal = v * std::cos(s.at.angle);
    const auto along_surface = [&](double speed, angular_speed spin) { // in units of the normal kinetic energy
      return (square(speed) + 0.4 * square(R * in_si(spin))) / square(normal);
    };
    const double before = along_surface(v * std::sin(s.at.angle), s.at.spin_1),
                 after = along_surface(in_si(out.tangential_speed), out.spin_1);
    const double lost = out.friction_loss + out.peeling_loss;
    BOOST_TEST_REQUIRE(std::abs(before - after - lost) <= 1e-6 * std::max(1., before)); // the tolerance
    BOOST_TEST_REQUIRE(after <= before * (1 + 1e-15));                                  // roundings of the sums above
    BOOST_TEST_REQUIRE(out.friction_loss >= 0);
    BOOST_TEST_REQUIRE(out.peeling_loss >= 0);
    BOOST_TEST_REQUIRE(out.normal.restitution.value_or(0) <= 1);
  }
  BOOST_TEST(captured > 1000);
  BOOST_TEST(held > 1000); // captured ones only: the others slide again
  BOOST_TEST(peeled > 1000);
}

BOOST_AUTO_TEST_CASE(its_errors_are_bounded) {
  scenes source(133);
  for (int i = 0; i < 100; ++i) {
    const random_impact s(source);
    const auto rough = collide(s.model(), s.at, {.tolerance = 1e-4}),
               fine = collide(s.model(), s.at, {.tolerance = 1e-12});
    if (!rough.normal.restitution || !fine.normal.restitution)
      continue;
    const double v = in_si(s.at.speed), turning = std::abs(in_si(s.at.spin_1)) * in_si(s.pair.reduced_radius);
    const double along = v * std::sin(s.at.angle),
                 at_most = rough.normal.slip_error_estimate + fine.normal.slip_error_estimate;
    const double slip_at_touch = std::abs(along - in_si(s.at.spin_1) * in_si(s.pair.reduced_radius));
    const double size = std::max(slip_at_touch, turning);
    BOOST_TEST(std::abs(in_si(rough.normal.slip - fine.normal.slip)) <= at_most * size);
    BOOST_TEST(std::abs(in_si(rough.spin_1 - fine.spin_1)) * in_si(s.pair.reduced_radius) <= at_most * size);
  }
}

BOOST_AUTO_TEST_CASE(another_stepper_and_a_turned_scene_come_to_the_same) {
  const auto model = simulation(table_1, normal_speed, peeling(0.1, 1e-7));
  const double v = in_si(normal_speed), r = in_si(table_1.reduced_radius);
  std::mt19937_64 generator(134);
  std::normal_distribution<> normal;
  for (const double tangential : {0., 0.3, -2.}) {
    const spatial_impact impact{
        .normal = 3 * Vector3d::UnitX(), .velocity = {v, tangential * v, 0}, .spin_1 = 0.4 * v / r * Vector3d::UnitZ()};
    const auto out = collide(model, impact), other = collide(model, impact, {}, stepper::dopri5{});
    BOOST_TEST(out.normal.evaluations != other.normal.evaluations);
    BOOST_TEST((out.velocity - other.velocity).norm() < 2e-8 * v);
    BOOST_TEST((out.spin_1 - other.spin_1).norm() * r < 2e-8 * v);
    BOOST_TEST(std::abs(out.peeling_loss - other.peeling_loss) < 2e-8);
    const auto turn =
        Eigen::Quaterniond(normal(generator), normal(generator), normal(generator), normal(generator)).normalized();
    const auto turned =
        collide(model, spatial_impact{turn * impact.normal, turn * impact.velocity, turn * impact.spin_1});
    BOOST_TEST((turned.velocity - turn * out.velocity).norm() < 1e-13 * v);
    BOOST_TEST((turned.spin_1 - turn * out.spin_1).norm() * r < 1e-13 * v);
    BOOST_TEST((turned.slip - turn * out.slip).norm() < 1e-13 * v);
  }
}

BOOST_AUTO_TEST_CASE(an_impact_by_its_slip_and_spin) {
  const auto model = simulation(table_1, normal_speed, peeling(0.1, 1e-7));
  const double r = in_si(table_1.reduced_radius);
  const angular_speed spin = 1e5 * radians_per_second;
  const auto whole = collide(model, spatial_impact{.normal = Vector3d::UnitX(),
                                                   .velocity = {in_si(normal_speed), 0.1 + in_si(spin) * r, 0},
                                                   .spin_1 = -in_si(spin) * Vector3d::UnitZ()});
  const auto contact = collide(model, impact{.speed = normal_speed, .slip = 0.1 * metres_per_second, .spin = spin});
  BOOST_TEST(std::abs(in_si(contact.slip) - whole.slip.y()) < 1e-14);
  BOOST_TEST(std::abs(in_si(contact.spin) + whole.spin_1.z()) < 1e-8);
  BOOST_TEST(std::abs(contact.rotation - whole.rotation_1) < 1e-14);
  BOOST_TEST(std::abs(contact.peeling_loss - whole.peeling_loss) < 1e-14);
}

BOOST_AUTO_TEST_CASE(head_on_and_without_spin_nothing_turns) {
  const auto model = simulation(table_1, normal_speed, peeling(0.1, 1e-7));
  const auto out = collide(model, oblique_impact{.speed = normal_speed});
  BOOST_TEST(out.rolls);
  BOOST_TEST((in_si(out.spin_1) == 0 && in_si(out.tangential_speed) == 0 && out.rotation_1 == 0));
  BOOST_TEST((out.peeling_loss == 0 && out.friction_loss == 0));
}

BOOST_AUTO_TEST_CASE(what_leaves_the_plane_or_the_wall_is_refused) {
  const auto model = simulation(table_1, normal_speed, peeling(0.1, 1e-7));
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const auto says = [](const char* words) {
    return [words](const bad_input& refused) { return std::string(refused.what()).find(words) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(collide(model, spatial_impact{.normal = x, .velocity = x + y, .spin_1 = 1e3 * x}), bad_input,
                        says("spin_1 = 1000 rad/s about the normal"));
  BOOST_CHECK_EXCEPTION(collide(model, spatial_impact{.normal = x, .velocity = x + y, .spin_1 = 1e3 * (y + z)}),
                        bad_input, says("is not perpendicular to the plane of normal and velocity"));
  BOOST_CHECK_NO_THROW(collide(model, spatial_impact{.normal = x, .velocity = x, .spin_1 = 1e3 * (y + z)}));
  const sphere ball{materials::steel, 1 * millimetres};
  BOOST_CHECK_EXCEPTION(simulation(between(ball, ball), normal_speed, peeling(0.1, 1e-7)), bad_input,
                        says("radius of the second body = 0.001 m"));
  BOOST_CHECK_EXCEPTION(simulation(table_1, normal_speed, peeling(0.1, -1)), bad_input, says("peeling_moment = -1 J"));
  BOOST_CHECK_EXCEPTION(collide(simulation(table_1, normal_speed, coulomb{0.1}),
                                impact{.speed = normal_speed, .spin = 1 * radians_per_second}),
                        bad_input, says("spin = 1 rad/s"));
}

BOOST_AUTO_TEST_CASE(derivatives_come_out_on_dual_numbers) {
  // Next to no pull: the kink of its damping where the rebound begins falls on single stages of a step, which is
  // nothing to the motion but to derivatives along it.
  const auto model =
      compose(table_1, hertz{},
              line_force{1e-9 * newtons_per_metre, damping_coefficient_of_brach_dunn(6.25, table_1, normal_speed)},
              hunt_crossley{damping_coefficient_of_brach_dunn(10.54, table_1, normal_speed)}, peeling(0.1, 1e-7));
  const scales unit = scales_at(model, normal_speed);
  using model_type = std::remove_const_t<decltype(model)>;
  const auto parameter = [](auto& numbers, int i) -> auto& {
    return i == 0   ? numbers.tangential.peeling_moment
           : i == 1 ? numbers.tangential.friction_coefficient
                    : numbers.adhesion.rebound_coefficient;
  };
  const auto solve = [](const auto& numbers, double spin, double tolerance) {
    using T = typename std::remove_cvref_t<decltype(numbers)>::number;
    collision<std::remove_cvref_t<decltype(numbers)>, stepper::fehlberg78> solver(numbers, tolerance, 10'000'000);
    return solver.solve(T(1), T(0.01), T(spin) / numbers.pair.reduced_radius);
  };
  for (const double spin : {0.5, -0.8, -1.01}) // it slides, rolls and slides; backspin alike; the slip turns round
    for (const int i : {0, 1, 2}) {
      reduced_model<dual<>, model_type> numbers(model, unit);
      const double at = value_of(parameter(numbers, i)), step = 1e-5 * at;
      parameter(numbers, i) = seeded(at);
      numbers.prepare();
      const auto found = solve(numbers, spin, 1e-11);
      reduced_model<long double, model_type> more(model, unit), less(model, unit);
      parameter(more, i) += step;
      parameter(less, i) -= step;
      const auto above = solve(more, spin, 1e-16), below = solve(less, spin, 1e-16);
      const auto compare = [&](const dual<>& x, long double high, long double low) {
        BOOST_TEST(std::abs(x.derivative(1) * at - double((high - low) / (2 * step)) * at) <
                   1e-8); // the square of the step, and errors over it
      };
      BOOST_TEST_CONTEXT("r omega = " << spin << ", parameter " << i) {
        compare(found.spin, above.spin, below.spin);
        compare(found.slip, above.slip, below.slip);
        compare(found.peeling_loss, above.peeling_loss, below.peeling_loss);
        compare(found.friction_loss, above.friction_loss, below.friction_loss);
      }
    }
}
