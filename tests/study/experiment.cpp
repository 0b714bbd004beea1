#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/experiment.hpp>
#include <ricochet/study/fit/fit.hpp>
#include <ricochet/study/sweep.hpp>

#include <Eigen/Eigenvalues>

using namespace support;

namespace {
const ice_case ice;

/// Work of adhesion in J/m^2, bulk time in ps, yield strength in MPa.
const auto family = [](const std::array<double, 3>& p) {
  return compose(ice.pair, hertz{}, jkr{p[0] * joules_per_square_metre}, kuwabara_kono{p[1] * 1e-12 * seconds},
                 thornton_ning{p[2] * megapascals});
};
const std::array<double, 3> expected{0.74, 100, 400};
const std::vector<speed> candidates = logarithmic_speeds(2.0 * metres_per_second, 60.0 * metres_per_second, 41);

/// Rows 1, x, x^2, ... of n places from -1 to 1.
Eigen::MatrixXd powers(int n, int terms) {
  Eigen::MatrixXd rows(n, terms);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < terms; ++k)
      rows(i, k) = std::pow(-1 + 2. * i / (n - 1), k);
  return rows;
}

double determinant(const Eigen::MatrixXd& x, const Eigen::VectorXd& number) {
  return (x.transpose() * number.asDiagonal() * x).determinant();
}
Eigen::VectorXd as_vector(const std::vector<int>& number) {
  Eigen::VectorXd all(number.size());
  std::copy(number.begin(), number.end(), all.begin());
  return all;
}
} // namespace

BOOST_AUTO_TEST_CASE(polynomials_are_measured_where_it_is_known_to_be_best) {
  // Equal shares at the ends and where the derivative of Legendre's polynomial is zero [Guest 1958]. Between shares and
  // variance: an excess of it by 1e-9 goes with shares that are off by its root.
  const auto is_known = [](int n, int terms, const std::vector<double>& places) {
    const auto found = d_optimal_shares(powers(n, terms), 1e-10);
    double elsewhere = 1;
    for (const double place : places) {
      const double share = found.share[std::lround((place + 1) / 2 * (n - 1))];
      BOOST_TEST(std::abs(share - 1. / terms) < 1e-4);
      elsewhere -= share;
    }
    BOOST_TEST(elsewhere < 1e-4);
  };
  is_known(21, 2, {-1, 1});
  is_known(21, 3, {-1, 0, 1});
  // Of a cubic, +-1/sqrt 5, which only a grid made for it has.
  Eigen::MatrixXd cubic(6, 4);
  const double inner = 1 / std::sqrt(5.);
  const double places[] = {-1, -inner, -0.1, 0.3, inner, 1};
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 4; ++k)
      cubic(i, k) = std::pow(places[i], k);
  const auto found = d_optimal_shares(cubic, 1e-10);
  for (const int i : {0, 1, 4, 5})
    BOOST_TEST(std::abs(found.share[i] - 0.25) < 1e-4);
}

BOOST_AUTO_TEST_CASE(no_prediction_varies_more_than_the_equivalence_theorem_allows) {
  std::mt19937_64 source(1);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 40; ++n) {
    const int parameters = 1 + n % 5, rows = parameters + n;
    const Eigen::MatrixXd x = Eigen::MatrixXd::NullaryExpr(rows, parameters, [&] { return normal(source); });
    const auto found = d_optimal_shares(x, 1e-6);
    BOOST_TEST(std::abs(found.share.sum() - 1) < 1e-12);
    BOOST_TEST(found.share.minCoeff() >= 0);
    const Eigen::MatrixXd inverse = (x.transpose() * found.share.asDiagonal() * x).inverse();
    const Eigen::VectorXd variance = (x * inverse * x.transpose()).diagonal();
    BOOST_TEST((variance - found.variance).cwiseAbs().maxCoeff() < 1e-9 * parameters);
    BOOST_TEST(variance.maxCoeff() <= parameters * (1 + 1.001e-6));
    BOOST_TEST(std::abs(found.share.dot(variance) - parameters) < 1e-9); // whatever the shares
    for (int i = 0; i < 200; ++i) {                                      // none of these is better
      Eigen::VectorXd other = Eigen::VectorXd::NullaryExpr(rows, [&] { return std::pow(normal(source), 4); });
      other /= other.sum();
      BOOST_TEST(determinant(x, other) <= determinant(x, found.share) * (1 + parameters * 1e-6));
    }
    // Nor do the parameters' units matter.
    Eigen::MatrixXd scaled = x;
    scaled.col(0) *= 1e-12;
    BOOST_TEST((d_optimal_shares(scaled, 1e-6).share - found.share).cwiseAbs().maxCoeff() < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(whole_measurements_are_the_best_there_are) {
  const Eigen::MatrixXd x = powers(7, 3);
  const auto optimum = d_optimal_shares(x);
  for (int n = 3; n <= 6; ++n) {
    const auto number = whole_measurements(x, optimum, n);
    BOOST_TEST(std::accumulate(number.begin(), number.end(), 0) == n);
    double best = 0; // of all ways to place n measurements
    std::vector<int> tried(7);
    const auto place = [&](const auto& self, std::size_t i, int left) -> void {
      if (i + 1 == tried.size()) {
        tried[i] = left;
        best = std::max(best, determinant(x, as_vector(tried)));
        return;
      }
      for (tried[i] = 0; tried[i] <= left; ++tried[i])
        self(self, i + 1, left - tried[i]);
    };
    place(place, 0, n);
    BOOST_TEST(determinant(x, as_vector(number)) > best * (1 - 1e-9), n << " measurements");
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_model) {
  const speed v = 9.0 * metres_per_second;
  const auto found = family_sensitivities(family, expected, std::vector{v}, 1e-8)[0];
  const auto by = sensitivities(family(expected), impact{v}, {.tolerance = 1e-8});
  int seen = 0;
  for (const auto& each : by.by)
    for (std::size_t k = 0; k < 3; ++k)
      if (each.quantity == std::array{"work_of_adhesion", "bulk_time", "yield_strength"}[k]) {
        BOOST_TEST(std::abs(found.derivative[k] - each.relative()) < 1e-8);
        ++seen;
      }
  BOOST_TEST(seen == 3);
}

BOOST_AUTO_TEST_CASE(the_plan_beats_an_even_spread) {
  const auto plan = optimal_speeds(family, expected, candidates, {.measurements = 20, .error = 0.01});
  BOOST_TEST(plan.optimum.variance.maxCoeff() <= 3 * (1 + 1.001e-6));
  BOOST_TEST(std::accumulate(plan.measurements.begin(), plan.measurements.end(), 0) == 20);
  const auto spread = logarithmic_speeds(candidates.front(), candidates.back(), 20);
  const Eigen::MatrixXd even = derivatives_of(family_sensitivities(family, expected, spread));
  const double gained =
      determinant(plan.derivatives, as_vector(plan.measurements)) / determinant(even, Eigen::VectorXd::Ones(20));
  BOOST_TEST_MESSAGE("the confidence ellipsoid is " << std::sqrt(gained) << " times smaller");
  BOOST_TEST(gained > 2);
  const auto one = optimal_speeds(family, expected, candidates, {.threads = 1}),
             many = optimal_speeds(family, expected, candidates, {.threads = 3});
  BOOST_TEST((one.derivatives == many.derivatives && one.optimum.share == many.optimum.share));
}

BOOST_AUTO_TEST_CASE(fits_scatter_as_promised) {
  const char* asked = std::getenv("RICOCHET_REPETITIONS");
  const int repetitions = asked ? std::stoi(asked) : 60;
  const double error = 0.003;
  const auto plan = optimal_speeds(family, expected, candidates, {.measurements = 18, .error = error});
  std::vector<measurement> exact;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (int n = 0; n < plan.measurements[i]; ++n)
      exact.push_back({candidates[i], plan.restitution[i], error});
  std::mt19937_64 source(2);
  std::normal_distribution<double> noise(0, error);
  const std::array free{free_parameter{"work_of_adhesion", 0.3, 2}, free_parameter{"bulk_time", 20, 500},
                        free_parameter{"yield_strength", 100, 1600}};
  Eigen::MatrixXd logarithms(repetitions, 3);
  for (int r = 0; r < repetitions; ++r) {
    auto data = exact;
    for (measurement& each : data)
      *each.restitution += noise(source);
    const auto found = fit(family, data, free, {.starts = 8, .confidence = 0});
    for (int k = 0; k < 3; ++k)
      logarithms(r, k) = std::log(found.parameters[std::size_t(k)].value / expected[std::size_t(k)]);
  }
  for (int k = 0; k < 3; ++k) {
    const double scatter = std::sqrt(logarithms.col(k).squaredNorm() / repetitions);
    BOOST_TEST_MESSAGE(free[std::size_t(k)].name << ": promised " << plan.relative_errors[k] << ", found " << scatter);
    // The scatter itself scatters by 1/sqrt(2 repetitions); three times that.
    BOOST_TEST(std::abs(scatter / plan.relative_errors[k] - 1) < 3 / std::sqrt(2. * repetitions));
  }
}

BOOST_AUTO_TEST_CASE(too_few_measurements_or_candidates_promise_nothing) {
  const Eigen::MatrixXd x = powers(5, 3);
  BOOST_TEST(std::isinf(promised_errors(x, {4, 0, 0, 0, 4}, 1)[1]));
  BOOST_TEST(std::isinf(promised_errors(x, {0, 0, 0, 0, 0}, 1)[0]));
  // Of a mean, error/sqrt n.
  BOOST_TEST(std::abs(promised_errors(powers(5, 1), {1, 2, 3, 4, 6}, 0.2)[0] - 0.05) < 1e-15);
  BOOST_CHECK_THROW(d_optimal_shares(powers(2, 3)), bad_input);
  BOOST_CHECK_THROW(d_optimal_shares(Eigen::MatrixXd(0, 0)), bad_input);
  BOOST_CHECK_THROW(d_optimal_shares(Eigen::MatrixXd::Zero(4, 2)), bad_input);
  BOOST_CHECK_THROW(promised_errors(x, {1, 2}, 1), bad_input);
  BOOST_CHECK_THROW(promised_errors(x, {1, 2, -1, 3, 4}, 1), bad_input);
  BOOST_CHECK_THROW(promised_errors(x, {1, 2, 1, 3, 4}, 0), bad_input);
  BOOST_CHECK_THROW(d_optimal_shares(Eigen::MatrixXd::Constant(4, 2, std::nan(""))), bad_input);
  BOOST_CHECK_THROW(d_optimal_shares(x, 0), bad_input);
  BOOST_CHECK_THROW(whole_measurements(x, d_optimal_shares(x), 2), bad_input);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  const auto refuses = [](const std::array<double, 3>& p, const std::vector<speed>& speeds,
                          const experiment_options& options = {}) {
    BOOST_CHECK_THROW(optimal_speeds(family, p, speeds, options), bad_input);
  };
  refuses({0.74, 0, 400}, candidates);
  refuses({0.74, -1, 400}, candidates);
  refuses(expected, {});
  refuses(expected, {3.0 * metres_per_second, 4.0 * metres_per_second});
  refuses(expected, {0.1 * metres_per_second, 0.2 * metres_per_second, 0.3 * metres_per_second}); // all stick
  refuses(expected, {-1.0 * metres_per_second});
  refuses(expected, candidates, {.measurements = 2});
  refuses(expected, candidates, {.error = 0});
  refuses(expected, candidates, {.gap = 1});
  refuses(expected, candidates, {.tolerance = 0});
}

BOOST_AUTO_TEST_CASE(columns_that_nearly_agree) {
  // 1, x, ... x^4 over a short range: exchanges once went round in a circle, moved by round-off.
  Eigen::MatrixXd powers(41, 5);
  for (int i = 0; i < 41; ++i)
    for (int k = 0; k < 5; ++k)
      powers(i, k) = std::pow(0.7 + 0.015 * i, k);
  const auto optimum = d_optimal_shares(powers);
  BOOST_TEST((optimum.variance.maxCoeff() >= 5 * (1 - 1e-9) && optimum.variance.maxCoeff() <= 5 * (1 + 1e-6)));
  const auto whole = whole_measurements(powers, optimum, 6);
  BOOST_TEST(std::accumulate(whole.begin(), whole.end(), 0) == 6);
}
