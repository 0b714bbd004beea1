// The nominal half of a law: what its author meant it to be. The structural half is the concept of its role.
#pragma once
#include <ricochet/body/scales.hpp>
#include <ricochet/model/configuration.hpp>

#include <tuple>

namespace ricochet {

namespace role {
struct elastic {};
struct adhesion {};
struct crack {};
struct damping {};
struct tangential {};
struct plasticity {};
struct end {};     ///< where a contact without adhesion lets go
struct request {}; ///< what the outcome shall report beyond ending and restitution
} // namespace role

/// Stands where a scene has no law of this role.
template <class Role>
struct absent {
  using role = Role;
  template <class S>
  using in = absent;
  static constexpr auto parameters() { return std::tuple{}; }
};

template <class L>
concept has_role = requires {
  typename L::role;
};

/// What every law offers: its form in another number system, and its parameters.
template <class L>
concept any_law = has_role<L> && requires {
  typename L::template in<reduced<double>>;
  L::parameters();
};

template <class L, class Role>
concept plays = has_role<L> && std::same_as<typename L::role, Role>;

template <class L>
inline constexpr bool is_present = !std::same_as<L, absent<typename L::role>>;

/// A law that works in formulas with sqrt(a) says so; the model then keeps sqrt(a) as its coordinate.
template <class L>
inline constexpr bool needs_root_radius = requires {
  requires L::uses_root_radius;
};

/// f(parameter of `to`, parameter of `from`) for every parameter of one law in two number systems.
template <class To, class From, class Function>
void for_each_parameter(To& to, const From& from, const Function& f) {
  const auto here = To::parameters();
  const auto there = From::parameters();
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (f(to.*(std::get<I>(here).member), from.*(std::get<I>(there).member)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(here)>>{});
}

/// The same law in another number system, every parameter passed through `convert`.
template <class NumberSystem, class Law, class Convert>
auto rebind_law(const Law& law, const Convert& convert) {
  typename Law::template in<NumberSystem> result{};
  for_each_parameter(result, law, [&](auto& to, const auto& from) { to = convert(from); });
  if constexpr (requires { result.table = law.table; })
    result.table = law.table;
  return result;
}

/// \throws bad_input naming the first parameter outside its range.
template <class Law>
void validate_law(const Law& law) {
  std::apply([&](const auto&... p) { (require(p.name, law.*(p.member), p.allowed), ...); }, Law::parameters());
}

} // namespace ricochet
