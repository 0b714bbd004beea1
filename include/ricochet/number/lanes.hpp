// Many collisions side by side as the scalar type of the laws: a fixed number of xsimd packs, several, so that the
// processor works on one while another's results are on their way.
#pragma once
#include <ricochet/number.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include <xsimd/xsimd.hpp>

namespace ricochet {

/// One truth value for each lane.
template <class Batch, std::size_t Packs>
struct lane_mask {
  std::array<typename Batch::batch_bool_type, Packs> packs;

  lane_mask() = default;
  lane_mask(bool all) { packs.fill(typename Batch::batch_bool_type(all)); }

  friend lane_mask operator&(const lane_mask& a, const lane_mask& b) {
    return each([&](std::size_t i) { return a.packs[i] & b.packs[i]; });
  }
  friend lane_mask operator|(const lane_mask& a, const lane_mask& b) {
    return each([&](std::size_t i) { return a.packs[i] | b.packs[i]; });
  }
  friend lane_mask operator~(const lane_mask& a) {
    return each([&](std::size_t i) { return ~a.packs[i]; });
  }

  /// Bit i is lane i.
  std::uint64_t bits() const {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < Packs; ++i)
      if (xsimd::any(packs[i])) {
        alignas(Batch) std::array<typename Batch::value_type, Batch::size> ones;
        xsimd::select(packs[i], Batch(1), Batch(0)).store_aligned(ones.data());
        for (std::size_t j = 0; j < Batch::size; ++j)
          all |= std::uint64_t(ones[j] != 0) << (i * Batch::size + j);
      }
    return all;
  }

  template <class Function> // without a loop, so that packs stay in registers
  static lane_mask each(const Function& f) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return lane_mask(std::array<typename Batch::batch_bool_type, Packs>{f(i)...});
    }
    (std::make_index_sequence<Packs>{});
  }

private:
  explicit lane_mask(const std::array<typename Batch::batch_bool_type, Packs>& each) : packs(each) {}
};

/// Batch::size times Packs numbers. Arithmetic, sqrt, abs, min, max, powers, log1p and cube roots go lane by
/// lane; no lane ever sees
/// another.
template <class Batch, std::size_t Packs>
struct lanes {
  using real = typename Batch::value_type;
  using mask = lane_mask<Batch, Packs>;
  static constexpr std::size_t size = Batch::size * Packs;
  static_assert(size <= 64, "a lane_mask has 64 bits");

  std::array<Batch, Packs> packs;

  lanes() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> lanes(Number x) { packs.fill(Batch(static_cast<real>(x))); }

  real operator[](std::size_t lane) const {
    real x;
    std::memcpy(&x, reinterpret_cast<const char*>(this) + lane * sizeof(real), sizeof(real));
    return x;
  }
  void put(std::size_t lane, const real& x) {
    std::memcpy(reinterpret_cast<char*>(this) + lane * sizeof(real), &x, sizeof(real));
  }

  friend lanes operator+(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return a.packs[i] + b.packs[i]; });
  }
  friend lanes operator-(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return a.packs[i] - b.packs[i]; });
  }
  friend lanes operator*(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return a.packs[i] * b.packs[i]; });
  }
  friend lanes operator/(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return a.packs[i] / b.packs[i]; });
  }
  friend lanes operator-(const lanes& a) {
    return each([&](std::size_t i) { return -a.packs[i]; });
  }
  lanes& operator+=(const lanes& b) { return *this = *this + b; }
  lanes& operator-=(const lanes& b) { return *this = *this - b; }
  lanes& operator*=(const lanes& b) { return *this = *this * b; }

  friend mask operator<(const lanes& a, const lanes& b) {
    return mask::each([&](std::size_t i) { return a.packs[i] < b.packs[i]; });
  }
  friend mask operator>(const lanes& a, const lanes& b) { return b < a; }
  friend mask operator<=(const lanes& a, const lanes& b) {
    return mask::each([&](std::size_t i) { return a.packs[i] <= b.packs[i]; });
  }
  friend mask operator>=(const lanes& a, const lanes& b) { return b <= a; }
  friend mask operator==(const lanes& a, const lanes& b) {
    return mask::each([&](std::size_t i) { return a.packs[i] == b.packs[i]; });
  }

  friend lanes sqrt(const lanes& a) {
    return each([&](std::size_t i) { return xsimd::sqrt(a.packs[i]); });
  }
  friend lanes abs(const lanes& a) {
    return each([&](std::size_t i) { return xsimd::abs(a.packs[i]); });
  }
  friend lanes max(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return xsimd::max(a.packs[i], b.packs[i]); });
  }
  friend lanes min(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return xsimd::min(a.packs[i], b.packs[i]); });
  }
  friend lanes pow(const lanes& a, const lanes& b) {
    return each([&](std::size_t i) { return xsimd::pow(a.packs[i], b.packs[i]); });
  }
  friend lanes log1p(const lanes& a) {
    return each([&](std::size_t i) { return xsimd::log1p(a.packs[i]); });
  }
  friend lanes cube_root(const lanes& a) {
    return each([&](std::size_t i) { return xsimd::cbrt(a.packs[i]); });
  }
  friend lanes where(const mask& condition, const lanes& yes, const lanes& no) {
    return each([&](std::size_t i) { return xsimd::select(condition.packs[i], yes.packs[i], no.packs[i]); });
  }

private:
  explicit lanes(const std::array<Batch, Packs>& each) : packs(each) {}

  template <class Function>
  static lanes each(const Function& f) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) { return lanes(std::array<Batch, Packs>{f(i)...}); }
    (std::make_index_sequence<Packs>{});
  }
};

/// Lanes that stay the same during a collision, with their reciprocals.
template <class Lanes>
struct constant_lanes : Lanes {
  Lanes reciprocal;

  constant_lanes() = default;
  constant_lanes(const Lanes& x) : Lanes(x), reciprocal(Lanes(1) / x) {}

  friend Lanes operator/(const Lanes& a, const constant_lanes& b) { return a * b.reciprocal; }
};

template <class Batch, std::size_t Packs>
struct constant_traits<lanes<Batch, Packs>> {
  using type = constant_lanes<lanes<Batch, Packs>>;
};

template <class Batch, std::size_t Packs>
struct number_traits<lanes<Batch, Packs>> {
  using real = typename Batch::value_type;
  static constexpr bool inverts_exactly = false;
  static lanes<Batch, Packs> pi() { return number_traits<real>::pi(); }
  static lanes<Batch, Packs> euler_gamma() { return number_traits<real>::euler_gamma(); }
  static lanes<Batch, Packs> value(const lanes<Batch, Packs>& x) { return x; }
};

/// Both sides are evaluated and blended, lane by lane.
template <class Lanes, class Batch, std::size_t Packs, class Yes, class No>
Lanes select(const lane_mask<Batch, Packs>& condition, Yes yes, No no) {
  return where(condition, Lanes(yes()), Lanes(no()));
}

/// Copies one lane of everything in `from` to a lane of `to`: objects made of lanes only, such as states and laws.
template <class Lanes, class Made>
void copy_lane(Made& to, std::size_t lane, const Made& from, std::size_t source) {
  static_assert(std::is_trivially_copyable_v<Made> && sizeof(Made) % sizeof(Lanes) == 0);
  constexpr std::size_t width = sizeof(typename Lanes::real);
  auto* put = reinterpret_cast<char*>(&to) + lane * width;
  const auto* get = reinterpret_cast<const char*>(&from) + source * width;
  for (std::size_t i = 0; i < sizeof(Made); i += sizeof(Lanes))
    std::memcpy(put + i, get + i, width);
}

} // namespace ricochet
