// Who computes a set of collisions, how well and how fast.
#pragma once
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace measure {

/// A result that the compiler must not do without.
inline void keep(double x) {
  volatile double kept = x;
  (void)kept;
}

inline double seconds_by(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}
/// Seconds this thread has been computing; what others do on the machine does not count.
inline double thread_seconds() { return seconds_by(CLOCK_THREAD_CPUTIME_ID); }
/// Seconds all threads together have been computing.
inline double process_seconds() { return seconds_by(CLOCK_PROCESS_CPUTIME_ID); }
/// Seconds that have passed.
inline double wall_seconds() { return seconds_by(CLOCK_MONOTONIC); }

template <class Clock, class Work>
double seconds_of(const Clock& clock, const Work& work) {
  const double start = clock();
  work();
  return clock() - start;
}
template <class Work>
double seconds_of(const Work& work) {
  return seconds_of(thread_seconds, work);
}

/// Least seconds of several works, each done in turn, `rounds` times.
inline std::vector<double> least_seconds(int rounds, const std::vector<std::function<void()>>& works) {
  std::vector<double> least(works.size(), 1e300);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < works.size(); ++i)
      least[i] = std::min(least[i], seconds_of(works[i]));
  return least;
}

/// Errors of the restitution over a set of collisions.
struct errors {
  double largest = 0, sum_of_squares = 0;
  std::size_t count = 0;

  void add(double error) {
    const double size = std::isfinite(error) ? std::abs(error) : 1; // what is no number is as wrong as can be
    largest = std::max(largest, size);
    sum_of_squares += size * size;
    ++count;
  }
  double rms() const { return std::sqrt(sum_of_squares / double(count)); }
};

/// Somebody who computes collisions `first` to `last` of a set at a tolerance of theirs, the restitution to e[first]
/// and on; `part` at a time, at most.
struct contender {
  std::string name;
  std::function<void(double tolerance, std::size_t first, std::size_t last, double* e)> solve;
  double loosest = 1e-2, tightest = 1e-14; ///< tolerances that make sense
  std::size_t part = 50;
  double tolerance = 0, error = 0, seconds = 1e300; ///< found; no tolerance if the error wanted is out of reach

  bool fits() const { return tolerance > 0; }
};

/// Errors at a tolerance; given up where one exceeds `most`.
inline errors errors_of(const contender& who, double tolerance, const std::vector<double>& expected,
                        double most = 1e300) {
  std::vector<double> e(expected.size());
  errors found;
  for (std::size_t first = 0; first < e.size() && found.largest <= most; first += who.part) {
    const std::size_t last = std::min(first + who.part, e.size());
    who.solve(tolerance, first, last, e.data());
    for (std::size_t i = first; i < last; ++i)
      found.add(e[i] - expected[i]);
  }
  return found;
}

/// Loosest tolerance, in quarters of a decade, whose largest error is as wanted; nobody's tolerance exceeds the error
/// by more than three.
inline void tune(contender& who, double wanted, const std::vector<double>& expected) {
  const double loosest = std::min(who.loosest, 1e3 * std::max(wanted, who.tightest));
  for (double tolerance = loosest; tolerance > 0.99 * who.tightest; tolerance *= std::pow(10., -0.25)) {
    const errors found = errors_of(who, tolerance, expected, wanted);
    who.error = found.largest;
    if (found.largest <= wanted) {
      who.tolerance = tolerance;
      return;
    }
  }
}

/// Least time of all over the whole set, by turns; whoever has had his share of seconds waits for the others.
inline void time_all(std::vector<contender>& all, std::size_t count, int rounds, double share) {
  std::vector<double> e(count), spent(all.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i)
      if (contender& who = all[i]; who.fits() && (round == 0 || spent[i] < share)) {
        const double seconds = seconds_of([&] { who.solve(who.tolerance, 0, count, e.data()); });
        spent[i] += seconds;
        who.seconds = std::min(who.seconds, seconds);
      }
}

/// A figure that was wanted and found.
struct verdict {
  std::string name;
  double figure, goal;
  bool at_most = false;
  bool met() const { return at_most ? figure <= goal : figure >= goal; }
};

} // namespace measure
