// Writes include/ricochet/closed_form/viscoelastic_hertz_table.hpp to standard output: the restitution of viscoelastic
// spheres as Chebyshev series, from solutions in long double. Takes 20 s.
#include "support/random_scenes.hpp"

#include <ricochet/closed_form/viscoelastic_hertz.hpp>

#include <cstdio>

namespace {
using namespace support;

template <class... Also>
long double restitution(double damping_number, Also... also) {
  const contact_pair pair{.reduced_modulus = 1 * pascals, .reduced_radius = 1 * metres, .reduced_mass = 1 * kilograms};
  const speed v = 1 * metres_per_second;
  const duration unit = 1 * seconds;
  const auto model = compose(
      pair, hertz{}, kuwabara_kono{damping_number / closed_form::damping_number(pair, unit, v) * unit}, also...);
  const scales in = model.scales_at(v);
  const reduced_model<long double, std::remove_const_t<decltype(model)>> numbers(model, in);
  collision<decltype(numbers), stepper::tsitouras_papakostas75> solver(numbers, 1e-17L, 40'000'000);
  return solver.solve(reduce<long double>(v, in)).restitution.value_or(0);
}

template <class Series, class Function>
void print(const char* name, const Series& shape, const Function& f) {
  constexpr std::size_t terms = Series::terms;
  std::printf("inline constexpr viscoelastic_hertz_series %s{\n    .last = %g,\n    .in_roots = %s,\n    .coefficients = "
              "{{\n",
              name, shape.last, shape.in_roots ? "true" : "false");
  for (std::size_t piece = 0; piece < Series::pieces; ++piece) {
    std::array<long double, terms> value;
    const auto node = [](std::size_t i) { return pi<long double>() * (static_cast<long double>(i) + 0.5L) / terms; };
    for (std::size_t i = 0; i < terms; ++i)
      value[i] = f(shape.argument(piece, static_cast<double>(std::cos(node(i)))));
    for (std::size_t k = 0; k < terms; ++k) {
      long double sum = 0;
      for (std::size_t i = 0; i < terms; ++i)
        sum += value[i] * std::cos(static_cast<long double>(k) * node(i));
      std::printf("%s%.17Lg", k ? ", " : "        {", sum * (k ? 2 : 1) / terms);
    }
    std::printf("},\n");
  }
  std::printf("    }}};\n\n");
}
} // namespace

int main() {
  using series = closed_form::detail::viscoelastic_hertz_series;
  std::printf("// Made by tests/tables/viscoelastic_hertz.cpp; not to be edited.\n#pragma once\n"
              "#include <ricochet/closed_form/chebyshev_pieces.hpp>\n\nnamespace ricochet::closed_form::detail {\n\n"
              "// clang-format off\nusing viscoelastic_hertz_series = chebyshev_pieces<%zu, %zu>;\n\n",
              series::pieces, series::terms);
  print("viscoelastic_hertz_to_zero_force", series{.last = 64, .in_roots = true},
        [](double y) { return restitution(y); });
  print("viscoelastic_hertz_to_zero_overlap", series{.last = 16, .in_roots = false},
        [](double y) { return restitution(y, end_at_zero_overlap{}); });
  std::printf("// clang-format on\n\n} // namespace ricochet::closed_form::detail\n");
}
