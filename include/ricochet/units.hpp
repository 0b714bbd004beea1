// The only Boost.Units header: quantities at the door, and the two number systems in which a law can be read.
#pragma once
#include <ricochet/number.hpp>

#include <boost/units/get_dimension.hpp>
#include <boost/units/pow.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/systems/si/dimensionless.hpp>
#include <boost/units/systems/si/energy.hpp>
#include <boost/units/systems/si/force.hpp>
#include <boost/units/systems/si/length.hpp>
#include <boost/units/systems/si/mass.hpp>
#include <boost/units/systems/si/mass_density.hpp>
#include <boost/units/systems/si/momentum.hpp>
#include <boost/units/systems/si/pressure.hpp>
#include <boost/units/systems/si/surface_tension.hpp>
#include <boost/units/systems/si/time.hpp>
#include <boost/units/systems/si/velocity.hpp>

namespace ricochet {

namespace si = boost::units::si;

using length = boost::units::quantity<si::length>;
using duration = boost::units::quantity<si::time>;
using mass = boost::units::quantity<si::mass>;
using density = boost::units::quantity<si::mass_density>;
using modulus = boost::units::quantity<si::pressure>;
using speed = boost::units::quantity<si::velocity>;
using force = boost::units::quantity<si::force>;
using energy = boost::units::quantity<si::energy>;
using momentum = boost::units::quantity<si::momentum>;
using energy_per_area = boost::units::quantity<si::surface_tension>;
using inverse_speed = boost::units::quantity<boost::units::divide_typeof_helper<si::dimensionless, si::velocity>::type>;
using damping = boost::units::divide_typeof_helper<force, speed>::type;
using angular_speed = boost::units::divide_typeof_helper<speed, length>::type; ///< radians are plain numbers
using root_length = boost::units::root_typeof_helper<length, boost::units::static_rational<2>>::type;

/// Units to multiply numbers with: `2.0 * micrometres`, `8.0 * metres_per_second`.
namespace units {
inline constexpr length metres = 1.0 * si::meter;
inline constexpr length millimetres = 1e-3 * si::meter;
inline constexpr length micrometres = 1e-6 * si::meter;
inline constexpr length nanometres = 1e-9 * si::meter;
inline constexpr duration seconds = 1.0 * si::second;
inline constexpr mass kilograms = 1.0 * si::kilogram;
inline constexpr density kilograms_per_cubic_metre = 1.0 * si::kilogram_per_cubic_meter;
inline constexpr modulus pascals = 1.0 * si::pascal;
inline constexpr modulus megapascals = 1e6 * si::pascal;
inline constexpr modulus gigapascals = 1e9 * si::pascal;
inline constexpr speed metres_per_second = 1.0 * si::meter_per_second;
inline constexpr speed millimetres_per_second = 1e-3 * si::meter_per_second;
inline constexpr angular_speed radians_per_second = 1.0 / (1.0 * si::second);
inline constexpr double degrees = std::numbers::pi / 180; ///< radians are plain numbers
inline constexpr force newtons = 1.0 * si::newton;
inline constexpr energy joules = 1.0 * si::joule;
inline constexpr energy newton_metres = 1.0 * si::joule; ///< of moments
inline constexpr energy_per_area joules_per_square_metre = 1.0 * si::newton_per_meter;
inline constexpr energy_per_area newtons_per_metre = 1.0 * si::newton_per_meter;
inline constexpr inverse_speed seconds_per_metre = 1.0 / (1.0 * si::meter_per_second);

/// Whole numbers count too: `2 * micrometres`.
template <class Unit>
constexpr auto operator*(int n, const boost::units::quantity<Unit>& unit) {
  return static_cast<double>(n) * unit;
}
} // namespace units

/// Number system of the door: Boost.Units quantities, so that a wrong exponent does not compile.
struct dimensional {
  using number = double;
  using length = ricochet::length;
  using root_length = ricochet::root_length;
  using duration = ricochet::duration;
  using mass = ricochet::mass;
  using modulus = ricochet::modulus;
  using speed = ricochet::speed;
  using force = ricochet::force;
  using energy = ricochet::energy;
  using energy_per_area = ricochet::energy_per_area;
  using inverse_speed = ricochet::inverse_speed;
  using damping = ricochet::damping;
};

/// Number system of the loop: every quantity is a plain T, measured in the scales of the collision.
template <class T>
struct reduced {
  using number = T;
  using length = T;
  using root_length = T;
  using duration = T;
  using mass = T;
  using modulus = T;
  using speed = T;
  using force = T;
  using energy = T;
  using energy_per_area = T;
  using inverse_speed = T;
  using damping = T;
};

template <class Unit>
constexpr auto sqrt(const boost::units::quantity<Unit>& q) {
  return boost::units::root<2>(q);
}
template <class Unit>
constexpr auto abs(const boost::units::quantity<Unit>& q) {
  return q < boost::units::quantity<Unit>() ? -q : q;
}
template <class Unit>
constexpr auto cube_root(const boost::units::quantity<Unit>& q) {
  return boost::units::root<3>(q);
}

/// SI value of a quantity, and its unit's symbol for messages.
template <class Unit>
constexpr double in_si(const boost::units::quantity<Unit>& q) {
  return q.value();
}
constexpr double in_si(double x) { return x; }

/// Exponents of length, mass and time in a quantity's dimension.
struct exponents {
  double length = 0, mass = 0, time = 0;
};

namespace detail {
template <class Dimension>
constexpr exponents exponents_of_dimension() {
  if constexpr (std::same_as<Dimension, boost::units::dimensionless_type>) {
    return {};
  } else {
    exponents e = exponents_of_dimension<typename Dimension::next>();
    using base = typename Dimension::item::tag_type;
    using power = typename Dimension::item::value_type;
    const double p = static_cast<double>(power::Numerator) / static_cast<double>(power::Denominator);
    if constexpr (std::same_as<base, boost::units::length_base_dimension>)
      e.length = p;
    else if constexpr (std::same_as<base, boost::units::mass_base_dimension>)
      e.mass = p;
    else if constexpr (std::same_as<base, boost::units::time_base_dimension>)
      e.time = p;
    else
      static_assert(std::same_as<base, void>, "ricochet's quantities are made of length, mass and time only");
    return e;
  }
}
} // namespace detail

template <class Unit>
constexpr exponents exponents_of(const boost::units::quantity<Unit>&) {
  return detail::exponents_of_dimension<typename boost::units::get_dimension<Unit>::type>();
}
constexpr exponents exponents_of(double) { return {}; }

constexpr const char* unit_symbol(double) { return ""; }
constexpr const char* unit_symbol(length) { return "m"; }
constexpr const char* unit_symbol(duration) { return "s"; }
constexpr const char* unit_symbol(mass) { return "kg"; }
constexpr const char* unit_symbol(density) { return "kg/m^3"; }
constexpr const char* unit_symbol(modulus) { return "Pa"; }
constexpr const char* unit_symbol(speed) { return "m/s"; }
constexpr const char* unit_symbol(force) { return "N"; }
constexpr const char* unit_symbol(energy) { return "J"; }
constexpr const char* unit_symbol(energy_per_area) { return "J/m^2"; }
constexpr const char* unit_symbol(inverse_speed) { return "s/m"; }
constexpr const char* unit_symbol(damping) { return "N s/m"; }
constexpr const char* unit_symbol(momentum) { return "N s"; }
constexpr const char* unit_symbol(angular_speed) { return "rad/s"; }
template <class Unit>
constexpr const char* unit_symbol(const boost::units::quantity<Unit>&) {
  return "(SI)";
}

} // namespace ricochet
