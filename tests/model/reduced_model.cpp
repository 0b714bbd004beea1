#include <boost/test/unit_test.hpp>

#include "support/random_scenes.hpp"

#include <ricochet/number/autodiff.hpp>

using namespace support;
using D = dual<>;

namespace {

double slope(const D& x) { return static_cast<double>(x.derivative(1)); }

/// Calls use(model, unit, state, piece) over random scenes of every family, at states as a collision meets them.
template <class Use>
void everywhere(const Use& use) {
  scenes random(11);
  for (int i = 0; i < 20; ++i) {
    const scene s = random.next();
    const auto visit = [&](const auto& model) {
      const scales unit = scales_at(model, s.speed);
      using reduced_t = reduced_model<double, std::remove_cvref_t<decltype(model)>>;
      const reduced_t numbers(model, unit);
      for (const double size : {0.3, 0.9, 2.}) {
        auto x = numbers.touch(random.log_uniform(0.1, 1) * (i % 2 ? 1 : -1));
        x[numbers.coordinate] = size * numbers.typical()[numbers.coordinate];
        if constexpr (reduced_t::adhesive)
          x[numbers.coordinate] = (1 + size) * numbers.fold_coordinate(); // on the stable branch
        int piece = 0;
        if constexpr (reduced_t::free_edge) {
          const double root = i % 2 ? 0.6 : 1.3, y = x[numbers.coordinate]; // sqrt(beta), of the two inner pieces
          x[mutual_approach] = numbers.elastic.load_free_approach(numbers.pair, y * y) -
                               root * numbers.adhesion.flattening(numbers.pair) * y;
          piece = decltype(numbers.crack)::joints.size() == 1 ? !(i % 2) : 1 + !(i % 2);
        }
        use(model, unit, numbers, x, piece);
      }
    };
    visit(viscous_hertz(s, energy_ledger{}, contact_duration{}));
    visit(hunt_crossley_hertz(s, energy_ledger{}));
    visit(tsuji_hertz(s, energy_ledger{}));
    visit(static_jkr(s, energy_ledger{}));
    visit(viscous_jkr(s, energy_ledger{}, contact_duration{}));
    visit(viscoelastic_jkr_fit(s, energy_ledger{}, contact_duration{}));
    auto exact = s;
    exact.modulus_ratio = std::min(s.modulus_ratio, 0.3); // sqrt(beta) = 0.6 lies in its range
    visit(viscoelastic_jkr(exact, energy_ledger{}));
  }
}

/// The state moved along its own motion by an infinitesimal slowed time.
template <class Model, class State>
auto moved(const State& x, const State& dx) {
  typename reduced_model<D, Model>::state_type result{};
  for (std::size_t i = 0; i < x.size(); ++i)
    result[i] = D(x[i]) + D(dx[i]) * (seeded(0.0));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(coordinate_and_clock_belong_together) {
  everywhere([](const auto& model, const scales& unit, const auto& numbers, const auto& x, int piece) {
    using Model = std::remove_cvref_t<decltype(model)>;
    auto dx = x;
    BOOST_TEST_REQUIRE(numbers.derivative(x, dx, piece));
    const reduced_model<D, Model> duals(model, unit);
    const auto now = numbers.at(x, piece);
    // d(delta)/d(sigma) = rate dt/d(sigma), by the motion of the unknowns; 1e-13: terms of a^2/R that cancel at touch
    const double along = slope(duals.at(moved<Model>(x, dx), piece).c.approach);
    const double size = std::abs(now.c.rate) * (std::abs(now.clock) + now.c.radius);
    BOOST_TEST_REQUIRE(std::abs(along - now.c.rate * now.clock) < 1e-13 * size);
    if constexpr (Model::asked.duration)
      BOOST_TEST_REQUIRE(dx[elapsed_time] == now.clock);
    BOOST_TEST_REQUIRE(now.clock > 0);
    BOOST_TEST_REQUIRE(
        std::abs(dx[approach_rate] + numbers.total_force(now.c) * now.clock / numbers.pair.reduced_mass) <=
        1e-15 * std::abs(dx[approach_rate])); // the same products
  });
}

BOOST_AUTO_TEST_CASE(energy_is_balanced_at_every_instant) {
  everywhere([](const auto& model, const scales& unit, const auto& numbers, const auto& x, int piece) {
    using Model = std::remove_cvref_t<decltype(model)>;
    auto dx = x;
    numbers.derivative(x, dx, piece);
    const reduced_model<D, Model> duals(model, unit);
    const auto c = duals.at(moved<Model>(x, dx), piece).c;
    const double kinetic = slope(duals.kinetic_energy(c.rate)), potential = slope(duals.potential(c));
    double lost = 0, largest = std::abs(kinetic) + std::abs(slope(duals.surface_energy(c)));
    if constexpr (Model::damped) {
      BOOST_TEST_REQUIRE(dx[bulk_loss] >= 0);
      lost += dx[bulk_loss];
    }
    if constexpr (Model::has_crack_law) {
      BOOST_TEST_REQUIRE(dx[crack_loss] >= 0);
      lost += dx[crack_loss];
    }
    // 1e-12: a dozen roundings of energies whose parts cancel by two digits in the elastic law
    BOOST_TEST_REQUIRE(std::abs(kinetic + potential + lost) < 1e-12 * largest);
    // the size of what balances is not that of a rounding
    BOOST_TEST_REQUIRE(std::abs(kinetic) > 1e-9 * largest);
  });
}

BOOST_AUTO_TEST_CASE(force_is_the_slope_of_the_potential) {
  everywhere([](const auto& model, const scales& unit, const auto& numbers, const auto& x, int piece) {
    using Model = std::remove_cvref_t<decltype(model)>;
    const reduced_model<D, Model> duals(model, unit);
    typename reduced_model<D, Model>::state_type seeded_x{};
    for (std::size_t i = 0; i < x.size(); ++i)
      seeded_x[i] = x[i];
    const auto now = numbers.at(x, piece);
    const double force = numbers.elastic.force(numbers.pair, now.c), E = numbers.pair.reduced_modulus;
    double found;
    if constexpr (Model::has_crack_law) { // radius and approach are free: at constant radius
      seeded_x[mutual_approach] = seeded(x[mutual_approach]);
      found = slope(duals.potential(duals.at(seeded_x, piece).c));
    } else { // along the static edge, where dU/da = 0
      seeded_x[numbers.coordinate] = seeded(x[numbers.coordinate]);
      const auto c = duals.at(seeded_x, piece).c;
      found = slope(duals.potential(c)) / slope(c.approach);
    }
    const double a = now.c.radius, size = E * a * (std::abs(now.c.approach) + a * a / numbers.pair.reduced_radius);
    BOOST_TEST_REQUIRE(std::abs(found - force) < 1e-12 * size); // division by the slope, which is small near the fold
  });
}

BOOST_AUTO_TEST_CASE(the_same_in_double_and_long_double) {
  everywhere([](const auto& model, const scales&, const auto& numbers, const auto& x, int piece) {
    using Model = std::remove_cvref_t<decltype(model)>;
    const reduced_model<long double, Model> fine(numbers);
    typename reduced_model<long double, Model>::state_type y{}, dy{};
    std::copy(x.begin(), x.end(), y.begin());
    auto dx = x;
    BOOST_TEST_REQUIRE(numbers.derivative(x, dx, piece));
    BOOST_TEST_REQUIRE(fine.derivative(y, dy, piece));
    for (std::size_t i = 0; i < x.size(); ++i) // 1e-12: force and beta - 1 each lose up to three digits in double
      BOOST_TEST_REQUIRE(std::abs(static_cast<double>(dx[i] - dy[i])) <= 1e-12 * std::abs(dx[i]));
  });
}
