#pragma once
#include <ricochet/body/pair.hpp>

#include <boost/math/tools/toms748_solve.hpp>

namespace ricochet {

/// x - sin x without cancellation; `sine` is sin x.
template <class T>
T excess_over_sine(const T& x, const T& sine) {
  if (value_of(x) > 1)
    return x - sine;
  T term = x * x * x / T(6), sum = term;
  for (int n = 4; abs(value_of(term)) > std::numeric_limits<real_of<T>>::epsilon() * value_of(sum) / 8; n += 2) {
    term *= -x * x / T(n * (n + 1));
    sum += term;
  }
  return sum;
}

/// Equilibria of spheres whose surfaces pull with a constant stress wherever their gap is below a range z0: within a
/// radius c, in a disc before they touch and then in a ring outside a = c cos t. Explicit in c before they touch and in
/// q = cot t from then on; the coordinate y is c over that at touch less one, then q in units of its typical size.
/// Source: Maugis 1992; before touch: Johnson & Greenwood 1997.
template <class S>
class dugdale_branch {
public:
  using number = typename S::number;
  using length = typename S::length;

  struct point {
    length approach, radius, cohesive_radius;
    number angle;
    length slope; ///< of the approach over y
  };

  dugdale_branch() = default;
  /// strain: 2 w/(z0 E*); range: z0; typical_radius: contact radius at which y is of order one.
  dugdale_branch(const basic_pair<S>& pair, const number& strain, const length& range, const length& typical_radius)
      : body_(pair.reduced_radius), range_(range), strain_(strain) {
    disc_at_touch_ = ring(number(0)).cohesive_radius;
    disc_at_fold_ = number(2) / pi<number>() * strain_ * body_;
    // As in the limits of long and of short range, where q is a/c and sqrt(strain a/(pi z0)).
    q_unit_ =
        number(typical_radius / disc_at_touch_) + sqrt(number(strain_ * typical_radius / (pi<number>() * range_)));
    first_ = y_at(-range_);
    fold_ = folds_in_contact() ? number(q_of_fold()) / q_unit_ : y_of(disc_at_fold_);
  }

  /// `touching` says which of both sides of y = 0 is meant, or continued beyond it.
  point at(const number& y, bool touching) const {
    return touching ? ring(q_unit_ * y) : disc(disc_at_touch_ * (number(1) + y));
  }

  /// Where the surfaces jump together, approach -z0, and where they jump apart; the latter without derivatives, on
  /// which nothing depends to first order, since approach is least there.
  const number& first() const { return first_; }
  const number& fold() const { return fold_; }

  /// y of the stable equilibrium at this approach. \pre it is not below the fold's
  number y_at(const length& approach) const {
    if (stable_before_touch(approach))
      return y_of_disc(approach);
    number y = number(root([&](const real& q) { return in_units(ring(number(q)).approach - approach); },
                           folds_in_contact() ? q_of_fold() : real(0))) /
               q_unit_;
    if constexpr (!std::same_as<number, real>) { // derivatives, by a step of Newton's method
      const point near = at(y, true);
      y -= number((near.approach - approach) / near.slope);
    }
    return y;
  }

  /// Contact of a ring-shaped zone, q >= 0.
  point ring(const number& q) const {
    const number t = atan2(number(1), q), sine = number(1) / sqrt(number(1) + q * q), cosine = q * sine;
    const length c = ring_radius(t, sine, cosine), a = c * cosine;
    return {a * a / body_ - strain_ * sine * c, a, c, t, q_unit_ * sine * sine * cosine * steepness(q)};
  }

private:
  using real = real_of<number>;

  point disc(const length& c) const {
    const length slope = disc_at_touch_ * number((c - disc_at_fold_) / body_);
    return {c * c / (number(2) * body_) - disc_at_fold_ * c / body_ - range_, length{}, c, pi<number>() / number(2),
            slope};
  }

  /// The gap at c is z0: (g/2R) c^2 + strain b c = pi z0/2.
  length ring_radius(const number& t, const number& sine, const number& cosine) const {
    const number bent = strain_ * b(t), range = number(range_ / body_);
    return pi<number>() * range_ / (bent + sqrt(bent * bent + pi<number>() * range * g(t, sine, cosine)));
  }
  /// sin t cos t - t cos 2t
  static number g(const number& t, const number& sine, const number& cosine) {
    return number(2) * t * sine * sine -
           excess_over_sine(number(number(2) * t), number(number(2) * sine * cosine)) / number(2);
  }
  /// t sin t - 1 + cos t
  static number b(const number& t) {
    const number half = t / number(2), s = sin(half);
    return number(2) * s * (t * cos(half) - s);
  }

  /// -d(approach)/dt over cos t.
  length steepness(const number& q) const {
    const number t = atan2(number(1), q), sine = number(1) / sqrt(number(1) + q * q), cosine = q * sine;
    const length c = ring_radius(t, sine, cosine);
    const number wide = number(c / body_);
    const length shrinking = c * t * (number(2) * wide * sine + strain_) / // -(dc/dt)/cos t
                             (wide * g(t, sine, cosine) + strain_ * b(t));
    return number(2) * wide * (shrinking * cosine * cosine + c * sine) - strain_ * (shrinking * sine - c);
  }

  bool folds_in_contact() const { return disc_at_fold_ > disc_at_touch_; }
  bool stable_before_touch(const length& approach) const {
    return !folds_in_contact() && approach < ring(number(0)).approach;
  }
  real q_of_fold() const {
    return root([&](const real& q) { return in_units(steepness(number(q))); }, real(0));
  }

  /// y of the stable disc at this approach.
  number y_of_disc(const length& approach) const {
    const number wide = number(disc_at_fold_ / body_), above = number((approach + range_) / body_);
    return y_of(body_ * (wide + sqrt(max(number(wide * wide + number(2) * above), number(0)))));
  }
  number y_of(const length& disc) const { return number((disc - disc_at_touch_) / disc_at_touch_); }

  real in_units(const length& x) const { return value_of(number(x / body_)); }

  /// Where f, which rises through zero above `low`, does so.
  template <class Function>
  static real root(const Function& f, real low) {
    if (!(f(low) < real(0)))
      return low;
    real high = max(2 * low, real(1));
    for (; f(high) < real(0); high *= 2)
      low = high;
    std::uintmax_t rounds = 200;
    const auto found =
        boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<real>(), rounds);
    return (found.first + found.second) / 2;
  }

  length body_{}, range_{}, disc_at_touch_{}, disc_at_fold_{};
  number strain_{}, q_unit_{}, first_{}, fold_{};
};

} // namespace ricochet
