#include <boost/test/unit_test.hpp>

#include "../support/reference_rows.hpp"

#include <ricochet/body/materials.hpp>
#include <ricochet/closed_form/rigid_body.hpp>

#include <Eigen/Dense>

using namespace support;
namespace rigid = ricochet::closed_form::rigid_body;
using rigid::coefficients, rigid::solid_sphere, rigid::velocities;

namespace {

const auto per_second = 1.0 / seconds;
const auto newton_seconds = newtons * seconds;

auto says(const std::string& name, const std::string& value, const std::string& allowed) {
  return [=](const bad_input& e) {
    const std::string text = e.what();
    return text.find(name) != text.npos && text.find(value) != text.npos && text.find(allowed) != text.npos;
  };
}

struct case_of_impact {
  solid_sphere body;
  velocities before;
  coefficients c;

  double spin() const { return in_si(body.radius * before.angular); }
  /// The largest speed before the impact: the scale of round-off.
  double scale() const {
    return std::max({in_si(before.normal), std::abs(in_si(before.tangential)), std::abs(spin())});
  }
};

class impacts {
public:
  explicit impacts(unsigned seed) : generator_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator_); }
  double either_sign(double low, double high) {
    return (generator_() % 2 ? 1 : -1) * low * std::exp(uniform(0, std::log(high / low)));
  }

  /// Spinning, oblique, with a moment that opposes the spin and an impulse ratio anywhere where energy is lost.
  case_of_impact next() {
    const double radius = std::abs(either_sign(5e-7, 1e-3)), v = std::abs(either_sign(0.01, 50));
    case_of_impact out{{std::abs(either_sign(1e-16, 1e-6)) * kilograms, radius * metres},
                       {v * metres_per_second, either_sign(1e-3, 1e2) * v * metres_per_second,
                        either_sign(1e-3, 1e2) * v / radius * per_second},
                       {.restitution_without_adhesion = uniform(0, 1),
                        .adhesion_coefficient = uniform(0, 1),
                        .moment_coefficient = 0,
                        .moment_arm = uniform(0.01, 0.2) * radius * metres}};
    double moment = (out.spin() > 0 ? -1 : 1) * uniform(0, 20);
    for (bool found = false; !found; moment /= 2)
      try {
        out.c.moment_coefficient = moment;
        const auto [low, high] = rigid::impulse_ratio_bounds(out.body, out.before, out.c);
        out.c.impulse_ratio = uniform(low, high);
        found = true;
      } catch (const bad_input&) { // too large a moment
      }
    return out;
  }

private:
  std::mt19937 generator_;
};

double momentum_about_contact(const solid_sphere& body, const velocities& at) {
  return in_si(body.mass * body.radius * (at.tangential + 0.4 * body.radius * at.angular));
}

} // namespace

BOOST_AUTO_TEST_CASE(energy_loss_is_the_difference_of_kinetic_energies) {
  impacts random(41);
  double worst = 0, least = 1;
  for (int i = 0; i < 10'000; ++i) {
    const auto [body, before, c] = random.next();
    const double initial = in_si(rigid::kinetic_energy(body, before));
    const double difference = initial - in_si(rigid::kinetic_energy(body, rigid::after_impact(body, before, c)));
    const double loss = in_si(rigid::energy_loss(body, before, c));
    worst = std::max(worst, std::abs(loss - difference) / initial);
    least = std::min(least, loss / initial);
  }
  BOOST_TEST_MESSAGE("largest deviation " << worst << ", least loss " << least);
  BOOST_TEST(worst < 1e-13); // some ten roundings of terms no larger than a few initial energies
  BOOST_TEST(least > -1e-13);
}

BOOST_AUTO_TEST_CASE(angular_momentum_about_the_contact_point_changes_by_the_moment_only) {
  impacts random(42);
  double worst = 0;
  for (int i = 0; i < 2'000; ++i) {
    auto s = random.next();
    for (const bool with_moment : {true, false}) {
      if (!with_moment) {
        s.c.moment_coefficient = 0;
        const auto [low, high] = rigid::impulse_ratio_bounds(s.body, s.before, s.c);
        s.c.impulse_ratio = random.uniform(low, high);
      }
      const auto after = rigid::after_impact(s.body, s.before, s.c);
      const double moment =
          with_moment ? in_si(s.c.moment_per_impulse() * rigid::normal_impulse(s.body, s.before, after)) : 0;
      const double change = momentum_about_contact(s.body, after) - momentum_about_contact(s.body, s.before);
      worst = std::max(worst, std::abs(change - moment) / (in_si(s.body.mass * s.body.radius) * s.scale()));
    }
  }
  BOOST_TEST(worst < 1e-14); // a few roundings of sums of momenta no larger than the scale's few times
}

BOOST_AUTO_TEST_CASE(coulomb_friction_ends_in_rolling_or_slides_on) {
  impacts random(43);
  int rolled = 0, slid = 0;
  for (int i = 0; i < 2'000; ++i) {
    auto s = random.next();
    s.c.moment_coefficient = 0;
    const double friction = std::abs(random.either_sign(1e-2, 10));
    const double limit = rigid::limiting_impulse_ratio(s.body, s.before, s.c);
    const auto outcome = rigid::coulomb_impulse_ratio(s.body, s.before, s.c, friction);
    s.c.impulse_ratio = outcome.impulse_ratio;
    const auto after = rigid::after_impact(s.body, s.before, s.c);
    const double slip = in_si(rigid::contact_point_velocity(s.body, s.before));
    const double left = in_si(rigid::contact_point_velocity(s.body, after));
    BOOST_TEST(outcome.rolls == (friction >= std::abs(limit)));
    BOOST_TEST(outcome.impulse_ratio * slip < 0); // friction against slip
    if (outcome.rolls) {
      ++rolled;
      BOOST_TEST(std::abs(left) < 1e-14 * s.scale()); // a few roundings
    } else {
      ++slid;
      BOOST_TEST(std::abs(outcome.impulse_ratio) == friction);
      BOOST_TEST(left / slip > 0);
      BOOST_TEST(left / slip < 1);
    }
  }
  BOOST_TEST(rolled > 200);
  BOOST_TEST(slid > 200);
}

BOOST_AUTO_TEST_CASE(limiting_ratio_with_moment_makes_it_roll_and_loses_most) {
  impacts random(44);
  for (int i = 0; i < 1'000; ++i) {
    auto s = random.next();
    s.c.impulse_ratio = rigid::limiting_impulse_ratio(s.body, s.before, s.c);
    const auto after = rigid::after_impact(s.body, s.before, s.c);
    BOOST_TEST(std::abs(in_si(rigid::contact_point_velocity(s.body, after))) < 2e-14 * s.scale()); // a few roundings
    const auto most = rigid::energy_loss(s.body, s.before, s.c);
    for (const double factor : {0.9, 1.1}) {
      auto other = s.c;
      other.impulse_ratio *= factor;
      BOOST_TEST(in_si(rigid::energy_loss(s.body, s.before, other)) < in_si(most));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_energy_is_lost_at_the_bounds_and_none_gained_beyond) {
  impacts random(45);
  double worst = 0;
  for (int i = 0; i < 1'000; ++i) {
    auto s = random.next();
    const auto [low, high] = rigid::impulse_ratio_bounds(s.body, s.before, s.c);
    const double middle = rigid::limiting_impulse_ratio(s.body, s.before, s.c);
    for (const double end : {low, high}) {
      s.c.impulse_ratio = end;
      worst = std::max(
          worst, std::abs(double(rigid::energy_loss(s.body, s.before, s.c) / rigid::kinetic_energy(s.body, s.before))));
      BOOST_CHECK_NO_THROW(rigid::after_impact(s.body, s.before, s.c));
      s.c.impulse_ratio = middle + 1.01 * (end - middle);
      if ((high - low) > 1e-3 * std::abs(middle))
        BOOST_CHECK_EXCEPTION(rigid::after_impact(s.body, s.before, s.c), bad_input,
                              says("impulse_ratio", shown(s.c.impulse_ratio), "is outside ["));
    }
  }
  BOOST_TEST(worst < 1e-13); // as the energy's
}

BOOST_AUTO_TEST_CASE(largest_moment) {
  // At rest but for the approach, in units of it: loss(mu_0) = 1 - e^2 - 5/7 (M (1 + e))^2, M = mu_m a_c/r.
  const solid_sphere body{1e-12 * kilograms, 1.0 * micrometres};
  const velocities before{1.0 * metres_per_second, {}, {}};
  const double e = 0.6, largest = std::sqrt(1.4 * (1 - e) / (1 + e));
  coefficients c{.restitution_without_adhesion = e, .moment_coefficient = 1, .moment_arm = 1.0 * micrometres};
  for (const double sign : {-1., 1.}) {
    c.moment_coefficient = sign * largest * (1 - 1e-9);
    BOOST_CHECK_NO_THROW(rigid::impulse_ratio_bounds(body, before, c));
    c.moment_coefficient = sign * largest * (1 + 1e-9);
    BOOST_CHECK_EXCEPTION(rigid::impulse_ratio_bounds(body, before, c), bad_input,
                          says("moment_coefficient", "0.5916", "[-0.591608, 0.591608]"));
    c.moment_coefficient = 2 * sign * largest;
    BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, c), bad_input,
                          says("moment_coefficient", "1.18", "[-0.591608, 0.591608]"));
  }
  // the general limit, by bisection along the ratio that loses most
  impacts random(46);
  for (int i = 0; i < 200; ++i) {
    auto s = random.next();
    for (const double sign : {-1., 1.}) {
      const auto loses = [&](double moment) {
        s.c.moment_coefficient = moment;
        s.c.impulse_ratio = rigid::limiting_impulse_ratio(s.body, s.before, s.c);
        return rigid::energy_loss(s.body, s.before, s.c) >= energy();
      };
      double inside = 0, outside = sign;
      while (loses(outside))
        outside *= 2;
      for (int bisections = 0; bisections < 60; ++bisections)
        (loses((inside + outside) / 2) ? inside : outside) = (inside + outside) / 2;
      const double step = 1e-6 * std::max(std::abs(inside), in_si(s.body.radius) / in_si(s.c.moment_arm));
      loses(inside - sign * step);
      BOOST_CHECK_NO_THROW(rigid::after_impact(s.body, s.before, s.c));
      if (s.c.moment_coefficient * s.spin() <= 0)
        BOOST_CHECK_NO_THROW(rigid::impulse_ratio_bounds(s.body, s.before, s.c));
      loses(inside + sign * step);
      BOOST_CHECK_EXCEPTION(rigid::after_impact(s.body, s.before, s.c), bad_input,
                            says("moment_coefficient", "", "is outside ["));
    }
  }
}

BOOST_AUTO_TEST_CASE(velocities_give_the_coefficients_back) {
  impacts random(47);
  double adhesion = 0, ratio = 0, moment = 0;
  for (int i = 0; i < 2'000; ++i) {
    const auto s = random.next();
    const auto after = rigid::after_impact(s.body, s.before, s.c);
    const auto found =
        rigid::from_velocities(s.body, s.before, after, s.c.restitution_without_adhesion, s.c.moment_arm);
    const double arm = s.c.moment_arm / s.body.radius, scale = s.scale() / in_si(s.before.normal);
    adhesion = std::max(adhesion, std::abs(found.adhesion_coefficient - s.c.adhesion_coefficient));
    ratio = std::max(ratio, std::abs(found.impulse_ratio - s.c.impulse_ratio) / scale);
    moment = std::max(moment, std::abs(found.moment_coefficient - s.c.moment_coefficient) * arm / scale);
    BOOST_TEST(found.restitution_without_adhesion == s.c.restitution_without_adhesion);
    BOOST_TEST((found.moment_arm == s.c.moment_arm));
  }
  // a few roundings of numbers next to one, of velocities next to the largest
  BOOST_TEST(adhesion < 2e-15);
  BOOST_TEST(ratio < 1e-14);
  BOOST_TEST(moment < 1e-14);
  // No adhesion stays none, although e/R is rounded.
  for (int i = 0; i < 1'000; ++i) {
    auto s = random.next();
    s.c = {.restitution_without_adhesion = random.uniform(0.01, 1), .moment_arm = s.c.moment_arm};
    const auto after = rigid::after_impact(s.body, s.before, s.c);
    const auto found =
        rigid::from_velocities(s.body, s.before, after, s.c.restitution_without_adhesion, s.c.moment_arm);
    BOOST_TEST(found.adhesion_coefficient == 0);
  }
}

// The paper's twelve system equations (A5)-(A16), moments by P_n of each phase, solved as they stand.
BOOST_AUTO_TEST_CASE(system_equations_with_external_impulses) {
  impacts random(48);
  double worst = 0, energies = 0;
  for (int i = 0; i < 500; ++i) {
    const auto s = random.next();
    const double m = in_si(s.body.mass), r = in_si(s.body.radius), v = in_si(s.before.normal);
    const double R = s.c.restitution_without_adhesion, rho = s.c.adhesion_coefficient, mu = s.c.impulse_ratio;
    const double lever = in_si(s.c.moment_per_impulse());
    const double on_approach = random.uniform(-1, 1); // in units of m v
    const double on_rebound = random.uniform(-(1 - rho) * R * (1 - on_approach), 1);
    // unknowns, in units of m, r, v: V_n (outward), V_t, r Omega, and between the phases v_t, r omega; P_D, P_t, M_A of
    // approach; P_D, P_t, P_A, M_A of rebound
    enum { Vn, Vt, Omega, vt, omega, PDa, Pta, Ma, PDr, Ptr, PAr, Mr };
    Eigen::Matrix<double, 12, 12> A = Eigen::Matrix<double, 12, 12>::Zero();
    Eigen::Matrix<double, 12, 1> b = Eigen::Matrix<double, 12, 1>::Zero();
    A(0, PDa) = 1, b(0) = 1 - on_approach;
    A(1, vt) = 1, A(1, Pta) = -1, b(1) = in_si(s.before.tangential) / v;
    A(2, omega) = 0.4, A(2, Pta) = 1, A(2, Ma) = -1, b(2) = 0.4 * s.spin() / v;
    A(3, Vn) = 1, A(3, PDr) = -1, A(3, PAr) = -1, b(3) = on_rebound;
    A(4, Vt) = 1, A(4, vt) = -1, A(4, Ptr) = -1;
    A(5, Omega) = 0.4, A(5, omega) = -0.4, A(5, Ptr) = 1, A(5, Mr) = -1;
    A(6, PDr) = 1, A(6, PDa) = -R;
    A(7, Pta) = 1, A(7, PDa) = -mu, b(7) = mu * on_approach;
    A(8, Ptr) = 1, A(8, PDr) = -mu, A(8, PAr) = -mu, b(8) = mu * on_rebound;
    A(9, PAr) = 1, A(9, PDr) = rho;
    A(10, Ma) = 1, A(10, PDa) = -lever / r, b(10) = lever / r * on_approach;
    A(11, Mr) = 1, A(11, PDr) = -lever / r, A(11, PAr) = -lever / r, b(11) = lever / r * on_rebound;
    const Eigen::Matrix<double, 12, 1> x = A.partialPivLu().solve(b);

    const rigid::external_impulses external{m * v * on_approach * newton_seconds, m * v * on_rebound * newton_seconds};
    const auto after = rigid::after_impact(s.body, s.before, s.c, external);
    const double scale = std::max(s.scale() / v, x.lpNorm<Eigen::Infinity>());
    worst = std::max({worst, std::abs(-in_si(after.normal) / v - x(Vn)) / scale,
                      std::abs(in_si(after.tangential) / v - x(Vt)) / scale,
                      std::abs(in_si(s.body.radius * after.angular) / v - x(Omega)) / scale});
    // P_n holds the external impulses too
    const double all = x(PDa) + x(PDr) + x(PAr) + on_approach + on_rebound;
    BOOST_TEST(std::abs(in_si(rigid::normal_impulse(s.body, s.before, after)) / (m * v) - all) < 1e-14 * scale);
    const energy initial = rigid::kinetic_energy(s.body, s.before), final = rigid::kinetic_energy(s.body, after);
    energies =
        std::max(energies, std::abs(double((initial - final - rigid::energy_loss(s.body, s.before, s.c, external)) /
                                           std::max(initial, final))));
  }
  BOOST_TEST(worst < 1e-13); // round-off of twelve equations with numbers up to some hundred
  BOOST_TEST(energies < 1e-13);
}

BOOST_AUTO_TEST_CASE(external_impulses_of_zero_change_nothing) {
  impacts random(49);
  for (int i = 0; i < 200; ++i) {
    const auto s = random.next();
    const auto without = rigid::after_impact(s.body, s.before, s.c);
    for (const double size : {0., 1e-30}) { // exactly, and without the shortcuts for none
      const auto with = rigid::after_impact(s.body, s.before, s.c, {size * in_si(s.body.mass) * newton_seconds, {}});
      BOOST_TEST(
          (with.normal == without.normal && with.tangential == without.tangential && with.angular == without.angular));
    }
    BOOST_TEST(std::abs(rigid::restitution(s.body, s.before, s.c) -
                        s.c.restitution_without_adhesion * (1 - s.c.adhesion_coefficient)) < 5e-16); // roundings
  }
}

BOOST_AUTO_TEST_CASE(attachment_leaves_no_motion) {
  impacts random(50);
  for (int i = 0; i < 1'000; ++i) {
    const auto s = random.next();
    const auto c = rigid::attachment(s.body, s.before, s.c.restitution_without_adhesion, s.c.moment_arm);
    const auto after = rigid::after_impact(s.body, s.before, c);
    BOOST_TEST((after.normal == speed()));
    BOOST_TEST(std::abs(in_si(after.tangential)) < 1e-15 * s.scale()); // a few roundings
    BOOST_TEST(std::abs(in_si(s.body.radius * after.angular)) < 1e-14 * s.scale());
    BOOST_TEST(!rigid::rebound_angle(after).has_value());
    BOOST_TEST(std::abs(double(rigid::energy_loss(s.body, s.before, c) / rigid::kinetic_energy(s.body, s.before)) - 1) <
               1e-13); // as the energy's
    // at rest it also rolls: the paper's mu = mu_0
    BOOST_TEST(std::abs(rigid::limiting_impulse_ratio(s.body, s.before, c) - c.impulse_ratio) <
               1e-15 * s.scale() / in_si(s.before.normal));
    // the moment opposes the spin unless there is backspin
    const double spin = s.spin(), tangential = in_si(s.before.tangential);
    BOOST_TEST((c.moment_coefficient * spin <= 0) == (tangential * spin >= -0.4 * spin * spin));
  }
}

BOOST_AUTO_TEST_CASE(works_of_adhesion_differ_by_the_work_withheld) {
  impacts random(51);
  for (int i = 0; i < 1'000; ++i) {
    const auto [body, before, c] = random.next();
    const double normal = 0.5 * in_si(body.mass * before.normal * before.normal);
    const auto works = rigid::works_of_adhesion(body, before, c);
    const double e = rigid::restitution(body, before, c), R = c.restitution_without_adhesion;
    // four roundings of parts of the normal energy
    BOOST_TEST(std::abs(in_si(works.by_restitution) - (R * R - e * e) * normal) < 1e-15 * normal);
    BOOST_TEST(std::abs(in_si(works.by_restitution - works.of_impulse - works.restoring_withheld)) < 1e-15 * normal);
    // The work of an impulse P of adhesion that grows along with the rest, from rest to V_n, is P V_n/2.
    const double impulse_of_adhesion = c.adhesion_coefficient * R * in_si(body.mass * before.normal);
    BOOST_TEST(std::abs(in_si(works.of_impulse) - impulse_of_adhesion * e * in_si(before.normal) / 2) < 1e-15 * normal);
  }
}

BOOST_AUTO_TEST_CASE(rebound_angle_has_the_sign_of_the_tangential_velocity) {
  const velocities right{-1.0 * metres_per_second, 1.0 * metres_per_second, {}};
  const velocities left{-1.0 * metres_per_second, -1.0 * metres_per_second, {}};
  BOOST_TEST(std::abs(*rigid::rebound_angle(right) - std::numbers::pi / 4) < 1e-15); // one rounding
  BOOST_TEST(std::abs(*rigid::rebound_angle(left) + std::numbers::pi / 4) < 1e-15);
}

// Table 1: V_n and a rebound at 5.75 degrees are measured, rolling is assumed. The paper goes on with R = 0.978 and e =
// 0.746, the former cut off after three digits.
BOOST_AUTO_TEST_CASE(numbers_of_brach_and_dunn_1995) {
  const sphere glass{materials::silver_coated_glass, 5.06 * micrometres};
  const solid_sphere body{glass.mass(), glass.radius};
  const double R = 0.978, e = 0.746;
  const speed outward = e * 2.8 * metres_per_second;
  const speed sideways = 2.09 * std::tan(5.75 * std::numbers::pi / 180) * metres_per_second;
  // without v_t and moment the angular momentum 2/5 r omega is that of rolling, 7/5 V_t
  const velocities before{2.8 * metres_per_second, {}, 3.5 * sideways / body.radius};
  const velocities measured{-outward, sideways, sideways / body.radius};
  auto c = rigid::from_velocities(body, before, measured, R, 1.0 * micrometres);
  BOOST_TEST(std::abs(c.moment_coefficient) < 1e-14); // round-off of the spin
  c.moment_coefficient = 0;
  const auto outcome = rigid::coulomb_impulse_ratio(body, before, c, 0.1); // anything above 0.043
  BOOST_TEST(outcome.rolls);
  c.impulse_ratio = outcome.impulse_ratio;
  const energy initial = rigid::kinetic_energy(body, before);
  const auto works = rigid::works_of_adhesion(body, before, c);
  // The other numbers of table 1 are in examples/fidelity.cpp.
  // W_A = 2.27e-12 J is the work by restitution with the energy of spin counted to m v^2/2. Half of the last digit.
  BOOST_TEST(std::abs(in_si(works.by_restitution) - 2.21e-12) < 0.5e-14);
  const double normal = 0.5 * in_si(body.mass) * 2.8 * 2.8;
  BOOST_TEST(std::abs(in_si(works.by_restitution) * in_si(initial) / normal - 2.27e-12) < 0.5e-14);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  const solid_sphere body{1e-12 * kilograms, 1.0 * micrometres};
  const velocities before{2.0 * metres_per_second, 1.0 * metres_per_second, 1e5 * per_second};
  const coefficients c{.restitution_without_adhesion = 0.5, .moment_arm = 0.1 * micrometres};
  const auto with = [&](auto member, auto value) {
    auto changed = c;
    changed.*member = value;
    return changed;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();

  BOOST_CHECK_NO_THROW(rigid::after_impact(body, before, c));
  BOOST_CHECK_EXCEPTION(rigid::after_impact({-1.0 * kilograms, body.radius}, before, c), bad_input,
                        says("mass", "-1 kg", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact({body.mass, 0.0 * metres}, before, c), bad_input,
                        says("radius", "= 0 m", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, {-2.0 * metres_per_second, {}, {}}, c), bad_input,
                        says("normal velocity", "-2 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, {before.normal, nan * metres_per_second, {}}, c), bad_input,
                        says("tangential velocity", "nan", "(-inf, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, {before.normal, {}, nan * per_second}, c), bad_input,
                        says("angular velocity", "nan", "(-inf, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::restitution_without_adhesion, 1.5)),
                        bad_input, says("restitution_without_adhesion", "1.5", "[0, 1]"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::adhesion_coefficient, -0.5)), bad_input,
                        says("adhesion_coefficient", "-0.5", "[0, 1]"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::impulse_ratio, nan)), bad_input,
                        says("impulse_ratio", "nan", "(-inf, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::moment_coefficient, nan)), bad_input,
                        says("moment_coefficient", "nan", "(-inf, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::moment_arm, -1.0 * metres)), bad_input,
                        says("moment_arm", "-1 m", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, with(&coefficients::impulse_ratio, 10.)), bad_input,
                        says("impulse_ratio", "= 10 ", "is outside [-"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, c, {3e-12 * newton_seconds, {}}), bad_input,
                        says("external impulse of approach", "3e-12", "(-inf, 2e-12]"));
  BOOST_CHECK_EXCEPTION(rigid::after_impact(body, before, c, {{}, -3e-12 * newton_seconds}), bad_input,
                        says("external impulse of rebound", "-3e-12", "[-1e-12, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::coulomb_impulse_ratio(body, before, c, -0.5), bad_input,
                        says("friction_coefficient", "-0.5", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::coulomb_impulse_ratio(body, before, with(&coefficients::moment_coefficient, 0.25), 0.5),
                        bad_input, says("moment_coefficient", "0.25", "[0, 0]"));
  BOOST_CHECK_EXCEPTION(rigid::impulse_ratio_bounds(body, before, with(&coefficients::moment_coefficient, 0.25)),
                        bad_input, says("moment_coefficient", "0.25", "(-inf, 0]"));
  BOOST_CHECK_EXCEPTION(rigid::impulse_ratio_bounds(body, {before.normal, before.tangential, -before.angular},
                                                    with(&coefficients::moment_coefficient, -0.25)),
                        bad_input, says("moment_coefficient", "-0.25", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::restitution_without_adhesion(0 * metres_per_second, before.normal), bad_input,
                        says("reference_speed", "= 0 m/s", "(0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::restitution_without_adhesion(before.normal, -before.normal), bad_input,
                        says("speed", "-2 m/s", "[0, inf)"));
  BOOST_CHECK_EXCEPTION(rigid::attachment(body, before, 1, 0.0 * metres), bad_input,
                        says("moment_arm", "= 0 m", "(0, inf)"));
  const auto inverse = [&](double R, double leaving, length arm) {
    return rigid::from_velocities(body, before, {-leaving * metres_per_second, {}, {}}, R, arm);
  };
  BOOST_CHECK_NO_THROW(inverse(0.5, 0.5, body.radius));
  BOOST_CHECK_EXCEPTION(inverse(0.5, -1, body.radius), bad_input,
                        says("normal velocity after", "= 1 m/s", "(-inf, 0]"));
  BOOST_CHECK_EXCEPTION(inverse(0.5, 1.5, body.radius), bad_input, says("adhesion_coefficient", "-0.5", "[0, 1]"));
  BOOST_CHECK_EXCEPTION(inverse(0, 0, body.radius), bad_input, says("restitution_without_adhesion", "= 0 ", "(0, 1]"));
  BOOST_CHECK_EXCEPTION(inverse(0.5, 0.5, 0.0 * metres), bad_input, says("moment_arm", "= 0 m", "(0, inf)"));
}
