// How near ricochet's batches are to what the machine can do. Compiled apart from the comparisons with peers: a
// compiler puts a model's steps together otherwise where they are used in more places.
#pragma once
#include "measure.hpp"

#include <array>

namespace efficiency {

/// Share of the SIMD peak, cost of events, and lanes in use, of JKR with the damping of Kuwabara and Kono.
std::vector<measure::verdict> of_batches();

/// A large batch on one thread and on two, by the clock on the wall. Others on the machine spoil it: repeated now and
/// then, the least times count.
class two_threads {
public:
  two_threads();
  void again();
  double gain() const { return least_[0] / least_[1]; }
  /// Of the machine's cores, how many the fastest run on two threads had.
  double cores() const { return cores_; }

private:
  std::function<void(unsigned threads)> run_;
  std::array<double, 2> least_{1e300, 1e300};
  double cores_ = 0;
};

} // namespace efficiency
