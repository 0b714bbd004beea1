// Easy and hard scenes beside their solutions in 50 digits, which tests/tables/fifty_digits.cpp makes.
#include <boost/test/unit_test.hpp>

#include "support/composed_rows.hpp"

using namespace support;

namespace {
/// `solve(model, impact, options)` keeps its word on every scene at every tolerance.
template <class Solve>
void keeps_its_word(const std::string& road, const Solve& solve) {
  double closest = 0; // error over estimate
  int beyond = 0, scenes = 0;
  for (const auto& r : read_rows("fifty_digits.csv")) {
    const double exact = number(r, "restitution");
    ++scenes;
    compose_numbers(r, [&](const auto& model) {
      for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
        const auto out = solve(model, impact_of(r), collide_options{.tolerance = tolerance});
        const double error = std::abs(out.restitution.value_or(0) - exact);
        BOOST_TEST_CONTEXT(road << ", scene " << scenes << ", " << r.at("model") << " at " << r.at("speed")
                                << " m/s, tolerance " << tolerance) {
          BOOST_TEST(error <= out.error_estimate + 1e-15);
          if (out.error_estimate <= tolerance)
            BOOST_TEST(error <= tolerance);
          else
            ++beyond;
          if (out.ending_is_certain) {
            BOOST_TEST(name_of(out.ending) == r.at("ending"));
            BOOST_TEST(out.contacts == std::stoi(r.at("contacts")));
          }
        }
        if (out.error_estimate > 0)
          closest = std::max(closest, error / (out.error_estimate + 1e-15));
      }
    });
  }
  BOOST_TEST(scenes > 40);
  BOOST_TEST_MESSAGE(road << ": errors are " << closest << " of their estimates at most; " << beyond
                          << " outcomes are not certain to their tolerance");
}
} // namespace

BOOST_AUTO_TEST_CASE(collide_keeps_its_word_on_easy_and_hard_scenes) {
  keeps_its_word("collide", [](const auto&... with) { return collide(with...); });
}

BOOST_AUTO_TEST_CASE(integrate_keeps_its_word_on_easy_and_hard_scenes) {
  keeps_its_word("integrate", [](const auto&... with) { return integrate(with...); });
}

BOOST_AUTO_TEST_CASE(the_answers_have_more_digits_than_double) {
  for (const auto& r : read_rows("fifty_digits.csv"))
    BOOST_TEST(number(r, "difference") < (r.at("model").find("greenwood") == std::string::npos ? 1e-23 : 1e-16));
}
