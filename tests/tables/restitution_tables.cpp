// Writes include/ricochet/closed_form/restitution_tables.hpp to standard output: restitutions that depend on one
// number, as polynomials in pieces, from solutions in long double. Takes ten seconds.
#include "support/random_scenes.hpp"

#include <ricochet/closed_form/viscoelastic_hertz.hpp>

#include <cstdio>

namespace {
using namespace support;

constexpr std::size_t pieces = 10, terms = 22;

template <class Model>
long double restitution(const Model& model, speed v) {
  const scales in = scales_at(model, v);
  const reduced_model<long double, Model> numbers(model, in);
  collision<decltype(numbers), stepper::tsitouras_papakostas75> solver(numbers, 1e-17L, 40'000'000);
  return solver.solve(reduce<long double>(v, in)).restitution.value_or(0);
}

constexpr speed v = 1 * metres_per_second;

contact_pair pair() {
  return {.reduced_modulus = 1 * pascals, .reduced_radius = 1 * metres, .reduced_mass = 1 * kilograms};
}

template <class... Also>
long double viscoelastic(double damping_number, Also... also) {
  const duration unit = 1 * seconds;
  const double of_unit = closed_form::damping_number(pair(), unit, v);
  return restitution(compose(pair(), hertz{}, kuwabara_kono{damping_number / of_unit * unit}, also...), v);
}

/// ln[(1 + cv)/(1 - cev)] = cv (1 + e), by Newton's method in l = -ln(1 - cev): e^-l - 1 + l = cv - ln(1 + cv).
long double hunt_crossley_by_energy(double cv) {
  const long double stored = cv - std::log1p(static_cast<long double>(cv));
  long double l = std::sqrt(2 * stored) + stored;
  for (int i = 0; i < 200; ++i)
    l -= (std::expm1(-l) + l - stored) / -std::expm1(-l);
  return -std::expm1(-l) / cv;
}

/// Polynomial through the Chebyshev nodes of a piece, in powers of x.
template <class Function>
std::array<long double, terms> interpolated(const Function& f) {
  const auto node = [](std::size_t i) { return pi<long double>() * (static_cast<long double>(i) + 0.5L) / terms; };
  std::array<long double, terms> value, sum{}, older{}, now{};
  for (std::size_t i = 0; i < terms; ++i)
    value[i] = f(std::cos(node(i)));
  now[0] = 1; // T_0, T_1, ... in powers of x
  for (std::size_t k = 0; k < terms; ++k) {
    long double coefficient = 0;
    for (std::size_t i = 0; i < terms; ++i)
      coefficient += value[i] * std::cos(static_cast<long double>(k) * node(i)) * (k ? 2 : 1) / terms;
    std::array<long double, terms> next{};
    for (std::size_t p = 0; p < terms; ++p) {
      sum[p] += coefficient * now[p];
      next[p] = (p ? now[p - 1] * (k ? 2 : 1) : 0) - older[p];
    }
    older = k ? now : std::array<long double, terms>{1};
    now = next;
  }
  return sum;
}

template <class Function>
void print(const char* name, double last, bool in_roots, const Function& f) {
  const double top = std::log1p(in_roots ? std::sqrt(last) : last);
  std::printf("inline constexpr restitution_table %s{\n    .last = %g,\n    .in_roots = %s,\n"
              "    .pieces_per_position = %.17g,\n    .coefficients = {{\n",
              name, last, in_roots ? "true" : "false", pieces / top);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const auto c = interpolated([&](long double x) {
      const double grown = std::expm1((double(piece) + (static_cast<double>(x) + 1) / 2) / pieces * top);
      return f(in_roots ? grown * grown : grown);
    });
    for (std::size_t k = 0; k < terms; ++k)
      std::printf("%s%.17Lg", k ? ", " : "        {", c[k]);
    std::printf("},\n");
  }
  std::printf("    }}};\n\n");
}
} // namespace

int main() {
  std::printf("// Made by tests/tables/restitution_tables.cpp; not to be edited.\n#pragma once\n"
              "#include <ricochet/closed_form/polynomial_pieces.hpp>\n\nnamespace ricochet::closed_form::detail {\n\n"
              "// clang-format off\nusing restitution_table = polynomial_pieces<%zu, %zu>;\n\n",
              pieces, terms);
  print("viscoelastic_hertz_to_zero_force", 64, true, [](double y) { return viscoelastic(y); });
  print("viscoelastic_hertz_to_zero_overlap", 16, false,
        [](double y) { return viscoelastic(y, end_at_zero_overlap{}); });
  print("hunt_crossley_restitution", 1000, false, hunt_crossley_by_energy);
  std::printf("// clang-format on\n\n} // namespace ricochet::closed_form::detail\n");
}
