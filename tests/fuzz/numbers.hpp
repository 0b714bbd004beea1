// Bytes as numbers.
#pragma once
#include <ricochet/units.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace fuzz {

class numbers {
public:
  numbers(const std::uint8_t* bytes, std::size_t size) : at_(bytes), end_(bytes + size) {}

  /// Below n; zero at the end of the bytes.
  std::size_t choice(std::size_t n) { return at_ == end_ ? 0 : *at_++ % n; }

  /// One byte says whether the number is one of a list, or a small count of decades, or the bits that follow: a fuzzer
  /// would be long in finding that NaN is something else than 1.
  double number() {
    using limits = std::numeric_limits<double>;
    constexpr std::array special{0.,
                                 -0.,
                                 1.,
                                 -1.,
                                 0.02,
                                 0.1,
                                 0.25,
                                 0.5,
                                 0.98,
                                 1e-4,
                                 1.01,
                                 1e-12,
                                 1e9,
                                 1e3,
                                 1e-6,
                                 1e154,
                                 1e-154,
                                 1e200,
                                 1e-200,
                                 1e-320,
                                 limits::denorm_min(),
                                 limits::min(),
                                 limits::max(),
                                 -limits::max(),
                                 limits::infinity(),
                                 -limits::infinity(),
                                 limits::quiet_NaN(),
                                 limits::signaling_NaN()};
    const std::size_t kind = choice(256);
    if (kind < special.size())
      return special[kind];
    if (kind < 2 * special.size()) // near it
      return special[kind - special.size()] * (1 + (double(choice(256)) - 128) * limits::epsilon());
    double x = 0;
    const std::size_t size = std::min<std::size_t>(sizeof x, static_cast<std::size_t>(end_ - at_));
    std::memcpy(&x, at_, size);
    at_ += size;
    return x;
  }

  template <class Quantity>
  void fill(Quantity& quantity) {
    if constexpr (std::is_arithmetic_v<Quantity>)
      quantity = number();
    else
      quantity = Quantity::from_value(number());
  }

private:
  const std::uint8_t *at_, *end_;
};

} // namespace fuzz
