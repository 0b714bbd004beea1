#pragma once
#include <ricochet/model/requests.hpp>
#include <ricochet/units.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet {

/// How a collision ended.
enum class ending {
  separated,  ///< the bodies fly apart
  captured,   ///< certified: what energy is left can never separate them
  unresolved, ///< the budget of evaluations was spent before the contact ended or was certified
  failed      ///< the solver could not go on; see reason
};

constexpr const char* name_of(ending e) {
  switch (e) {
  case ending::separated:
    return "separated";
  case ending::captured:
    return "captured";
  case ending::unresolved:
    return "unresolved";
  default:
    return "failed";
  }
}

/// What every collision has.
template <class T>
struct ending_result {
  ricochet::ending ending = ricochet::ending::failed;
  std::optional<T> restitution;  ///< of the final separation; absent when the bodies did not separate
  bool ending_is_certain = true; ///< false so near a threshold that the error bound does not decide
  double error_estimate = 0;     ///< bound of the error of the restitution
  int contacts = 1;
  long evaluations = 0;    ///< of the equations of motion, all solutions together
  long rejected_steps = 0; ///< likewise
  std::string reason;      ///< of an ending that is unresolved or failed
};

/// Losses in units of the initial kinetic energy, jumps included; largest |energy| met sets the residual's scale.
template <class T>
struct ledger_result {
  T crack_loss{};       ///< lost at the contact's edge; of a static edge its jumps
  T bulk_loss{};        ///< lost in the bulk, with what relaxes after separation
  T remaining_energy{}; ///< kinetic + elastic + surface energy at the end
  T ledger_residual{};  ///< (initial energy - remaining - losses)/largest energy met
};

template <class Duration>
struct duration_result {
  Duration contact_duration{}; ///< first touch to final loss of contact, flights included; so far, if not separated
};

/// Largest values in all contacts of the collision; when captured, up to the certificate.
template <class Length, class Force>
struct extremes_result {
  Length max_approach{};
  Length max_contact_radius{};
  Force max_tension{};     ///< of the total force, elastic and damping
  Force max_compression{}; ///< likewise
};

/// Of a model with a tangential law: the sliding of the contact point at the ending; oblique.hpp has what follows for
/// the bodies.
template <class Speed, class Length, class Duration>
struct sliding_result {
  Speed slip{};                   ///< speed at which it still slides; < 0 backwards, as an elastic contact may
  bool sticks = false;            ///< somewhere in the contact; where it is Coulomb's, all of it: it rolls
  double slip_error_estimate = 0; ///< bound of its error, in units of the slip at first touch; of a
                                  ///< model with a peeling moment also of the turning's, of the larger speed
  Length slip_distance{};         ///< over which it has moved, signed likewise
  Duration elapsed_time{};        ///< since first touch
  Speed approach_rate{};          ///< of the bodies, < 0 when they separate
};

/// Of a model with a peeling moment: the turning of the sphere, > 0 where it would roll along the first slip.
template <class T, class AngularSpeed>
struct rolling_result {
  AngularSpeed spin{}; ///< at the ending
  T rotation{};        ///< angle turned since first touch, rad
  T friction_loss{};   ///< in units of the initial kinetic energy along the normal
  T peeling_loss{};    ///< likewise
};

/// Of a model with a flowing law.
template <class T, class Length>
struct flow_result {
  T plastic_loss{};           ///< in units of the initial kinetic energy
  Length residual_approach{}; ///< by which the bodies have been flattened; 0 if they have not yielded
};

template <class Column>
struct trajectory_columns {
  Column time, mutual_approach, approach_rate, contact_radius, elastic_force, damping_force, kinetic_energy,
      elastic_energy, surface_energy, crack_loss, bulk_loss;
};

template <class Column>
struct flowing_trajectory_columns : trajectory_columns<Column> {
  Column plastic_loss; ///< likewise
};

namespace detail {
template <bool Flows, class Column>
using columns_of = std::conditional_t<Flows, flowing_trajectory_columns<Column>, trajectory_columns<Column>>;
}

/// The motion, one row a state; in SI units once it leaves collide(). crack_loss and bulk_loss (J, up to the row, jumps
/// included, so that the energies add up to that of the impact) are filled where the ledger was asked for too, and so
/// is plastic_loss where the motion has one.
template <bool Flows>
struct trajectory_result {
  detail::columns_of<Flows, std::vector<double>> trajectory;
};

/// One sentence for each law used outside its range.
struct warnings_result {
  std::vector<std::string> warnings;
};

namespace detail {
template <int>
struct nothing {};
template <bool Wanted, class Part, int Place>
using part = std::conditional_t<Wanted, Part, nothing<Place>>;
} // namespace detail

/// What came out of a collision. The parts that were not asked for in compose() are not there.
template <class T, class Length, class Duration, class Force, class Speed, requests Asked, bool Friction = false,
          bool Flows = false, bool Peels = false, class AngularSpeed = T>
struct basic_outcome : ending_result<T>,
                       detail::part<Asked.ledger, ledger_result<T>, 0>,
                       detail::part<Asked.duration, duration_result<Duration>, 1>,
                       detail::part<Asked.extremes, extremes_result<Length, Force>, 2>,
                       detail::part<Asked.trajectory, trajectory_result<Flows>, 3>,
                       detail::part<Friction, sliding_result<Speed, Length, Duration>, 4>,
                       detail::part<Flows, flow_result<T, Length>, 5>,
                       detail::part<Asked.warnings, warnings_result, 6>,
                       detail::part<Peels, rolling_result<T, AngularSpeed>, 7> {};

/// Of a model with a plasticity law: what plastic flow took is in the restitution and in the remaining energy; all else
/// is of the elastic motion.
template <class Elastic>
struct plastic_outcome : Elastic {
  double plastic_loss = 0; ///< in units of the initial kinetic energy

  plastic_outcome() = default;
  explicit plastic_outcome(const Elastic& elastic) : Elastic(elastic) {}
};

/// The outcome that a contact model gives, in SI units; and on the numbers T of its reduced form.
template <class Model>
using elastic_outcome_of = basic_outcome<double, length, duration, force, speed, Model::asked, Model::has_friction,
                                         Model::flows, Model::peels, angular_speed>;
template <class Model>
using outcome_of =
    std::conditional_t<Model::yields, plastic_outcome<elastic_outcome_of<Model>>, elastic_outcome_of<Model>>;
template <class T, class Model>
using reduced_outcome_of = basic_outcome<T, T, T, T, T, Model::asked, Model::has_friction, Model::flows, Model::peels>;

} // namespace ricochet
