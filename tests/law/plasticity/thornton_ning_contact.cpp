#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>
#include <ricochet/study/threshold/threshold.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>

using namespace support;

namespace {
using plain = reduced<double>;
const ice_case ice;

/// The contact of the law as Thornton and Ning wrote it, a force F(a) and an approach delta(a) on each leg, and what
/// quadratures of F d(delta) say of an impact. Nothing of the library but the numbers of the scene.
class by_quadrature {
public:
  by_quadrature(const contact_pair& pair, energy_per_area w, modulus strength)
      : E(in_si(pair.reduced_modulus)), R(in_si(pair.reduced_radius)), m(in_si(pair.reduced_mass)), w(in_si(w)),
        p_y(1.6 * in_si(strength)) {
    const auto excess = [&](double a) {
      return 2 * E * a / (pi * R) - (a > 0 ? std::sqrt(2 * this->w * E / (pi * a)) : 0) - p_y;
    };
    yielded = zero(excess, touch() / 2, touch() + 10 * p_y * R / E);
  }

  double touch() const { return std::cbrt(2 * pi * w * R * R / E); }
  double yield_radius() const { return yielded; }
  double load_free_force(double a) const {
    if (a < yielded)
      return 4 * E * a * a * a / (3 * R);
    return 4 * E * std::pow(yielded, 3) / (3 * R) + pi * p_y * (a * a - yielded * yielded) +
           4 * pi / 3 * std::sqrt(2 * w * E / pi) * (std::pow(a, 1.5) - std::pow(yielded, 1.5));
  }

  /// Energy of the approach that brings the contact from touch to this radius.
  double loading(double a) const {
    const auto work = [&](double x) { return force(load_free_force(x), x) * approach_slope(R, x); };
    return a <= yielded ? quadrature(work, touch(), a)
                        : quadrature(work, touch(), yielded) + quadrature(work, yielded, a);
  }

  double unloading_radius(double largest) const {
    return 4 * E * std::pow(largest, 3) / (3 * load_free_force(largest));
  }

  /// Energy given back from this largest radius until the bodies let go.
  double unloading(double largest) const {
    const double Rp = unloading_radius(largest), fold = std::cbrt(pi * w * Rp * Rp / (8 * E));
    return quadrature([&](double x) { return force(4 * E * x * x * x / (3 * Rp), x) * approach_slope(Rp, x); }, fold,
                      largest);
  }

  double largest_radius(double v) const {
    const double energy = m * v * v / 2, hertzian = std::pow(15 * energy * R * R / (8 * E), 0.2);
    return zero([&](double a) { return loading(a) - energy; }, touch(), 20 * (hertzian + touch() + yielded));
  }

  double residual_approach(double v) const {
    const double a = std::max(yielded, largest_radius(v));
    return a * a / R - a * a / unloading_radius(a);
  }

  /// e^2, negative where the bodies stick.
  double squared_restitution(double v) const { return unloading(largest_radius(v)) / (m * v * v / 2); }

private:
  double force(double load_free, double a) const { return load_free - std::sqrt(8 * pi * w * E * a * a * a); }
  double approach_slope(double radius, double a) const { return 2 * a / radius - std::sqrt(pi * w / (2 * a * E)); }

  template <class F>
  static double quadrature(const F& f, double from, double to) { // in sqrt(a), where the integrand is smooth
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate([&](double y) { return 2 * y * f(y * y); },
                                                                         std::sqrt(from), std::sqrt(to), 10, 1e-14);
  }
  template <class F>
  static double zero(const F& f, double low, double high) {
    std::uintmax_t iterations = 200;
    return boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(52), iterations)
        .first;
  }

  static constexpr double pi = std::numbers::pi;
  double E, R, m, w, p_y, yielded = 0;
};

/// Pairs with and without adhesion, and a strength above the least.
struct flowing_scene {
  basic_pair<plain> pair;
  jkr_law<plain> adhesion;
  thornton_ning_contact_law<plain> law;
  double flattening, yielded;
};
std::vector<flowing_scene> flowing_scenes() {
  std::vector<flowing_scene> all;
  for (const double w : {0., 1e-4, 0.1, 1.})
    for (const double times : {1.0, 1.01, 1.3, 4., 50.}) {
      flowing_scene s{{1.3, 0.7, 1.1}, {w}, {}, 0, 0};
      s.flattening = s.adhesion.flattening(s.pair);
      s.law.yield_strength = w > 0 ? times * s.law.least_strength(s.pair, s.flattening) : 1e-3 * times;
      s.yielded = s.law.yield_radius(s.pair, s.flattening);
      all.push_back(s);
    }
  return all;
}

/// The contact when its largest radius is this, loaded.
flattened_configuration<plain> loaded(const flowing_scene& s, double a) {
  flattened_configuration<plain> c{};
  c.take(s.pair, s.law.shape(s.pair, s.flattening, s.yielded, a));
  c.radius = a;
  c.approach = a * a / c.pair.reduced_radius - s.flattening * std::sqrt(a);
  return c;
}

} // namespace

BOOST_AUTO_TEST_CASE(it_yields_where_the_pressure_at_the_centre_says) {
  for (const auto& s : flowing_scenes()) {
    const double E = s.pair.reduced_modulus, R = s.pair.reduced_radius, a = s.yielded, w = s.adhesion.work_of_adhesion;
    const double pressure = 2 * E * a / (M_PI * R) - std::sqrt(2 * w * E / (M_PI * a));
    BOOST_TEST(pressure / (1.6 * s.law.yield_strength) == 1, boost::test_tools::tolerance(1e-13));
    if (w > 0) // the least strength is that of yield at 1.16 times the radius at touch
      BOOST_TEST(a >= std::cbrt(1.25 * 1.25) * s.adhesion.touch_radius(s.pair) * (1 - 1e-14));
  }
}

BOOST_AUTO_TEST_CASE(axioms_of_the_shape) {
  for (const auto& s : flowing_scenes()) {
    const auto at_yield = s.law.shape(s.pair, s.flattening, s.yielded, s.yielded);
    BOOST_TEST(at_yield.radius / s.pair.reduced_radius == 1, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(at_yield.residual_approach == 0);
    BOOST_TEST(std::abs(at_yield.radius_slope) * s.yielded < 1e-13 * s.pair.reduced_radius); // smooth onset
    BOOST_TEST(std::abs(at_yield.approach_slope) < 1e-13 * s.yielded / s.pair.reduced_radius);
    double lost_before = 0;
    for (double times = 1.001; times < 30; times *= 1.1) {
      const double a = times * s.yielded, h = 1e-5 * a;
      const auto now = s.law.shape(s.pair, s.flattening, s.yielded, a);
      const auto up = s.law.shape(s.pair, s.flattening, s.yielded, a + h),
                 down = s.law.shape(s.pair, s.flattening, s.yielded, a - h);
      BOOST_TEST((now.radius_slope > 0 && now.approach_slope > 0));
      // 1e-9: the differences err by h^2, and by round-off over h
      BOOST_TEST(std::abs((up.radius - down.radius) / (2 * h) - now.radius_slope) < 1e-9 * now.radius / s.yielded);
      BOOST_TEST(std::abs((up.residual_approach - down.residual_approach) / (2 * h) - now.approach_slope) <
                 1e-9 * a / s.pair.reduced_radius);
      // Energy lost is what the load's work does not leave in the contact.
      const auto c = loaded(s, a), above = loaded(s, a + h), below = loaded(s, a - h);
      const auto energy = [&](const auto& at) {
        return hertz_law<plain>::stored_energy(at.pair, at) + s.adhesion.surface_energy(at.radius);
      };
      const auto whole = [](const auto& at) { return at.approach + at.shape.residual_approach; };
      const double work = hertz_law<plain>::force(c.pair, c) * (whole(above) - whole(below));
      const double lost = s.law.lost_force(c);
      const double size = std::abs(energy(c)) / a + std::abs(hertz_law<plain>::force(c.pair, c)) * a;
      BOOST_TEST(std::abs((work - energy(above) + energy(below)) / (2 * h) - lost) < 1e-8 * size);
      BOOST_TEST(lost > lost_before);
      lost_before = lost;
    }
  }
}

BOOST_AUTO_TEST_CASE(below_the_least_strength_energy_would_be_created) {
  for (auto s : flowing_scenes()) {
    if (s.flattening == 0)
      continue;
    const auto lost_after_onset = [&](double times) {
      s.law.yield_strength = times * s.law.least_strength(s.pair, s.flattening);
      s.yielded = s.law.yield_radius(s.pair, s.flattening);
      const double a = s.yielded * 1.001;
      return s.law.lost_force(loaded(s, a));
    };
    BOOST_TEST(lost_after_onset(0.98) < 0);
    BOOST_TEST(lost_after_onset(1.02) > 0);
  }
}

BOOST_AUTO_TEST_CASE(published_stiffness_while_it_flows) { // Thornton & Ning 1998: dF/d(delta) on loading
  for (const auto& s : flowing_scenes())
    for (const double times : {1.05, 1.5, 5.}) {
      const double a = times * s.yielded, h = 1e-5 * a, E = s.pair.reduced_modulus, R = s.pair.reduced_radius,
                   w = s.adhesion.work_of_adhesion;
      const auto up = loaded(s, a + h), down = loaded(s, a - h);
      const double root_ratio = std::sqrt(1.5 * M_PI * w * R / (4 * E * a * a * a / (3 * R))); // sqrt(P_c/P_1)
      const double published = (3 * M_PI * R * 1.6 * s.law.yield_strength - 2 * E * a * root_ratio) / (3 - root_ratio);
      const double found = (hertz_law<plain>::force(up.pair, up) - hertz_law<plain>::force(down.pair, down)) /
                           (up.approach + up.shape.residual_approach - down.approach - down.shape.residual_approach);
      BOOST_TEST(found / published == 1, boost::test_tools::tolerance(1e-8)); // of the difference
    }
}

BOOST_AUTO_TEST_CASE(without_adhesion_its_restitution_is_the_published_factor) { // [K (29)]
  for (const double megapascal : {1., 50., 200.}) {
    const thornton_ning_contact law{megapascal * megapascals};
    const speed yield = closed_form::yield_speed(ice.pair, law.yield_strength);
    for (const double times : {0.01, 0.5, 0.9999, 1.0001, 1.001, 1.1, 2., 10., 100., 1000.})
      for (const double tolerance : {1e-6, 1e-11}) {
        const auto out =
            collide(compose(ice.pair, hertz{}, law, energy_ledger{}), impact{times * yield}, {.tolerance = tolerance});
        const double expected = closed_form::plastic_restitution(yield, times * yield);
        BOOST_TEST_CONTEXT("v/v_y = " << times << ", tolerance " << tolerance) {
          BOOST_TEST(std::abs(out.restitution.value() - expected) <= out.error_estimate);
          BOOST_TEST(out.error_estimate <= tolerance);
          BOOST_TEST(std::abs(out.plastic_loss - closed_form::plastic_loss(yield, times * yield)) <= 10 * tolerance);
          BOOST_TEST(std::abs(out.ledger_residual) <= tolerance);
          BOOST_TEST((out.residual_approach > length{}) == (times > 1));
          BOOST_TEST((times > 1 || out.plastic_loss == 0));
        }
      }
  }
}

BOOST_AUTO_TEST_CASE(with_adhesion_its_restitution_is_that_of_quadratures) {
  bool captured = false, flattened = false, round = false;
  for (const double w : {0.05, 0.37, 0.74})
    for (const double megapascal : {120., 200., 600.})
      for (const double v : {0.7, 1.5, 3., 8., 30., 200.}) {
        const energy_per_area work = w * joules_per_square_metre;
        const by_quadrature expected(ice.pair, work, megapascal * megapascals);
        const auto out = collide(compose(ice.pair, hertz{}, jkr{work}, thornton_ning_contact{megapascal * megapascals}),
                                 impact{v * metres_per_second}, {.tolerance = 1e-11});
        const double squared = expected.squared_restitution(v), residual = expected.residual_approach(v);
        BOOST_TEST_CONTEXT("w = " << w << ", Y = " << megapascal << " MPa, v = " << v) {
          BOOST_TEST((out.ending == ending::separated) == (squared > 0));
          if (squared > 0)
            BOOST_TEST(std::abs(out.restitution.value() - std::sqrt(squared)) < 1e-10); // the quadratures' zeros
          BOOST_TEST(std::abs(in_si(out.residual_approach) - residual) < 1e-9 * residual + 1e-22);
        }
        captured |= squared < 0;
        (residual > 0 ? flattened : round) |= squared > 0;
      }
  BOOST_TEST((captured && flattened && round));
}

BOOST_AUTO_TEST_CASE(plastic_flow_raises_the_sticking_speed) {
  const modulus strength = 140. * megapascals;
  const speed elastic = closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion);
  const auto found = sticking_speed(compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{strength}),
                                    0.5 * elastic, 7. * elastic, 1e-8);
  const by_quadrature expected(ice.pair, ice.adhesive.work_of_adhesion, strength);
  BOOST_TEST(expected.squared_restitution(in_si(found.value()) * (1 - 1e-7)) < 0);
  BOOST_TEST(expected.squared_restitution(in_si(found.value()) * (1 + 1e-7)) > 0);
  BOOST_TEST((found.value() > 1.3 * elastic));
}

BOOST_AUTO_TEST_CASE(a_damped_contact_ends_where_its_force_vanishes) {
  const auto out = collide(compose(ice.pair, hertz{}, thornton_ning_contact{10. * megapascals},
                                   kuwabara_kono{2e-10 * seconds}, energy_ledger{}, trajectory{}),
                           impact{1.0 * metres_per_second}, {.tolerance = 1e-10});
  const auto& t = out.trajectory;
  const std::size_t last = t.time.size() - 2; // the row after it is of the bodies apart
  BOOST_TEST(t.elastic_force[last] > 0);
  BOOST_TEST(std::abs(t.elastic_force[last] + t.damping_force[last]) < 1e-9 * t.elastic_force[last]);
  BOOST_TEST(t.mutual_approach[last] > in_si(out.residual_approach));
  // The force is that of the flattened contact, 4E*a^3/3R_p, and the approach what exceeds the residual one.
  const double a = t.contact_radius[last], R = a * a / (t.mutual_approach[last] - in_si(out.residual_approach));
  BOOST_TEST(t.elastic_force[last] / (4 * in_si(ice.pair.reduced_modulus) * a * a * a / (3 * R)) == 1,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(R > 1.5 * in_si(ice.pair.reduced_radius));
}

BOOST_AUTO_TEST_CASE(limits_of_strength_and_adhesion) {
  const impact at{4.0 * metres_per_second};
  const auto strong = collide(compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{10. * gigapascals}), at);
  BOOST_TEST(std::abs(*strong.restitution -
                      *closed_form::restitution(ice.pair, ice.adhesive.work_of_adhesion, at.speed)) < 1e-8);
  BOOST_TEST((strong.plastic_loss == 0 && in_si(strong.residual_approach) == 0));
  const thornton_ning_contact soft{100. * megapascals};
  const double plastic =
      closed_form::plastic_restitution(closed_form::yield_speed(ice.pair, soft.yield_strength), at.speed);
  double last = 1;
  for (const double w : {1e-1, 1e-2, 1e-3, 1e-4, 0.}) {
    const auto weak = collide(compose(ice.pair, hertz{}, jkr{w * joules_per_square_metre}, soft), at);
    const double distance = std::abs(*weak.restitution - plastic);
    BOOST_TEST(distance < 0.5 * last);
    last = distance;
  }
  BOOST_TEST(last < 1e-8);
}

BOOST_AUTO_TEST_CASE(the_ledger_closes_with_damping_too) {
  const thornton_ning_contact law{150. * megapascals};
  const auto closes = [&](const auto&... laws) {
    for (const double v : {1., 2., 4., 9., 40.}) {
      const auto out = collide(compose(ice.pair, hertz{}, law, laws..., energy_ledger{}), impact{v * metres_per_second},
                               {.tolerance = 1e-10});
      BOOST_TEST_CONTEXT("v = " << v) {
        BOOST_TEST((out.ending == ending::separated || out.ending == ending::captured));
        BOOST_TEST(std::abs(out.ledger_residual) < 1e-10);
        BOOST_TEST(std::abs(out.crack_loss + out.bulk_loss + out.plastic_loss + out.remaining_energy - 1) < 1e-8);
        BOOST_TEST(((out.plastic_loss > 0 || v < 1.5) && out.crack_loss >= 0 && out.bulk_loss >= 0));
        if (out.restitution)
          BOOST_TEST(std::abs(out.remaining_energy - square(*out.restitution)) < 1e-12);
      }
    }
  };
  const kuwabara_kono viscous{2e-11 * seconds};
  closes(ice.adhesive, viscous);
  closes(ice.adhesive, tsuji{0.3});
  closes(viscous, jkr{});
  const thornton_ning_contact soft{10. * megapascals};
  for (const auto& out :
       {collide(compose(ice.pair, hertz{}, soft, viscous, energy_ledger{}), impact{1.0 * metres_per_second}),
        collide(compose(ice.pair, hertz{}, soft, hunt_crossley{1.0 * seconds_per_metre}, energy_ledger{}),
                impact{1.0 * metres_per_second}),
        collide(compose(ice.pair, hertz{}, soft, tsuji{0.4}, energy_ledger{}), impact{1.0 * metres_per_second})}) {
    BOOST_TEST(std::abs(out.ledger_residual) < 1e-9);
    BOOST_TEST((out.plastic_loss > 0.1 && out.bulk_loss > 1e-4));
  }
  const auto pulled = collide(compose(ice.pair, hertz{}, soft, viscous, end_at_zero_overlap{}, energy_ledger{}),
                              impact{1.0 * metres_per_second});
  BOOST_TEST(std::abs(pulled.ledger_residual) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_captured_contact_keeps_its_shape) {
  // Strongly damped, it rings in the shape of its first turning point: the certificate is that of the flattened bodies.
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{150. * megapascals},
                             kuwabara_kono{4e-10 * seconds}, energy_ledger{}, extremes{});
  const auto out = collide(model, impact{3.0 * metres_per_second});
  BOOST_TEST((out.ending == ending::captured && out.ending_is_certain));
  BOOST_TEST(in_si(out.residual_approach) > 0);
  const double a = in_si(out.max_contact_radius), R = in_si(ice.pair.reduced_radius);
  const by_quadrature contact(ice.pair, ice.adhesive.work_of_adhesion, 150. * megapascals);
  BOOST_TEST(in_si(out.residual_approach) / (a * a / R - a * a / contact.unloading_radius(a)) == 1,
             boost::test_tools::tolerance(1e-7)); // of a at its maximum, to the default tolerance
}

BOOST_AUTO_TEST_CASE(flow_goes_on_beyond_the_largest_radius_only) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{150. * megapascals});
  const speed v = 3.0 * metres_per_second;
  using numbers_type = reduced_model<double, std::remove_const_t<decltype(model)>>;
  const numbers_type numbers(model, scales_at(model, v));
  auto x = numbers.touch(1);
  BOOST_TEST(x[root_contact_radius] < x[largest_coordinate]);
  const double yielded = x[largest_coordinate];
  x[root_contact_radius] = 1.2 * yielded;
  x[largest_coordinate] = 1.3 * yielded;
  const event_values<numbers_type> values(numbers);
  BOOST_TEST(values.value(event::yielding, x, 0, true) > 0);
  typename numbers_type::state_type elastic{}, flowing{};
  BOOST_TEST_REQUIRE(numbers.derivative(x, elastic, 0));
  BOOST_TEST((elastic[largest_coordinate] == 0 && elastic[plastic_loss] == 0));
  x[root_contact_radius] = 1.31 * yielded;
  BOOST_TEST(values.value(event::yielding, x, 0, true) < 0);
  BOOST_TEST(values.value(event::yielding, x, 1, true) > 0); // it flows already
  x[largest_coordinate] = x[root_contact_radius];
  BOOST_TEST_REQUIRE(numbers.derivative(x, flowing, 1));
  BOOST_TEST(flowing[largest_coordinate] == flowing[root_contact_radius]);
  BOOST_TEST(flowing[plastic_loss] > 0);
  flow<numbers_type> run{numbers};
  x[root_contact_radius] = 1.32 * yielded;
  run.set_plastic(true, x);
  BOOST_TEST((run.piece == 1 && x[largest_coordinate] == x[root_contact_radius]));
  run.set_plastic(false, x);
  BOOST_TEST(run.piece == 0);
  // Flattened bodies let go with more energy.
  BOOST_TEST(numbers.exit_energy(numbers.at(x, 0).c) > numbers.exit_energy());
}

BOOST_AUTO_TEST_CASE(the_motion_as_columns) {
  const auto out = collide(compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{150. * megapascals},
                                   energy_ledger{}, trajectory{}, extremes{}, contact_duration{}),
                           impact{6.0 * metres_per_second});
  const auto& t = out.trajectory;
  BOOST_TEST_REQUIRE(t.plastic_loss.size() == t.time.size());
  const double kinetic =
      t.kinetic_energy.front() + t.elastic_energy.front() + t.surface_energy.front() + t.crack_loss.front();
  for (std::size_t i = 0; i < t.time.size(); ++i) {
    const double sum = t.kinetic_energy[i] + t.elastic_energy[i] + t.surface_energy[i] + t.crack_loss[i] +
                       t.bulk_loss[i] + t.plastic_loss[i];
    BOOST_TEST_REQUIRE(std::abs(sum / kinetic - 1) < 1e-6); // rows within steps, at the default tolerance
    BOOST_TEST_REQUIRE((i == 0 || t.plastic_loss[i] >= t.plastic_loss[i - 1] - 1e-15 * kinetic));
  }
  BOOST_TEST(std::abs(t.plastic_loss.back() / kinetic - out.plastic_loss) < 1e-12);
  const double largest = *std::max_element(t.mutual_approach.begin(), t.mutual_approach.end());
  BOOST_TEST(largest <= in_si(out.max_approach) * (1 + 1e-12));
  BOOST_TEST(largest > in_si(out.max_approach) * 0.9999); // a row at the turning point
  BOOST_TEST(t.mutual_approach.back() < in_si(out.residual_approach));
}

BOOST_AUTO_TEST_CASE(every_stepper_finds_the_same) {
  const auto model =
      compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{150. * megapascals}, ice.viscous, energy_ledger{});
  const impact at{6.0 * metres_per_second};
  const auto expected = integrate(model, at, {.tolerance = 1e-11});
  const auto compare = [&](auto stepper) {
    const auto out = integrate(model, at, {.tolerance = 1e-7}, stepper);
    BOOST_TEST(std::abs(*out.restitution - *expected.restitution) <= 1e-7);
    BOOST_TEST(std::abs(out.plastic_loss - expected.plastic_loss) <= 1e-6);
  };
  compare(stepper::dopri5{});
  compare(stepper::radau<5>{});
  compare(stepper::bulirsch_stoer{});
}

BOOST_AUTO_TEST_CASE(wrong_strength_is_refused) {
  BOOST_CHECK_THROW(compose(ice.pair, hertz{}, thornton_ning_contact{}), bad_input);
  const auto says = [](const bad_input& refused) {
    return std::string(refused.what()).starts_with("yield_strength = 100000000 Pa is below 1112") &&
           std::string(refused.what()).find("adhesion draws it together") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{100. * megapascals}), bad_input,
                        says);
  compose(ice.pair, hertz{}, thornton_ning_contact{100. * megapascals});
}
