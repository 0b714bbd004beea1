// A quantity of one pair as a function of the speed of impact, at once: for codes that ask for it millions of times.
#pragma once
#include <ricochet/study/map/map_file.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include <xsimd/xsimd.hpp>

namespace ricochet {

/// What a map can be of. captured: its value where the pair sticks. relative: are its errors meant so?
struct restitution_of_speed {
  static constexpr const char *name = "restitution", *unit = "1";
  static constexpr double captured = 0;
  static constexpr bool relative = false;
};
struct duration_of_speed {
  static constexpr const char *name = "contact duration", *unit = "s";
  static constexpr double captured = std::numeric_limits<double>::quiet_NaN();
  static constexpr bool relative = true;
};

/// A quantity between two speeds, by polynomials of degree seven between bisected speeds. Up to the sticking speed it
/// is that of a captured pair; outside the range it was made for it is no number.
template <class Of>
class speed_map {
public:
  static constexpr std::size_t terms = 8;

  /// c0 + c1 t + ... with t from -1 at `begin` to 1 at `end`, both in m/s, linear in the speed, or, where it is
  /// `rooted`, in sqrt(v - sticking speed), in which e and duration are smooth next to the sticking speed.
  struct piece {
    double begin, end;
    bool rooted;
    std::array<double, terms> c;

    double operator()(double v, double sticking) const {
      const auto variable = [&](double speed) { return rooted ? std::sqrt(speed - sticking) : speed; };
      const double from = variable(begin), to = variable(end), t = (2 * variable(v) - (from + to)) / (to - from);
      double sum = 0;
      for (std::size_t i = terms; i-- > 0;)
        sum = sum * t + c[i];
      return sum;
    }
  };

  /// low, high: range of speeds; sticking: speed up to which the pair sticks, 0 if it does not anywhere between; all in
  /// m/s. pieces: from the sticking speed, or low, to high, the rooted ones first. largest_error: found by comparison
  /// with collisions. description: one line. \throws bad_input if the pieces do not join or the numbers are no range.
  speed_map(double low, double high, double sticking, double largest_error, std::vector<piece> pieces,
            std::string description = "")
      : low_(low), high_(high), sticking_(sticking), largest_error_(largest_error), pieces_(std::move(pieces)),
        description_(detail::one_line(description)) {
    require("low speed of the map", low, positive);
    require("high speed of the map", high, range{.low = low, .low_included = false});
    require("sticking speed of the map", sticking, range{.high = high, .high_included = true});
    require("largest error of the map", largest_error, non_negative);
    double at = std::max(low, sticking);
    first_cell_ = cell_of(at);
    for (const piece& each : pieces_) {
      if (each.begin != at || !(each.end > at))
        throw bad_input("map: no piece goes on at " + shown(at) + " m/s");
      if (each.rooted && at != (segments_.empty() ? sticking : rooted_up_to_))
        throw bad_input("map: the rooted piece at " + shown(at) + " m/s does not follow on the sticking speed");
      const auto variable = [&](double v) { return each.rooted ? std::sqrt(v - sticking) : v; };
      const double from = variable(each.begin), to = variable(each.end);
      segments_.push_back({(from + to) / 2, 2 / (to - from), each.c});
      ends_.push_back(at = each.end);
      rooted_up_to_ = each.rooted ? at : rooted_up_to_;
    }
    if (at != high)
      throw bad_input("map: it ends at " + shown(at) + " m/s, not at " + shown(high) + " m/s");
    for (std::size_t cell = first_cell_, next = 0; !pieces_.empty() && cell <= cell_of(high); ++cell) {
      while (next + 1 < ends_.size() && ends_[next] <= std::bit_cast<double>(cell << shift))
        ++next;
      start_.push_back(std::uint32_t(next));
    }
  }

  /// At a speed in m/s; NaN outside [low, high].
  double operator()(double v) const {
    if (!(v >= low_ && v <= high_))
      return std::numeric_limits<double>::quiet_NaN();
    if (v <= sticking_)
      return Of::captured;
    const segment& s = segments_[piece_at(v)];
    const double x = v <= rooted_up_to_ ? std::sqrt(v - sticking_) : v;
    const double t = (x - s.middle) * s.per_half, square = t * t;
    const auto& c = s.c;
    const double even = ((c[6] * square + c[4]) * square + c[2]) * square + c[0];
    const double odd = ((c[7] * square + c[5]) * square + c[3]) * square + c[1];
    return Of::relative ? even + t * odd : std::clamp(even + t * odd, 0., 1.);
  }
  double operator()(speed v) const { return (*this)(in_si(v)); }

  /// At as many speeds as a pack holds, each by itself: the values are the same, and gathering the coefficients of as
  /// many pieces takes three times as long (2, 4 and 8 lanes).
  template <class Arch>
  xsimd::batch<double, Arch> operator()(const xsimd::batch<double, Arch>& v) const {
    using pack = xsimd::batch<double, Arch>;
    alignas(pack) std::array<double, pack::size> values;
    v.store_aligned(values.data());
    for (double& x : values)
      x = (*this)(x);
    return pack::load_aligned(values.data());
  }

  /// The same as plain functions of C, of one speed and of many, in m/s: `map` is the address of a map.
  static double restitution(const void* map, double speed) requires std::same_as<Of, restitution_of_speed> {
    return one(map, speed);
  }
  static void restitutions(const void* map, const double* speeds, double* restitutions,
                           std::size_t count) requires std::same_as<Of, restitution_of_speed> {
    many(map, speeds, restitutions, count);
  }
  static double contact_duration(const void* map, double speed) requires std::same_as<Of, duration_of_speed> {
    return one(map, speed);
  }
  static void contact_durations(const void* map, const double* speeds, double* seconds,
                                std::size_t count) requires std::same_as<Of, duration_of_speed> {
    many(map, speeds, seconds, count);
  }

  double low() const { return low_; }
  double high() const { return high_; }
  double sticking_speed() const { return sticking_; }
  double largest_error() const { return largest_error_; }
  const std::vector<piece>& pieces() const { return pieces_; }
  const std::string& description() const { return description_; }

  /// Format 2: text. Comment lines begin with #; then low, high, sticking speed, largest error and the number of
  /// pieces, and a line for each piece: begin, end, 1 if rooted, and its coefficients; in the last line, `checksum` and
  /// the CRC-32 of all lines before. \throws std::runtime_error if the file cannot be written.
  void save(const std::filesystem::path& file) const {
    detail::map_writer out(kind(), description_);
    out.comment(std::string("largest error found: ") + detail::exact(largest_error_) +
                (Of::relative ? ", relative" : ", absolute"));
    out.comment("low [m/s], high [m/s], sticking speed [m/s], largest error, number of pieces; for each: begin [m/s],");
    out.comment(
        "end [m/s], 1 if rooted, and the coefficients c0 ... c7 [" + std::string(Of::unit) +
        "] of t, which goes from -1 at begin to 1 at end, linear in v, or in sqrt(v - sticking speed) if rooted");
    out.line(low_, high_, sticking_, largest_error_, double(pieces_.size()));
    for (const piece& each : pieces_)
      out.line(each.begin, each.end, double(each.rooted), each.c);
    out.finish(file);
  }

  /// \throws std::runtime_error naming the file if it is not there, not whole, of another kind or changed since it was
  /// saved.
  static speed_map load(const std::filesystem::path& file) {
    detail::map_reader in(file, kind());
    const double low = in.number(), high = in.number(), sticking = in.number(), largest_error = in.number();
    std::vector<piece> pieces;
    for (std::size_t left = in.count(); left > 0; --left) {
      piece& each = pieces.emplace_back();
      each.begin = in.number();
      each.end = in.number();
      each.rooted = in.number() != 0;
      for (double& c : each.c)
        c = in.number();
    }
    return in.finish(
        [&] { return speed_map(low, high, sticking, largest_error, std::move(pieces), in.description()); });
  }

private:
  struct segment { ///< t = (variable - middle) * per_half
    double middle, per_half;
    std::array<double, terms> c;
  };
  static constexpr int shift = 52 - 6; ///< 64 cells for each octave
  static std::uint64_t cell_of(double v) { return std::bit_cast<std::uint64_t>(v) >> shift; }
  static std::string kind() { return std::string(Of::name) + " map"; }

  std::size_t piece_at(double v) const {
    std::size_t i = start_[cell_of(v) - first_cell_];
    while (v > ends_[i])
      ++i;
    return i;
  }
  static double one(const void* map, double speed) { return (*static_cast<const speed_map*>(map))(speed); }
  static void many(const void* map, const double* speeds, double* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      values[i] = one(map, speeds[i]);
  }

  double low_, high_, sticking_, largest_error_;
  std::vector<piece> pieces_;
  std::string description_;
  double rooted_up_to_ = 0;
  std::vector<segment> segments_; ///< the pieces, as they are asked
  std::vector<double> ends_;
  std::uint64_t first_cell_ = 0;
  std::vector<std::uint32_t> start_; ///< for each cell of speeds, the first piece that reaches into it
};

using restitution_map = speed_map<restitution_of_speed>;
using duration_map = speed_map<duration_of_speed>;

} // namespace ricochet
