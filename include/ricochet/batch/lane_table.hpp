// The exact crack law's table for many collisions side by side, whose modulus ratios may differ.
#pragma once
#include <ricochet/law/crack/greenwood_table.hpp>
#include <ricochet/number/lanes.hpp>

namespace ricochet {

/// Both curves of each lane's table, which has to outlive it: greenwood_curve::value with its numbers fetched from
/// wherever they are.
template <class Batch, std::size_t Packs>
class lane_greenwood_table {
  using number = lanes<Batch, Packs>;
  using bits = xsimd::batch<std::int64_t, typename Batch::arch_type>;
  using polynomial = greenwood_curve::polynomial;
  static constexpr int to_piece = greenwood_curve::mantissa_bits - greenwood_curve::piece_bits;
  static_assert(sizeof(polynomial) == 8 * sizeof(double));

public:
  void put(std::size_t lane, const greenwood_table& table) {
    closing_.put(lane, table.closing);
    opening_.put(lane, table.opening);
  }

  /// At Q, of the closing curve where `closes` says so.
  number value(const typename number::mask& closes, const number& Q) const {
    const number unit = where(closes, closing_.unit, opening_.unit),
                 place = where(closes, closing_.place, opening_.place);
    number result;
    for (std::size_t i = 0; i < Packs; ++i)
      result.packs[i] = value(Q.packs[i], unit.packs[i], xsimd::bitwise_cast<bits>(place.packs[i]));
    return result;
  }

private:
  struct curve {
    number unit{};
    number
        place{}; ///< bits of the distance, in doubles, from `here` to where the polynomial of piece number 0 would be

    void put(std::size_t lane, const greenwood_curve& from) {
      const auto address = [](const double& x) { return std::int64_t(reinterpret_cast<std::intptr_t>(&x)); };
      const std::int64_t first = std::int64_t(std::bit_cast<std::uint64_t>(from.unit()) >> to_piece);
      const std::int64_t distance =
          (address(from.polynomials()[0][0]) - address(here)) / std::int64_t(sizeof(double)) - first * 8;
      unit.put(lane, from.unit());
      place.put(lane, std::bit_cast<double>(distance));
    }
  };

  static Batch value(const Batch& Q, const Batch& unit, const bits& place) {
    const Batch clamped = xsimd::min(xsimd::max(Q, Batch(0.)), Batch(greenwood_curve::last)), x = clamped + unit;
    const bits of_x = xsimd::bitwise_cast<bits>(x);
    const bits number_of_piece = of_x >> to_piece, exponent = of_x >> greenwood_curve::mantissa_bits;
    const Batch start = xsimd::bitwise_cast<Batch>(bits(number_of_piece << to_piece));
    const bits shrunk = bits(std::int64_t(2 * 1023 + greenwood_curve::piece_bits + 1)) - exponent;
    const Batch per_half = xsimd::bitwise_cast<Batch>(bits(shrunk << greenwood_curve::mantissa_bits));
    const Batch t = (clamped - (start - unit)) * per_half - Batch(1.), square = t * t;
    const bits at = place + (number_of_piece << 3);
    const double* const from = origin();
    const auto power = [&](std::int64_t j) { return Batch::gather(from, at + bits(j)); };
    constexpr int degree = greenwood_curve::degree;
    Batch even = power(degree - 1), odd = power(degree);
    for (int j = degree - 1; j >= 2; j -= 2) {
      even = even * square + power(j - 2);
      odd = odd * square + power(j - 1);
    }
    return even + t * odd;
  }

  static constexpr double here = 0;
  /// Not inlined, lest it be taken for all there is to be read.
  [[gnu::noinline]] static const double* origin() { return &here; }
  curve closing_, opening_;
};

template <class Batch, std::size_t Packs>
struct greenwood_table_of<lanes<Batch, Packs>> {
  using type = lane_greenwood_table<Batch, Packs>;
};

} // namespace ricochet
