// A pack of numbers as the scalar type of the laws: xsimd::batch. Laws work on packs; what steers a solution (domain,
// steps, events) looks at one number, and number_traits<batch>::value is therefore absent.
#pragma once
#include <ricochet/number.hpp>

#include <array>

#include <xsimd/xsimd.hpp>

namespace ricochet {

template <class T, class Arch>
struct number_traits<xsimd::batch<T, Arch>> {
  using real = T;
  static constexpr bool inverts_exactly = false;
  static xsimd::batch<T, Arch> pi() { return number_traits<T>::pi(); }
  static xsimd::batch<T, Arch> euler_gamma() { return number_traits<T>::euler_gamma(); }
};

/// Both sides are evaluated and blended, lane by lane.
template <class Pack, class T, class Arch, class Yes, class No>
Pack select(const xsimd::batch_bool<T, Arch>& condition, Yes yes, No no) {
  return xsimd::select(condition, Pack(yes()), Pack(no()));
}

/// A function known only on real numbers, lane by lane.
template <class Pack, class F>
requires std::same_as<Pack, xsimd::batch<typename Pack::value_type, typename Pack::arch_type>>
    Pack evaluate(const F& f, const Pack& x) {
  std::array<typename Pack::value_type, Pack::size> lanes;
  x.store_unaligned(lanes.data());
  for (auto& lane : lanes)
    lane = f.value(lane);
  return Pack::load_unaligned(lanes.data());
}

} // namespace ricochet
