#pragma once
#include <ricochet/number.hpp>

#include <cstdint>

#include <boost/math/tools/minima.hpp>

namespace ricochet {

/// Follows one observable over the steps of a motion and refines each maximum that it passes, to round-off.
template <class Real>
class maximum {
public:
  explicit maximum(const Real& first) : before_(first), now_(first), largest_(first) {}

  /// A new motion begins at this value; the largest so far is kept.
  void restart(const Real& first) {
    before_ = now_ = first;
    largest_ = std::max(largest_, first);
    last_h_ = 0;
  }

  /// A step of size h has led to `value`. `before(part)` and `here(part)` give the observable within the last step but
  /// one and within this one.
  template <class Before, class Here>
  void step(const Real& h, const Real& value, const Before& before, const Here& here) {
    largest_ = max(largest_, value);
    const bool level = now_ == before_ && now_ == value; // as the radius before the surfaces touch
    if (now_ >= before_ && now_ >= value && !level && last_h_ > 0) {
      const auto negative = [&](const Real& t) -> Real { return t < 0 ? -before(t + last_h_) : -here(t); };
      std::uintmax_t iterations = 60;
      const auto found = boost::math::tools::brent_find_minima(negative, Real(-last_h_), h,
                                                               std::numeric_limits<Real>::digits / 2, iterations);
      largest_ = max(largest_, Real(-found.second));
    }
    before_ = now_;
    now_ = value;
    last_h_ = h;
  }

  const Real& value() const { return largest_; }

private:
  Real before_, now_, largest_, last_h_ = 0;
};

} // namespace ricochet
