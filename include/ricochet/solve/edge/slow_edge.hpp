#pragma once
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/model/reduced_model.hpp>

#include <optional>

namespace ricochet {

/// Proof that a free edge around a Hertzian contact with JKR's surface energy can never open again, though the contact
/// has more energy than it would have apart.
///
/// With alpha = a/a_c, a_c the radius of JKR's fold, and b = sqrt(beta), the potential over E* a_c^5/R^2 is
///   U(alpha, b) = 8/15 alpha^5 - 16/3 alpha^{7/2} b + 16 alpha^2 b^2 - 8 alpha^2.
/// 1. An edge opens only while b > 1; so it passes alpha = 1 with U >= U(1, 1) = 16/5, JKR's energy at the fold. Where
/// it
///    lets go at alpha >= 1, at its limit past the fold, b^2 >= alpha^3, U is larger still. Below 16/5 it is captured.
/// 2. At the largest approach of a bounce b < alpha^{3/2}/6, the contact pushes, and U <= U(alpha, 0): at 16/5 or
/// above,
///    alpha > 2.5. To let go, it must therefore open across every band alpha_1 < alpha < alpha_2 <= 2.5 with b > 1 all
///    the while: b falls through one only on the way in and rises through one only on the way out.
/// 3. There delta < 0, and u = alpha_1^2 a_c^2/3R - delta obeys u'' <= -omega^2 u - (c/m*) u', omega^2 = 2E* a_1/m*,
/// with c
///    the damping coefficient: u > 0 lasts for pi/omega at most, a little longer with damping (Riccati's equation for
///    u'/u).
/// 4. In the band b is at most what U = K + U allows at one of its ends: between them U(alpha, b) has no minimum for b
/// >= 1. An edge too slow to cross a band in that time at the speed of that b is held for ever: energy only falls.
template <class Reduced>
class slow_edge {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using part = typename Reduced::part;
  static constexpr bool applies = Reduced::free_edge &&
                                  std::same_as<decltype(Reduced::elastic), hertz_law<reduced<T>>> &&
                                  std::same_as<decltype(Reduced::adhesion), jkr_law<reduced<T>>>;

public:
  explicit slow_edge(const Reduced& model) : model_(model) {
    if constexpr (applies) {
      fold_ = value_of(model.fold_coordinate()) * value_of(model.fold_coordinate());
      unit_ = value_of(T(model.adhesion.exit_energy(model.pair))) * 5 / 16;
    }
  }

  /// Energy by which a contact with this total one is proven to be held; nothing if it is not.
  std::optional<real> reserve(const part& c, const T& energy) const {
    if constexpr (applies) {
      const real total = value_of(energy) / unit_, alpha = value_of(c.radius) / fold_;
      const real at_fold = real(16) / 5;
      if (alpha >= 1 && total < at_fold)
        return unit_ * (at_fold - total);
      const real spare = (total + 42) / 100; // of the depth of the well, kept for errors of the solution
      if (alpha >= real(ends.back()))
        for (std::size_t i = 0; i < ends.size(); ++i)
          for (std::size_t j = i + 1; j < ends.size(); ++j)
            if (cannot_cross(real(ends[i]), real(ends[j]), total + spare))
              return unit_ * spare;
    }
    return std::nullopt;
  }

private:
  static constexpr std::array<float, 5> ends{1, 1.2f, 1.5f, 2, 2.5f}; ///< of the bands, in alpha

  bool cannot_cross(const real& low, const real& high, const real& total) const {
    const auto time = longest_opening(low, high);
    if (!time)
      return false;
    const real b = std::max<real>(largest_root_ratio(low, total), largest_root_ratio(high, total));
    const auto edge = rate_anywhere<T>(model_.crack, T(b));
    const real scale = value_of(T(model_.crack.speed_scale(model_.pair, model_.adhesion.work_of_adhesion)));
    const real jumps = real(1.01f); // of published fits at their joints
    return value_of(edge.slowness) > 0 &&
           -jumps * scale * value_of(edge.advance) * *time < (high - low) * fold_ * value_of(edge.slowness);
  }

  /// The larger b at which U(alpha, b) is this energy.
  static real largest_root_ratio(const real& alpha, const real& total) {
    const real mean = alpha * sqrt(alpha) / 6;
    return mean + sqrt(mean * mean + (total + 8 * alpha * alpha - pow(alpha, real(5)) * 8 / 15) / (16 * alpha * alpha));
  }

  /// Longest time that b > 1 can last in a band, unless damping would make it endless. Damping coefficients grow with
  /// the radius.
  std::optional<real> longest_opening(const real& low, const real& high) const {
    const real m = value_of(T(model_.pair.reduced_mass)), E = value_of(T(model_.pair.reduced_modulus));
    const real omega = sqrt(2 * E * low * fold_ / m);
    real gamma = 0;
    if constexpr (Reduced::damped) {
      gamma = damping_coefficient(high) / (2 * m);
      if (!(damping_coefficient(low) <= 2 * m * gamma))
        return std::nullopt;
    }
    if (!(gamma < omega))
      return std::nullopt;
    using std::atan;
    const real damped = sqrt((omega - gamma) * (omega + gamma)), half_pi = pi<real>() / 2;
    return half_pi / omega + (half_pi + atan(gamma / damped)) / damped;
  }

  real damping_coefficient(const real& alpha) const {
    part c{};
    c.radius = T(alpha * fold_);
    c.root_radius = sqrt(c.radius);
    return value_of(T(model_.damping.coefficient(model_.pair_of(c), c)));
  }

  const Reduced& model_;
  real fold_ = 1, unit_ = 1;
};

} // namespace ricochet
