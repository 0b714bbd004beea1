// Collisions that must come out alike, over random scenes.
#pragma once
#include "support/compositions.hpp"

#include <algorithm>
#include <cstdlib>

namespace metamorphic {
using namespace support;

/// Calls `use` with random scenes of all sizes and speeds, as many as RICOCHET_SCENES says or else `count`; some stick.
template <class Use>
void for_random_scenes(unsigned seed, std::size_t count, const Use& use) {
  if (const char* asked = std::getenv("RICOCHET_SCENES"))
    count = std::strtoul(asked, nullptr, 10);
  scenes random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    scene s = random.next();
    s.speed *= random.log_uniform(0.5, 2);
    BOOST_TEST_CONTEXT("scene " << i)
    use(s);
  }
}

/// Differences of restitutions that ought to be the same.
class spread {
public:
  explicit spread(const char* name) : name_(name) {}

  /// The endings must be the same, the restitutions as far as their bounds of error tell.
  void compare(const summary& a, const summary& b) {
    BOOST_TEST_CONTEXT(name_ << ", restitutions " << a.restitution << " and " << b.restitution) {
      BOOST_TEST(a.ended() == b.ended());
      if (!a.ended() || !b.ended())
        return;
      if (a.certain && b.certain)
        BOOST_TEST(name_of(a.ending) == name_of(b.ending));
      const double difference = std::abs(a.restitution - b.restitution);
      BOOST_TEST(difference <= a.error_estimate + b.error_estimate);
      all_.push_back(difference);
    }
  }

  double largest() const { return *std::max_element(all_.begin(), all_.end()); }
  double median() {
    const auto middle = all_.begin() + std::ptrdiff_t(all_.size() / 2);
    std::nth_element(all_.begin(), middle, all_.end());
    return *middle;
  }
  void tell() {
    BOOST_TEST_MESSAGE(name_ << ": apart by " << median() << " in the median, " << largest() << " at most");
  }

private:
  std::string name_;
  std::vector<double> all_;
};

} // namespace metamorphic
