// 11 Cooling gas (builds on 02): a map of e(v) in an event-driven simulation of someone else's making.
//
// The simulation knows nothing of ricochet: it takes the restitution as a plain function of C, `double (*)(const void*,
// double)`, and moves 2000 spheres from collision to collision in a periodic box. With the same restitution at every
// speed the gas cools by Haff's law, T = T_0/(1 + t/tau)^2. Spheres of viscoelastic bulk grow the more elastic the
// slower they are, and cool more slowly: as the mean of 1 - e^2 over a Maxwellian's collisions says.
//
// Try next: give the spheres adhesion, and watch what sticking does to a gas that takes it for e = 0.
#include <ricochet/closed_form/tsuji.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/tsuji.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/end.hpp>
#include <ricochet/study/map/restitution_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <queue>
#include <random>
#include <vector>

namespace gas {

using vector = std::array<double, 3>;
using restitution_function = double (*)(const void*, double speed);

/// Hard spheres of unit mass and diameter in a periodic box, each collision at its time.
class simulation {
public:
  simulation(std::size_t count, double volume_fraction, restitution_function restitution, const void* of)
      : restitution_(restitution), of_(of), cells_(std::size_t(std::cbrt(double(count) * pi / 6 / volume_fraction))),
        size_(std::cbrt(double(count) * pi / 6 / volume_fraction)), spheres_(count),
        in_cell_(cells_ * cells_ * cells_) {
    std::mt19937_64 source(1);
    std::normal_distribution<double> normal;
    const std::size_t row = std::size_t(std::ceil(std::cbrt(double(count))));
    vector sum{};
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<std::size_t, 3> place{i % row, i / row % row, i / row / row};
      for (std::size_t k = 0; k < 3; ++k) {
        spheres_[i].x[k] = (double(place[k]) + 0.5) * size_ / double(row);
        sum[k] += spheres_[i].v[k] = normal(source);
      }
    }
    for (body& b : spheres_)
      for (std::size_t k = 0; k < 3; ++k)
        b.v[k] -= sum[k] / double(count);
    for (std::size_t i = 0; i < count; ++i)
      in_cell_[spheres_[i].cell = cell_of(spheres_[i].x)].push_back(i);
    for (std::size_t i = 0; i < count; ++i)
      predict(i);
  }

  /// m <v^2>/3
  double temperature() const {
    double sum = 0;
    for (const body& b : spheres_)
      sum += dot(b.v, b.v);
    return sum / (3 * double(spheres_.size()));
  }

  void run_until(double time) {
    while (events_.top().time < time) {
      const event next = events_.top();
      events_.pop();
      body& a = spheres_[next.a];
      if (next.changes_a != a.changes || (next.b != none && next.changes_b != spheres_[next.b].changes))
        continue; // one of them has moved otherwise since
      advance(a, next.time);
      ++a.changes;
      if (next.b == none) {
        change_cell(next.a);
      } else {
        advance(spheres_[next.b], next.time);
        ++spheres_[next.b].changes;
        bounce(a, spheres_[next.b]);
        predict(next.b);
      }
      predict(next.a);
    }
  }

  std::size_t collisions() const { return collisions_; }

private:
  static constexpr double pi = 3.14159265358979323846;
  static constexpr std::size_t none = std::size_t(-1);
  struct body {
    vector x, v;
    double time = 0;
    std::size_t cell = 0;
    unsigned changes = 0;
  };
  struct event {
    double time;
    std::size_t a, b;
    unsigned changes_a, changes_b;
    bool operator<(const event& other) const { return time > other.time; }
  };

  static double dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  void advance(body& b, double time) const {
    for (std::size_t k = 0; k < 3; ++k) {
      b.x[k] += b.v[k] * (time - b.time);
      b.x[k] -= size_ * std::floor(b.x[k] / size_);
    }
    b.time = time;
  }
  std::size_t along(double x) const { return std::min(std::size_t(x / size_ * double(cells_)), cells_ - 1); }
  std::size_t cell_of(const vector& x) const { return (along(x[2]) * cells_ + along(x[1])) * cells_ + along(x[0]); }

  void change_cell(std::size_t i) {
    auto& left = in_cell_[spheres_[i].cell];
    left.erase(std::find(left.begin(), left.end(), i));
    in_cell_[spheres_[i].cell = cell_of(spheres_[i].x)].push_back(i);
  }

  /// From a to b, the shortest way.
  vector apart(const body& a, const body& b) const {
    vector r;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = b.x[k] + b.v[k] * (a.time - b.time) - a.x[k];
      r[k] -= size_ * std::round(r[k] / size_);
    }
    return r;
  }

  void bounce(body& a, body& b) {
    const vector n = apart(a, b);
    const vector v{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]};
    const double speed = dot(v, n) / std::sqrt(dot(n, n)), e = restitution_(of_, speed);
    for (std::size_t k = 0; k < 3; ++k) {
      const double change = (1 + e) / 2 * dot(v, n) / dot(n, n) * n[k];
      a.v[k] -= change;
      b.v[k] += change;
    }
    ++collisions_;
  }

  /// The next collision with a neighbour, and when it leaves its cell.
  void predict(std::size_t i) {
    const body& a = spheres_[i];
    double leaves = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 3> here{along(a.x[0]), along(a.x[1]), along(a.x[2])};
    for (std::size_t k = 0; k < 3; ++k)
      if (a.v[k] != 0) {
        const double side = size_ / double(cells_), wall = (double(here[k]) + (a.v[k] > 0 ? 1 : 0)) * side;
        leaves = std::min(leaves, (wall - a.x[k]) / a.v[k]);
      }
    events_.push({a.time + std::max(leaves, 0.) + 1e-12 * (1 + a.time), i, none, a.changes, 0});
    for (std::size_t n = 0; n < 27; ++n) {
      const std::size_t x = (here[0] + n % 3 + cells_ - 1) % cells_, y = (here[1] + n / 3 % 3 + cells_ - 1) % cells_,
                        z = (here[2] + n / 9 + cells_ - 1) % cells_;
      for (const std::size_t j : in_cell_[(z * cells_ + y) * cells_ + x]) {
        if (j == i)
          continue;
        const body& b = spheres_[j];
        const vector r = apart(a, b), v{b.v[0] - a.v[0], b.v[1] - a.v[1], b.v[2] - a.v[2]};
        const double rv = dot(r, v), vv = dot(v, v), root = rv * rv - vv * (dot(r, r) - 1);
        if (rv < 0 && root > 0)
          events_.push({a.time + std::max((dot(r, r) - 1) / (-rv + std::sqrt(root)), 0.), i, j, a.changes, b.changes});
      }
    }
  }

  restitution_function restitution_;
  const void* of_;
  std::size_t cells_;
  double size_;
  std::vector<body> spheres_;
  std::vector<std::vector<std::size_t>> in_cell_;
  std::priority_queue<event> events_;
  std::size_t collisions_ = 0;
};

} // namespace gas

namespace {
using namespace ricochet;
using namespace ricochet::units;

constexpr double fraction = 0.05;

/// Collisions of one sphere in unit time, at temperature T [Enskog, with the contact value of Carnahan & Starling].
double frequency(double T) {
  const double density = 6 * fraction / pi<double>(), contact = (1 - fraction / 2) / std::pow(1 - fraction, 3);
  return 4 * density * contact * std::sqrt(pi<double>() * T);
}

/// dT/dt: of the energy of relative motion v^2/4, 1 - e^2 is lost, with v as a Maxwellian's collisions have it.
double cooling_rate(const restitution_map& e, double T) {
  double loss = 0, all = 0;
  for (double x = 0.01; x < 5; x += 0.02) { // of v/sqrt(2 T)
    const double v = x * std::sqrt(2 * T), weight = x * std::exp(-x * x / 2);
    loss += weight * (1 - e(v) * e(v)) * v * v;
    all += weight;
  }
  return -frequency(T) / 12 * loss / all;
}

/// The largest deviation of the simulated temperature, relative to the predicted one.
double cool(const char* what, const restitution_map& e) {
  // [call]
  gas::simulation spheres(2000, fraction, &restitution_map::restitution, &e);
  // [call]
  std::printf("%s\n  time   T simulated   predicted   collisions\n", what);
  double T = spheres.temperature(), largest = 0;
  const double step = 0.01;
  for (int i = 0; i <= 4000; ++i) {
    if (i % 500 == 0) {
      spheres.run_until(i * step);
      std::printf("%6.1f   %11.5f   %9.5f   %10zu\n", i * step, spheres.temperature(), T, spheres.collisions());
      largest = std::max(largest, std::abs(spheres.temperature() / T - 1));
    }
    const double half = T + cooling_rate(e, T) * step / 2;
    T += cooling_rate(e, half) * step;
  }
  return largest;
}
} // namespace

int main() {
  // Speeds are in units of 1 m/s here.
  const sphere ball{.solid = materials::water_ice, .radius = 1.0 * millimetres};
  const speed slowest = 1e-6 * metres_per_second, fastest = 100.0 * metres_per_second;
  const auto haff = make_restitution_map(
      compose(between(ball, ball), hertz{}, tsuji{closed_form::damping_coefficient_for(0.9)}, end_at_zero_overlap{}),
      slowest, fastest);
  // [map]
  const auto viscous = make_restitution_map(compose(between(ball, ball), hertz{}, kuwabara_kono{2e-7 * seconds}),
                                            slowest, fastest, {.max_error = 1e-8});
  viscous.save("viscous_ice.map.txt");
  std::printf("e(1 m/s) = %.8f, from %zu pieces\n", viscous(1.0 * metres_per_second), viscous.pieces().size());
  // [map]
  const double by_haff = cool("e = 0.9 at every speed", haff), by_bulk = cool("viscoelastic bulk", viscous);
  std::printf("largest deviations %.3f and %.3f\n", by_haff, by_bulk);
  return by_haff < 0.08 && by_bulk < 0.08 ? 0 : 1; // 2000 spheres scatter by some hundredths
}
