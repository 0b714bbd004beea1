#pragma once
#include <ricochet/law/crack/crack_velocity_law.hpp>
#include <ricochet/model/surface_laws.hpp>

namespace ricochet {

/// The equations of motion of a contact model, on plain numbers T in the scales of a collision, in the coordinate and
/// the slowed time in which they are smooth.
///
/// Edge slaved to the approach: the coordinate is y = a, or sqrt(a) where a law needs that, and dt = (d delta/dy) d
/// sigma; so y' = rate, and the fold of JKR or the touch of Hertz are ordinary crossings. Free edge (crack law): the
/// unknowns are delta, rate and y = sqrt(a), with sqrt(beta) = (y^4/R - delta)/(c y), and dt = d sigma/sqrt(1 +
/// (dy/dt)^2/ref^2), finite where the edge's speed is not.
/// Plastic flow: the contact has a shape, that of the largest y so far.
template <class T, class Model>
class reduced_model : public surface_laws<T, Model> {
  using laws = surface_laws<T, Model>;
  using laws::branch_;
  using laws::flattening_;
  using laws::yield_coordinate_;

public:
  using laws::adhesion;
  using laws::adhesive;
  using laws::attracted;
  using laws::cohesive;
  using laws::coordinate;
  using laws::crack;
  using laws::damped;
  using laws::elastic;
  using laws::flows;
  using laws::free_edge;
  using laws::pair;
  using laws::pair_of;
  using laws::plasticity;
  using laws::root_coordinate;
  using laws::slides;
  using typename laws::coordinate_t;
  using typename laws::part;
  static constexpr bool keeps_time = Model::asked.duration || Model::asked.trajectory || Model::has_friction;

  using unknowns = join<variables<coordinate_t, approach_rate_t>, optionally<mutual_approach_t, free_edge>,
                        optionally<elapsed_time_t, keeps_time>, optionally<bulk_loss_t, Model::asked.ledger && damped>,
                        optionally<crack_loss_t, Model::asked.ledger && (free_edge || laws::opposes_rebound)>,
                        std::conditional_t<flows, variables<largest_coordinate_t, plastic_loss_t>, variables<>>,
                        typename laws::surface_unknowns>;
  using state_type = state<T, unknowns>;

  reduced_model(const Model& model, const scales& unit)
      : laws(model, [&unit](const auto& quantity) { return reduce<T>(quantity, unit); }) {
    prepare();
  }

  explicit reduced_model(const reduced_laws<T, Model>& in_scales) : laws(in_scales) { prepare(); }

  /// The same numbers in another scalar type.
  template <class Other>
  explicit reduced_model(const reduced_model<Other, Model>& numbers)
      : laws(numbers, [](const Other& x) { return T(x); }) {
    prepare();
  }

  /// Recomputes what is constant during a collision; to be called after a law's parameter was changed.
  void prepare() {
    this->prepare_contact();
    if constexpr (free_edge) {
      reference_ = sqrt(sqrt(pair.reduced_radius)) / T(2);
      edge_speed_ = crack.speed_scale(pair, adhesion.work_of_adhesion) / (T(2) * reference_);
      per_flattening_ = T(1) / flattening_;
    }
  }

  using instant = contact_instant<T, part>;

  /// `piece` of the crack law to be used, or sliding(j) while the edge is held at joint j, where the law jumps and
  /// both sides of the jump push beta back to it; of a flowing law 1 while it flows, else 0; with a cohesive zone 1
  /// while the surfaces touch, else 0. `least_clock`: see flow.
  template <class Piece>
  instant at(const state_type& x, const Piece& piece, [[maybe_unused]] real_of<T> least_clock = 0) const {
    instant now{};
    now.inside = true;
    if constexpr (cohesive) {
      now.clock = laws::place(now.c, x[coordinate], piece == 1);
      now.c.rate = now.coordinate_rate = x[approach_rate];
      now.inside = value_of(now.c.cohesive_radius) > 0 && value_of(now.c.radius) > -value_of(now.c.cohesive_radius) / 2;
    } else {
      now.c = contact(x, piece);
      if constexpr (free_edge)
        move_free_edge(now, x, piece, least_clock);
      else
        move_static_edge(now, x, piece);
    }
    return now;
  }

  /// The contact without its motion.
  template <class Piece>
  part contact(const state_type& x, [[maybe_unused]] const Piece& piece) const {
    part c{};
    const T& y = x[coordinate];
    c.rate = x[approach_rate];
    if constexpr (cohesive) {
      laws::place(c, y, piece == 1);
      return c;
    }
    c.radius = laws::radius_at(y);
    if constexpr (root_coordinate)
      c.root_radius = y;
    else // no law has declared that it uses it: who does all the same, shall notice
      c.root_radius = T(std::numeric_limits<real_of<T>>::quiet_NaN());
    if constexpr (flows)
      c.take(pair, this->shape_at(piece == 0 ? x[largest_coordinate] : y));
    if constexpr (free_edge)
      c.approach = x[mutual_approach];
    else
      c.approach = elastic.load_free_approach(pair_of(c), c.radius);
    if constexpr (adhesive && !free_edge)
      c.approach -= flattening_ * y;
    return c;
  }

  /// The `piece` of an edge held at joint j.
  static constexpr int sliding(int joint) { return -1 - joint; }

  /// The piece of the crack law in which this sqrt(beta) lies, if only the joint at beta = 1 is between it and `piece`.
  static int side_of_rest(const T& ratio, int piece) requires free_edge {
    constexpr auto& joints = decltype(Model::crack)::joints;
    const std::size_t i = std::size_t(piece);
    if (i < joints.size() && joints[i] == 1 && value_of(ratio) > 1)
      return piece + 1;
    return i > 0 && joints[i - 1] == 1 && value_of(ratio) < 1 ? piece - 1 : piece;
  }

  /// sqrt(beta) of a free edge, without its law.
  T root_ratio(const state_type& x) const requires free_edge { return opened(x) / x[coordinate]; }

  /// The approach at which a free edge of this coordinate has this sqrt(beta).
  T approach_at(const T& y, const T& ratio) const requires free_edge {
    return elastic.load_free_approach(pair, T(y * y)) - flattening_ * ratio * y;
  }

  /// d(delta)/dy of a free edge at constant beta.
  T approach_gradient(const state_type& x) const requires free_edge {
    const T& y = x[coordinate];
    return elastic.load_free_slope(pair, T(y * y)) * T(2) * y - flattening_ * root_ratio(x);
  }

  /// d(sqrt beta)/d(sigma), by the law of this piece.
  T root_ratio_rate(const state_type& x, int piece) const requires free_edge {
    const instant now = at(x, piece);
    return root_ratio_change(x, now.coordinate_rate, now.c.rate * now.clock);
  }

  /// Its like for a given dx/d(sigma).
  T root_ratio_slope(const state_type& x, const state_type& dx) const requires free_edge {
    return root_ratio_change(x, dx[coordinate], dx[mutual_approach]);
  }

  /// By how much an edge that the bodies move at a constant sqrt(beta) is faster than its law has it at this one, times
  /// d(delta)/dy.
  T speed_beyond_law(const state_type& x, const T& ratio, int piece) const requires free_edge {
    const auto edge = crack.rate(ratio, piece);
    return x[approach_rate] -
           approach_gradient(x) * reference_ * edge_speed_ * edge.advance / (edge.slowness * x[coordinate]);
  }

  /// dx/d(sigma); false outside the domain: there the law runs on a little, beyond which nothing moves. `direction` in
  /// which the contact point slides, 0 while it rolls.
  template <class Piece>
  truth_of<T> derivative(const state_type& x, state_type& dx, const Piece& piece, [[maybe_unused]] int direction = 0,
                         real_of<T> least_clock = 0) const {
    const instant now = at(x, piece, least_clock);
    dx[coordinate] = now.coordinate_rate;
    dx[approach_rate] = -this->total_force(now.c) * now.clock / pair.reduced_mass;
    if constexpr (free_edge)
      dx[mutual_approach] = now.c.rate * now.clock;
    if constexpr (keeps_time)
      dx[elapsed_time] = now.clock;
    if constexpr (Model::asked.ledger && damped)
      dx[bulk_loss] = this->damping_force(now.c) * now.c.rate * now.clock;
    if constexpr (Model::asked.ledger && free_edge) { // [K (C.2)] with da = 2y dy, finite at y = 0 too
      const T& y = x[coordinate];
      const T open = opened(x);
      dx[crack_loss] = T(4) * pi<T>() * adhesion.work_of_adhesion * (y - open) * (y + open) * y * now.coordinate_rate;
    }
    if constexpr (flows) {
      dx[largest_coordinate] = piece == 0 ? T(0) : now.coordinate_rate;
      dx[plastic_loss] =
          piece == 0 ? T(0) : T(this->plastic_loss_per_growth(now.c, x[coordinate]) * now.coordinate_rate);
    }
    if constexpr (slides)
      laws::slide(now.c, x, dx, now.clock, direction);
    if constexpr (Model::asked.ledger && laws::opposes_rebound)
      dx[crack_loss] = this->rebound_force(now.c) * now.c.rate * now.clock;
    return now.inside;
  }

  /// The piece with which a contact begins.
  int first_piece() const {
    if constexpr (cohesive)
      return value_of(branch_.first()) > 0 ? 1 : 0;
    else
      return 0;
  }

  /// The contact at first touch, or first pull, at this speed; quadratures at zero.
  state_type touch(const T& speed) const {
    state_type x{};
    for (auto& component : x)
      component = T(0);
    x[approach_rate] = speed;
    if constexpr (free_edge)
      x[coordinate] = sqrt(T(adhesion.touch_radius(pair) * cube_root(crack.first_ratio())));
    else if constexpr (adhesive)
      x[coordinate] = sqrt(adhesion.touch_radius(pair));
    if constexpr (flows)
      x[largest_coordinate] = yield_coordinate_;
    if constexpr (cohesive)
      x[coordinate] = branch_.first();
    return x;
  }

  /// Coordinate at the fold of the static branch, where a slaved adhesive edge lets go.
  T fold_coordinate() const requires(adhesive || cohesive) {
    if constexpr (cohesive)
      return branch_.fold();
    else
      return sqrt(adhesion.fold_radius(pair));
  }

  /// Past the fold an edge that runs at its limit lets go; before it, the edge slides along the branch.
  truth_of<T> past_fold(const configuration<reduced<T>>& c) const {
    return value_of(c.approach) < -3 * value_of(elastic.load_free_approach(pair, c.radius));
  }

  /// Size of the unknowns in a collision: the measure of their errors.
  state_type typical() const {
    state_type x{};
    for (auto& component : x)
      component = T(1);
    if constexpr (!cohesive)
      x[coordinate] = sqrt(pair.reduced_radius);
    if constexpr (root_coordinate)
      x[coordinate] = sqrt(x[coordinate]);
    if constexpr (flows)
      x[largest_coordinate] = x[coordinate];
    return x;
  }

  /// Slowed time in which the coordinate changes by its own size: the measure of steps.
  real_of<T> typical_time() const { return free_edge ? real_of<T>(1) : real_of<T>(value_of(typical()[coordinate])); }

private:
  template <class Piece>
  void move_free_edge(instant& now, const state_type& x, const Piece& piece,
                      [[maybe_unused]] real_of<T> least_clock) const {
    const T& y = x[coordinate];
    now.root_ratio = root_ratio(x);
    edge_rate<T> edge{};
    T advance; // y dy/dt times the slowness, over the reference
    if constexpr (is_many<T>) {
      edge = crack.rate(now.root_ratio, piece);
      advance = edge_speed_ * edge.advance;
      now.inside = (y > T(0)) & (now.root_ratio > T(0)) & ((edge.slowness >= T(0)) | past_fold(now.c));
    } else {
      now.inside = value_of(y) > 0 ? value_of(now.root_ratio) > 0 : closes_up(now.c, piece);
      if (!now.inside)
        return;
      if (piece >= 0) {
        const int here = least_clock > 0 ? side_of_rest(now.root_ratio, piece) : piece;
        edge = crack.rate(value_of(y) > 0 ? now.root_ratio : T(-now.root_ratio), here);
        advance = edge_speed_ * edge.advance;
      } else { // at the fold of its branch, time stands still
        edge.slowness = approach_gradient(x) * reference_ / y;
        advance = now.c.rate;
      }
      now.inside = value_of(edge.slowness) >= 0 || past_fold(now.c); // beyond its limit, time would run backwards
    }
    const T delay = edge.slowness * y;
    const T norm = T(1) / sqrt(delay * delay + advance * advance);
    now.slowness = edge.slowness;
    now.clock = delay * norm;
    now.coordinate_rate = reference_ * advance * norm;
    if constexpr (!is_many<T>)
      if (least_clock > 0) {
        now.clock = clock_of_slaved_edge(approach_gradient(x), now.c.rate / reference_, least_clock);
        now.coordinate_rate = reference_ * advance / delay * now.clock;
      }
  }

  template <class Piece>
  void move_static_edge(instant& now, [[maybe_unused]] const state_type& x, [[maybe_unused]] const Piece& piece) const {
    const basic_pair<reduced<T>>* moving = &pair;
    if constexpr (flows)
      if (piece == 0)
        moving = &pair_of(now.c);
    now.clock = elastic.load_free_slope(*moving, now.c.radius);
    if constexpr (root_coordinate)
      now.clock *= T(2) * x[coordinate];
    if constexpr (adhesive) {
      now.clock -= flattening_;
      now.root_ratio = T(1);
    }
    now.coordinate_rate = now.c.rate;
  }

  /// dt/d(sigma) as it is where the edge keeps to the motion of the bodies, dy/dt = rate/(d delta/dy), so that
  /// round-off of a much faster law does not enter; smooth and small behind the fold, where d delta/dy < 0.
  static T clock_of_slaved_edge(const T& gradient, const T& speed, real_of<T> least_clock) {
    const T least = T(least_clock) * speed;
    const T positive = (gradient + sqrt(gradient * gradient + T(4) * least * least)) / T(2);
    return positive / sqrt(positive * positive + speed * speed);
  }

  /// y sqrt(beta)
  T opened(const state_type& x) const {
    const T& y = x[coordinate];
    return (elastic.load_free_approach(pair, T(y * y)) - x[mutual_approach]) * per_flattening_;
  }

  /// Is this a contact of vanishing radius, that a step may lead to beyond y = 0? There the equations are continued as
  /// those of -y.
  static bool closes_up(const configuration<reduced<T>>& c, int piece) {
    if constexpr (opens_without_bound<decltype(Model::crack)>)
      return std::size_t(piece) == decltype(Model::crack)::joints.size() && value_of(c.approach) < 0;
    else
      return false;
  }

  /// d(sqrt beta) for changes of y and delta.
  T root_ratio_change(const state_type& x, const T& of_coordinate, const T& of_approach) const {
    return (approach_gradient(x) * of_coordinate - of_approach) * per_flattening_ / x[coordinate];
  }

  T edge_speed_ = T(0); ///< of y dy/dt, over the reference
  T reference_ = T(1), per_flattening_ = T(0);
};

} // namespace ricochet
