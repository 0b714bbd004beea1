#include <boost/test/unit_test.hpp>

#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/number/multiprecision.hpp>

#include "support/reference_rows.hpp"

using namespace ricochet;
using namespace ricochet::units;

namespace {

using fine = multiprecise<50>;
constexpr double modulus_ratios[] = {1e-4, 1e-3, 0.02, 0.1, 0.5, 0.9, 0.98};

template <class T = double>
greenwood_law<reduced<T>> exact(double k) {
  greenwood made{seconds, k, metres};
  made.tabulate();
  return {T(1), T(k), T(1), T(1.01), made.table};
}

double speed_of(const greenwood_law<reduced<double>>& law, double root_ratio) {
  const auto edge = law.rate(root_ratio, root_ratio < 1 ? 0 : 1);
  return std::abs(edge.advance / edge.slowness);
}

/// beta at which the formulas have this speed, by bisection in ln(alpha): the speed falls with alpha.
long double ratio_at(long double v, long double k, bool closes) {
  const long double pi_ = pi<long double>();
  const auto edge = [&](long double alpha) -> std::pair<long double, long double> { // beta, v
    if (closes) {
      const auto p = cohesive_zone::closing<long double>(alpha, k);
      return {(k + p.ratio) / (1 + p.ratio), 1 / p.slowness};
    }
    const auto p = cohesive_zone::opening<long double>(alpha);
    const long double beta = (1 + p.ratio) / (k + p.ratio);
    return {beta, pi_ * beta / p.slowness};
  };
  long double low = -50, high = 50;
  for (int i = 0; i < 75; ++i) { // 100/2^75 is below round-off
    const long double middle = (low + high) / 2;
    (edge(std::exp(middle)).second > v ? low : high) = middle;
  }
  return edge(std::exp((low + high) / 2)).first;
}

} // namespace

BOOST_AUTO_TEST_CASE(backward_error) {
  for (const double k : modulus_ratios) {
    const auto law = exact(k);
    std::vector<double> ratios;
    for (int i = 1; i < 300; ++i)
      ratios.push_back(k * std::pow(k, -2 * i / 300.));
    for (double near = 1e-12; near < 0.5; near *= 5) // next to k, 1 and 1/k
      for (const double beta : {k * (1 + near), 1 - near, 1 + near, (1 - near) / k})
        if (beta > k && beta < 1 / k)
          ratios.push_back(beta);
    long double worst = 0;
    for (const double beta : ratios) {
      const double root = std::sqrt(beta);
      const long double given = static_cast<long double>(root) * root; // what the law is told
      const double v = speed_of(law, root);
      worst = std::max(worst, std::abs(ratio_at(v, k, root < 1) - given) / given);
    }
    BOOST_TEST_MESSAGE("k " << k << ": backward error " << worst);
    BOOST_TEST(worst < 1e-13L); // the promise of the header
  }
}

BOOST_AUTO_TEST_CASE(reference_values) {
  for (const auto& row : support::read_rows("geff_checkvalues.csv")) {
    const double k = support::number(row, "k");
    const auto law = exact(k);
    BOOST_TEST_CONTEXT("k " << k << ", alpha " << row.at("alpha")) {
      for (const std::string side : {"close", "open"}) {
        const double beta = support::number(row, "beta_" + side), v = support::number(row, "vhat_" + side);
        // An ulp of beta moves v by ulp * d ln v/d ln beta, and by its distance from the end where v is infinite:
        const double ends = std::min(std::abs(beta / k - 1), std::abs(1 - k * beta)), middle = std::abs(beta - 1);
        BOOST_TEST(std::abs(speed_of(law, std::sqrt(beta)) / v - 1) < 1e-13 + 2e-15 * (1 / ends + 1 / middle));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(fifty_digits_against_the_table) {
  for (const double k : modulus_ratios) {
    const auto table = exact(k);
    const auto inversion = exact<fine>(k);
    for (int i = 1; i < 60; ++i) {
      const double root = std::sqrt(k) * std::pow(k, -i / 60.);
      if (std::abs(root - 1) < 1e-9)
        continue;
      const int piece = root < 1 ? 0 : 1;
      const auto one = table.rate(root, piece);
      const auto other = inversion.rate(fine(root), piece);
      BOOST_TEST_REQUIRE(std::abs(one.advance / static_cast<double>(other.advance) - 1) < 1e-15);
      // As above: 1e-13 of the table, and rounding of Q next to its zeros and poles.
      const double beta = root * root, ends = std::min(std::abs(beta / k - 1), std::abs(1 - k * beta));
      BOOST_TEST_REQUIRE(std::abs(one.slowness / static_cast<double>(other.slowness) - 1) <
                         1e-13 + 1e-15 * (1 / ends + 1 / std::abs(beta - 1)));
    }
  }
}

BOOST_AUTO_TEST_CASE(runs_on_through_the_ends_of_its_range) {
  for (const double k : modulus_ratios) {
    const auto law = exact(k);
    const auto beyond = [k](double part) { return std::sqrt((1 + part * (1 - k)) / k); };
    BOOST_TEST(law.rate(beyond(-1e-6), 1).slowness > 0);
    BOOST_TEST(law.rate(beyond(1e-6), 1).slowness < 0); // the event of letting go needs a sign
    BOOST_TEST(law.rate(std::sqrt(k) * 0.999, 0).slowness < 0);
  }
}

BOOST_AUTO_TEST_CASE(fifty_digits_run_on_through_the_ends_like_the_table) {
  for (const double k : modulus_ratios)
    for (const double root : {std::sqrt(k) * 0.9999, 1.0001 / std::sqrt(k)}) {
      const int piece = root < 1 ? 0 : 1;
      const double one = exact(k).rate(root, piece).slowness;
      const auto other = static_cast<double>(exact<fine>(k).rate(fine(root), piece).slowness);
      BOOST_TEST(std::abs(one / other - 1) < 1e-10); // rounding of Q, whose size is 1e-4 k/(1-k) here
    }
}

BOOST_AUTO_TEST_CASE(a_table_is_made_once_and_shared_for_the_same_modulus_ratio) {
  greenwood one{seconds, 0.1, metres};
  one.tabulate();
  BOOST_TEST_REQUIRE(one.table);
  const auto made = one.table;
  one.tabulate();
  BOOST_TEST(one.table == made);
  greenwood other{.modulus_ratio = 0.2, .table = made};
  BOOST_CHECK_EXCEPTION(other.tabulate(), bad_input, [](const bad_input& e) {
    const std::string what = e.what();
    return what.find("modulus_ratio = 0.1") != std::string::npos && what.find("0.2") != std::string::npos;
  });
  other.modulus_ratio = 0.1;
  other.tabulate();
  BOOST_TEST(other.table == made);
}

BOOST_AUTO_TEST_CASE(modulus_ratios_outside_the_supported_range_are_refused) {
  for (const double k : {0., 0.99e-4, 0.981, 1., 1.5, -0.02, std::nan("")})
    BOOST_CHECK_EXCEPTION(validate_law(greenwood{seconds, k, metres}), bad_input, [](const bad_input& e) {
      const std::string what = e.what();
      return what.starts_with("modulus_ratio = ") && what.ends_with(" is outside [0.0001, 0.98]");
    });
}
