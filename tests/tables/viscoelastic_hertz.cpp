// Writes include/ricochet/closed_form/viscoelastic_hertz_table.hpp to standard output: the restitution of viscoelastic
// spheres as Chebyshev series, from solutions in long double.
#include "support/random_scenes.hpp"

#include <ricochet/closed_form/viscoelastic_hertz.hpp>

#include <cstdio>
#include <numbers>

namespace {
using namespace support;

constexpr int pieces = 6, terms = 20;
constexpr double last = 64; ///< damping number

template <class... Also>
double restitution(double damping_number, Also... also) {
  const contact_pair pair{.reduced_modulus = 1 * pascals, .reduced_radius = 1 * metres, .reduced_mass = 1 * kilograms};
  const speed v = 1 * metres_per_second;
  const duration unit = 1 * seconds;
  const auto model = compose(
      pair, hertz{}, kuwabara_kono{damping_number / closed_form::damping_number(pair, unit, v) * unit}, also...);
  return reference_restitution(model, v);
}

template <class Function>
void print_series(const char* name, const Function& f) {
  std::printf("inline constexpr viscoelastic_hertz_series %s{{\n", name);
  for (int piece = 0; piece < pieces; ++piece) {
    std::array<double, terms> value;
    for (int i = 0; i < terms; ++i) {
      const double x = std::cos(std::numbers::pi * (i + 0.5) / terms);
      value[std::size_t(i)] = f(std::expm1((piece + (x + 1) / 2) * std::log1p(last) / pieces));
    }
    std::printf("    {");
    for (int k = 0; k < terms; ++k) {
      long double sum = 0;
      for (int i = 0; i < terms; ++i)
        sum += static_cast<long double>(value[std::size_t(i)]) *
               std::cos(std::numbers::pi_v<long double> * k * (i + 0.5L) / terms);
      std::printf("%s%.17Lg", k ? ", " : "", sum * (k ? 2 : 1) / terms);
    }
    std::printf("},\n");
  }
  std::printf("}};\n\n");
}
} // namespace

int main() {
  std::printf(R"(// Made by tests/tables/viscoelastic_hertz.cpp; not to be edited.
#pragma once
#include <array>

namespace ricochet::closed_form::detail {

/// Chebyshev coefficients over equal pieces of ln(1 + y), y = 0 to %g.
inline constexpr double viscoelastic_hertz_last = %g;
using viscoelastic_hertz_series = std::array<std::array<double, %d>, %d>;

)",
              last, last, terms, pieces);
  print_series("viscoelastic_hertz_to_zero_force", [](double y) { return restitution(y); });
  print_series("viscoelastic_hertz_to_zero_overlap", [](double y) { return restitution(y, end_at_zero_overlap{}); });
  std::printf("} // namespace ricochet::closed_form::detail\n");
}
