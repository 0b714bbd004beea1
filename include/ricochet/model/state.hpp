#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace ricochet {

/// A list of unknowns, by name.
template <class... Names>
struct variables {
  static constexpr std::size_t size = sizeof...(Names);
  template <class Name>
  static constexpr bool contains = (std::same_as<Name, Names> || ...);

  template <class Name>
  static consteval std::size_t index_of() {
    std::size_t i = 0, found = size;
    ((std::same_as<Name, Names> ? void(found = i) : void(), ++i), ...);
    return found;
  }
};

namespace detail {
template <class...>
struct joined;
template <class... A>
struct joined<variables<A...>> {
  using type = variables<A...>;
};
template <class... A, class... B, class... Rest>
struct joined<variables<A...>, variables<B...>, Rest...> : joined<variables<A..., B...>, Rest...> {};
} // namespace detail

/// The lists one after another.
template <class... Lists>
using join = typename detail::joined<variables<>, Lists...>::type;

template <class Name, bool Wanted>
using optionally = std::conditional_t<Wanted, variables<Name>, variables<>>;

// The unknowns that the models of this library have.
inline constexpr struct mutual_approach_t {
} mutual_approach;
inline constexpr struct approach_rate_t {
} approach_rate;
inline constexpr struct contact_radius_t {
} contact_radius;
inline constexpr struct root_contact_radius_t {
} root_contact_radius;
inline constexpr struct cohesive_coordinate_t { ///< that of a cohesive law's branch
} cohesive_coordinate;
inline constexpr struct elapsed_time_t {
} elapsed_time;
inline constexpr struct crack_loss_t {
} crack_loss;
inline constexpr struct bulk_loss_t {
} bulk_loss;
inline constexpr struct plastic_loss_t {
} plastic_loss;
inline constexpr struct largest_coordinate_t { ///< of the contact radius so far, at least that of first yield
} largest_coordinate;
inline constexpr struct slip_t { ///< speed at which the contact point slides
} slip;
inline constexpr struct slip_distance_t {
} slip_distance;
inline constexpr struct surface_speed_t { ///< at which the sphere turns: spin times radius
} surface_speed;
inline constexpr struct surface_distance_t {
} surface_distance;
inline constexpr struct friction_loss_t {
} friction_loss;
inline constexpr struct peeling_loss_t {
} peeling_loss;

/// Packed state, read by name: x[approach_rate]. Works with odeint's steppers (model/odeint.hpp).
template <class T, class Variables>
struct state : std::array<T, Variables::size> {
  using names = Variables;
  using std::array<T, Variables::size>::operator[];

  template <class Name>
  requires std::is_empty_v<Name> T& operator[](Name) {
    check<Name>();
    return this->data()[Variables::template index_of<Name>()];
  }
  template <class Name>
  requires std::is_empty_v<Name>
  const T& operator[](Name) const {
    check<Name>();
    return this->data()[Variables::template index_of<Name>()];
  }

private:
  template <class Name>
  static constexpr void check() {
    static_assert(Variables::template contains<Name>,
                  "this contact model has no such unknown: no law in it needs it and nothing asked for it");
  }
};

} // namespace ricochet
