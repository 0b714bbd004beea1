#include <boost/test/unit_test.hpp>

#include <ricochet/study/population.hpp> // first: Boost.Math takes `support` for a namespace, once there is one

#include "support/reference_rows.hpp"

#include <atomic>
#include <fstream>

using namespace support;

namespace {
const ice_case ice;

/// Grains of one size with JKR's adhesion alone, at speeds evenly spread up to twice the sticking speed: half of them
/// stick, and e = sqrt(1 - (v_s/v)^2).
const auto jkr_model = compose(ice.pair, hertz{}, ice.adhesive);
const double v_s = in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion));
const auto even_speeds = [](std::mt19937_64& random) {
  std::uniform_real_distribution<double> speed(1e-9, 2 * v_s);
  return ricochet::scene{jkr_model, impact{speed(random) * metres_per_second}};
};
double e_of_share(double p) { return p < 0.5 ? 0 : std::sqrt(1 - square(0.5 / p)); }
} // namespace

BOOST_AUTO_TEST_CASE(a_population_that_is_known) {
  const auto sample = sample_population(even_speeds, 20'000);
  BOOST_TEST(sample.counts().separated + sample.counts().captured == 20'000);
  BOOST_TEST((sample.counts().unresolved == 0 && sample.counts().failed == 0));
  const auto stuck = sample.captured_fraction(0.9999);
  BOOST_TEST((stuck.low < 0.5 && 0.5 < stuck.high && stuck.high - stuck.low < 0.03));
  BOOST_TEST(sample.share_up_to(0) == stuck.value);
  BOOST_TEST(sample.share_up_to(1) == 1);
  for (const double p : {0.2, 0.55, 0.75, 0.95}) {
    const auto q = sample.quantile(p, 0.9999);
    BOOST_TEST((q.low <= e_of_share(p) && e_of_share(p) <= q.high), p);
    BOOST_TEST((q.low <= q.value && q.value <= q.high && q.high - q.low < 0.2), p);
    BOOST_TEST(std::abs(sample.share_up_to(q.value) - std::max(p, stuck.value)) < 1e-4 + 1e-9);
  }
  const double mean = (std::sqrt(3.) - pi<double>() / 3) / 2; // of sqrt(1 - 1/(4p^2)) over 1/2 < p < 1
  const double square_mean = 0.25;
  const auto all = sample.mean(), energy = sample.mean_square();
  BOOST_TEST(std::abs(all.value - mean) < 4 * (all.high - all.value));
  BOOST_TEST(std::abs(energy.value - square_mean) < 4 * (energy.high - energy.value));
  BOOST_TEST(all.high - all.low < 0.01);

  const auto bars = sample.histogram(10);
  double rebounding = 0;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    rebounding += bars[i];
    const double high = double(i + 1) / 10, low = double(i) / 10;
    const auto share_below = [](double e) { return std::min(1., 0.5 / std::sqrt(1 - e * e)); }; // of e_of_share()
    const double expected = share_below(high) - share_below(low);
    BOOST_TEST(std::abs(bars[i] - expected) < 4 * std::sqrt(expected / 20'000) + 1e-9, i << ": " << bars[i]);
  }
  BOOST_TEST(std::abs(rebounding - (1 - stuck.value)) < 1e-12);
  BOOST_CHECK_THROW(sample.histogram(0), bad_input);
}

BOOST_AUTO_TEST_CASE(intervals_hold_the_truth_as_often_as_they_say) {
  const double confidence = 0.9;
  const int repetitions = 300;
  int stuck = 0, quantile = 0;
  for (int i = 0; i < repetitions; ++i) {
    const auto sample = sample_population(even_speeds, 200, {.seed = std::uint64_t(1000 + i)});
    const auto f = sample.captured_fraction(confidence), q = sample.quantile(0.8, confidence);
    stuck += f.low <= 0.5 && 0.5 <= f.high;
    quantile += q.low <= e_of_share(0.8) && e_of_share(0.8) <= q.high;
  }
  BOOST_TEST_MESSAGE("inside: " << stuck << " and " << quantile << " of " << repetitions);
  const double four_sigma = 4 * std::sqrt(0.9 * 0.1 * repetitions);
  for (const int inside : {stuck, quantile}) // never less often; more often by no more than whole numbers ask for
    BOOST_TEST((inside > 0.9 * repetitions - four_sigma && inside < 0.94 * repetitions + four_sigma), inside);
}

BOOST_AUTO_TEST_CASE(the_interval_of_a_quantile_is_as_narrow_as_it_may_be) {
  // Of 1, 2, ... n over n + 1: by the binomial distribution, added up.
  for (const int n : {1, 5, 30, 101})
    for (const double p : {0.05, 0.5, 0.9})
      for (const double confidence : {0.5, 0.95}) {
        std::vector<double> e;
        for (int i = 1; i <= n; ++i)
          e.push_back(double(i) / (n + 1));
        const auto q = population_sample(e, {}).quantile(p, confidence);
        double below = 0, term = std::pow(1 - p, n), low = 0, high = 1;
        for (int k = 0; k <= n; ++k) { // below: chance that k or fewer are below the true quantile
          below += term;
          term *= double(n - k) / (k + 1) * p / (1 - p);
          if (below <= (1 - confidence) / 2)
            low = double(k + 1) / (n + 1);
          if (1 - below <= (1 - confidence) / 2 && high == 1 && k < n)
            high = double(k + 1) / (n + 1);
        }
        BOOST_TEST(q.low == low, n << ", " << p << ", " << confidence << ": " << q.low << " instead of " << low);
        BOOST_TEST(q.high == high, n << ", " << p << ", " << confidence << ": " << q.high << " instead of " << high);
      }
}

BOOST_AUTO_TEST_CASE(members_are_the_same_whatever_the_company_and_the_threads) {
  std::size_t told = 0;
  const auto one = sample_population(even_speeds, 1000, {.threads = 1});
  const auto two = sample_population(even_speeds, 1000, {.threads = 2, .progress = [&](std::size_t done, std::size_t of) {
                                                           told = done;
                                                           BOOST_TEST(of == 1000);
                                                         }});
  BOOST_TEST(told == 1000);
  BOOST_TEST(one.restitutions() == two.restitutions(), boost::test_tools::per_element());
  const auto longer = sample_population(even_speeds, 1300);
  BOOST_TEST(std::includes(longer.restitutions().begin(), longer.restitutions().end(), one.restitutions().begin(),
                           one.restitutions().end()));
  for (const std::size_t count : {255u, 256u, 65'536u, 65'537u}) { // where streams and batches begin and end
    const auto some = sample_population(even_speeds, count).restitutions(),
               more = sample_population(even_speeds, count + 1).restitutions();
    std::vector<double> added;
    std::set_difference(more.begin(), more.end(), some.begin(), some.end(), std::back_inserter(added));
    BOOST_TEST((added.size() == 1 && std::includes(more.begin(), more.end(), some.begin(), some.end())), count);
  }
  const auto other = sample_population(even_speeds, 1000, {.seed = 2});
  BOOST_TEST(other.restitutions() != one.restitutions());
}

BOOST_AUTO_TEST_CASE(progress_is_told_within_a_batch_and_across) {
  std::vector<std::size_t> told;
  sample_population(even_speeds, 70'000, {.threads = 1, .progress = [&](std::size_t done, std::size_t of) {
                                            told.push_back(done);
                                            BOOST_TEST(of == 70'000);
                                          }});
  BOOST_TEST(told.size() > 10);
  BOOST_TEST(told.back() == 70'000);
  BOOST_TEST(std::is_sorted(told.begin(), told.end()));
}

BOOST_AUTO_TEST_CASE(a_member_that_is_refused_is_named) {
  for (const long wrong : {3, 65'543}) { // in the first batch and in the second
    std::atomic<long> drawn = 0;
    const auto draw = [&](std::mt19937_64&) {
      return ricochet::scene{jkr_model, impact{(drawn++ == wrong ? -1. : 1.) * metres_per_second}};
    };
    BOOST_CHECK_EXCEPTION(sample_population(draw, 70'000, {.threads = 1}), bad_input, [&](const bad_input& e) {
      return std::string(e.what()).starts_with("member " + std::to_string(wrong) + ": speed = -1 m/s");
    });
  }
}

BOOST_AUTO_TEST_CASE(quantiles_are_the_ranks_they_should_be) {
  std::vector<double> e;
  for (int i = 1; i <= 100; ++i)
    e.push_back(i / 1000.);
  const population_sample sample(e, {});
  for (int i = 1; i < 100; ++i) // i/100 of 100 is a whole number, though not always in floating point
    BOOST_TEST(sample.quantile(i / 100.).value == i / 1000., i);
  const population_sample thirty({e.begin(), e.begin() + 30}, {});
  const auto middle = thirty.quantile(0.5, 0); // of 30 halves, 14 or fewer, and 16 or more, are less likely than not
  BOOST_TEST(middle.low == 0.015);
  BOOST_TEST(middle.high == 0.016);
}

BOOST_AUTO_TEST_CASE(the_mean_of_those_that_rebound) {
  const population_sample sample({0.5, 0, 0.7, 0}, {.separated = 2, .captured = 2, .uncertain = 1});
  const auto moving = sample.mean_of_rebounding();
  BOOST_TEST(std::abs(moving.value - 0.6) < 1e-15);
  BOOST_TEST(std::abs(moving.high - moving.value - 0.1) < 1e-15); // two that differ by 0.2
  BOOST_TEST(std::abs(sample.mean().value - 0.3) < 1e-15);
  BOOST_CHECK_THROW(population_sample({0, 0}, {.captured = 2}).mean_of_rebounding(), bad_input);
}

// Damped and adhesive, no closed form: where e grows with the size, its quantiles are e of the sizes' quantiles.
BOOST_AUTO_TEST_CASE(sizes_that_are_distributed) {
  const auto of_radius = [](double radius) {
    const auto pair = between(sphere{materials::water_ice, radius * micrometres}, flat_wall{materials::water_ice});
    return ricochet::scene{compose(pair, hertz{}, ice.adhesive, kuwabara_kono{.bulk_time = 1e-11 * seconds}),
                           impact{8.0 * metres_per_second}};
  };
  const auto draw = [&](std::mt19937_64& random) {
    return of_radius(std::uniform_real_distribution<double>(0.5, 2)(random));
  };
  const auto e_of = [&](double radius) {
    const auto [model, impact] = of_radius(radius);
    return collide(model, impact).restitution.value_or(0);
  };
  for (double radius = 0.5; radius < 2; radius += 0.125)
    BOOST_REQUIRE(e_of(radius) < e_of(radius + 0.125));
  const auto sample = sample_population(draw, 4000);
  for (const double p : {0.1, 0.5, 0.9}) {
    const auto q = sample.quantile(p, 0.9999);
    const double e = e_of(0.5 + 1.5 * p);
    BOOST_TEST((q.low <= e && e <= q.high), p << ": " << q.low << " <= " << e << " <= " << q.high);
    BOOST_TEST(q.high - q.low < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_resolved_is_counted_apart) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(1e-11 * seconds));
  const auto draw = [&](std::mt19937_64&) { return ricochet::scene{model, impact{8.0 * metres_per_second}}; };
  const auto sample = sample_population(draw, 10, {.max_evaluations = 100});
  BOOST_TEST((sample.counts().unresolved == 10 && sample.counts().failed == 0));
  BOOST_CHECK_EXCEPTION(sample.mean(), bad_input, [](const bad_input& e) {
    return std::string(e.what()) == "population: no collision of the sample is resolved";
  });
  BOOST_CHECK_THROW(sample_population(draw, 0), bad_input);
  const auto whole = sample_population(draw, 3);
  BOOST_CHECK_THROW(whole.quantile(1), bad_input);
  BOOST_CHECK_THROW(whole.captured_fraction(1), bad_input);
}

BOOST_AUTO_TEST_CASE(the_distribution_as_a_table) {
  const auto file = std::filesystem::temp_directory_path() / "ricochet_population.csv";
  sample_population(even_speeds, 1000).write(file, "the command", "restitution of grains", 10);
  std::ifstream in(file);
  std::string line, text;
  std::vector<std::string> rows;
  while (std::getline(in, line))
    (line.starts_with('#') ? text : rows.emplace_back()) += line;
  BOOST_TEST(text.find("the command") != std::string::npos);
  BOOST_TEST(rows.size() == 12); // the names of the columns, too
  BOOST_TEST(rows.front() == "restitution,share_up_to");
  BOOST_TEST(rows.back().ends_with(",1"));
  std::filesystem::remove(file);
}
