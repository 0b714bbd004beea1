// Writes the scenes of a CSV file, in the form of tests/data/fifty_digits.csv, to standard output with what comes of
// them: from solutions in 50 digits at two step tolerances, and how far these differ. What the file says of outcomes is
// not read. 50 scenes take some ten minutes; how far it is goes to standard error.
#include "support/composed_rows.hpp"

#include <ricochet/number/multiprecision.hpp>
#include <ricochet/version.hpp>

#include <chrono>
#include <cstdio>
#include <functional>

namespace {
using fine = ricochet::multiprecise<50>;

/// A function of Q >= 0 as Chebyshev polynomials on the sixteenths of the octaves of Q + Q0, each made when it is first
/// asked for. \throws std::runtime_error where one is not exact to 30 digits at a place that it was not made from.
class remembered_curve {
  static constexpr int terms = 24;
  using polynomial = std::vector<fine>;

public:
  remembered_curve(double unit, std::function<fine(const fine&)> exact) : unit_(unit), exact_(std::move(exact)) {}

  fine operator()(const fine& Q) {
    const fine x = (Q > 0 ? Q : fine(0)) + unit_;
    int octave = 0;
    const int sixteenth = std::min(15, int((std::frexp(static_cast<double>(x), &octave) - 0.5) * 32));
    const fine half = ldexp(fine(1), octave - 6), middle = (33 + 2 * sixteenth) * half;
    polynomial& piece = pieces_[16 * octave + sixteenth];
    if (piece.empty()) {
      const auto at = [&](const fine& t) { return exact_(middle - unit_ + t * half); };
      piece = interpolated(at);
      const fine t = fine(3) / 7, here = at(t);
      if (abs(sum(piece, t) - here) > fine(1e-30) * abs(here))
        throw std::runtime_error("the crack law is too curved for its pieces");
    }
    return sum(piece, (x - middle) / half);
  }

private:
  static polynomial interpolated(const std::function<fine(const fine&)>& f) {
    polynomial c(terms);
    for (int i = 0; i < terms; ++i) {
      const fine angle = ricochet::pi<fine>() * (2 * i + 1) / (2 * terms), value = f(cos(angle));
      for (int j = 0; j < terms; ++j)
        c[std::size_t(j)] += value * cos(fine(j * angle)) * (j ? 2 : 1) / terms;
    }
    return c;
  }
  static fine sum(const polynomial& c, const fine& t) { // by Clenshaw's recurrence
    fine now = 0, before = 0;
    for (std::size_t j = c.size() - 1; j > 0; --j)
      before = std::exchange(now, c[j] + 2 * t * now - before);
    return c[0] + t * now - before;
  }

  double unit_;
  std::function<fine(const fine&)> exact_;
  std::map<int, polynomial> pieces_;
};

template <class T>
T evaluate(remembered_curve& curve, const T& Q) {
  return curve(Q);
}

/// The exact crack law, inverted in 50 digits and remembered: one inversion takes as long as a hundred sums.
struct remembered_edge {
  remembered_curve closing, opening;

  explicit remembered_edge(std::shared_ptr<const ricochet::greenwood_table> table)
      : closing(std::exp2(std::floor(std::log2(ricochet::square(table->modulus_ratio) / 200))),
                [table](const fine& Q) -> fine {
                  const auto curve = [k = fine(table->modulus_ratio)](const fine& alpha) {
                    return ricochet::cohesive_zone::closing<fine>(alpha, k);
                  };
                  const double near = static_cast<double>(Q);
                  const double guess = 0.25 * ricochet::pi<double>() * near * table->closing.value(near);
                  const fine alpha = ricochet::cohesive_zone::invert<fine>(curve, Q, fine(std::max(guess, near)));
                  return curve(alpha).slowness / Q;
                }),
        opening(1. / 16, [table](const fine& Q) -> fine {
          const double near = static_cast<double>(Q);
          const fine alpha = ricochet::cohesive_zone::invert<fine>(ricochet::cohesive_zone::opening<fine>, Q,
                                                                   fine(near * table->opening.value(near) / 4));
          return 4 * alpha / Q;
        }) {}
};

/// What the law holds; one for each modulus ratio, for all scenes.
class shared_edge {
public:
  shared_edge() = default;
  shared_edge(const std::shared_ptr<const ricochet::greenwood_table>& table) {
    static std::map<double, std::shared_ptr<remembered_edge>> all;
    auto& edge = all[table->modulus_ratio];
    if (!edge)
      edge = std::make_shared<remembered_edge>(table);
    edge_ = edge;
  }
  remembered_edge* operator->() const { return edge_.get(); }

private:
  std::shared_ptr<remembered_edge> edge_;
};
} // namespace

namespace ricochet {
template <>
struct number_traits<fine> { // but for inverts_exactly as in number/multiprecision.hpp
  using real = fine;
  static constexpr bool inverts_exactly = false;
  static real pi() { return boost::math::constants::pi<real>(); }
  static real euler_gamma() { return boost::math::constants::euler<real>(); }
  static const real& value(const real& x) { return x; }
};
template <>
struct greenwood_table_of<fine> {
  using type = shared_edge;
};
} // namespace ricochet

namespace {
using namespace support;

/// Scales of the collision as powers of four: no number is rounded where it is divided by them or their roots.
scales exact(const scales& unit) {
  const auto power = [](double x) { return std::ldexp(1., 2 * int(std::lround(std::log2(x) / 2))); };
  return {.length = power(unit.length), .duration = power(unit.duration), .mass = power(unit.mass)};
}

template <class Model>
auto solve(const Model& model, const impact& at, double tolerance) {
  const scales unit = exact(scales_at(model, at.speed));
  const reduced_model<fine, Model> numbers(model, unit);
  collision<decltype(numbers), stepper::fehlberg78> solver(numbers, fine(tolerance), 40'000'000);
  return solver.solve(reduce<fine>(at.speed, unit));
}

/// Of the steps, for the rougher solution. Free edges, with a kink in their law and an inverse in place of a formula,
/// take a hundred times as long for each digit.
template <class Model>
constexpr double tolerance_of = Model::has_crack_law ? 1e-20 : 1e-26;

void write(const row& r) {
  for (const auto& [name, unit] : scene_columns)
    std::printf("%s,", r.contains(name) ? r.at(name).c_str() : "");
  compose_numbers(r, [&](const auto& model) {
    constexpr double tolerance = tolerance_of<std::remove_cvref_t<decltype(model)>>;
    const auto rough = solve(model, impact_of(r), tolerance), out = solve(model, impact_of(r), tolerance / 16);
    if (rough.ending != out.ending)
      throw std::runtime_error("the ending depends on the step tolerance: " + r.at("model"));
    std::printf("%s,%d,", name_of(out.ending), out.contacts);
    if (out.restitution)
      std::printf("%s,%.1e\n", out.restitution->str(32).c_str(),
                  static_cast<double>(abs(*out.restitution - *rough.restitution)));
    else
      std::printf("0,0\n");
  });
}
} // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: fifty_digits SCENES.csv\n");
    return 2;
  }
  std::printf("# ricochet %s\n# command: fifty_digits SCENES.csv, which is tests/tables/fifty_digits.cpp\n"
              "# restitution: in 50 digits, by steps of Fehlberg 7(8) at a tolerance of 1e-26/16, with a crack law "
              "1e-20/16; difference: from that at 16 times as much\n",
              version);
  std::printf("# units:");
  for (const auto& [name, unit] : scene_columns)
    std::printf(" %s [%s]", name, unit);
  std::printf(" ending [-] contacts [1] restitution [1] difference [1]\n");
  for (const auto& [name, unit] : scene_columns)
    std::printf("%s,", name);
  std::printf("ending,contacts,restitution,difference\n");
  for (const auto& r : rows_of(argv[1])) {
    const auto start = std::chrono::steady_clock::now();
    write(r);
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %.1f s\n", r.at("model").c_str(),
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
} catch (const std::exception& e) {
  std::fprintf(stderr, "fifty_digits: %s\n", e.what());
  return 1;
}
