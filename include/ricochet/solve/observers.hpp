#pragma once
#include <ricochet/outcome/outcome.hpp>
#include <ricochet/solve/extremum.hpp>
#include <ricochet/solve/ledger.hpp>

namespace ricochet {

/// Watches a collision step by step for what its model asks beyond the ending: extremes and trajectory. Where neither
/// is asked for, it is empty and does nothing.
template <class Reduced, class Method>
class observers {
  using T = typename Reduced::number;
  using real = real_of<T>;
  using state_type = typename Reduced::state_type;
  using flow_type = flow<Reduced>;
  static constexpr requests asked = Reduced::model_type::asked;

  static real radius(const Reduced& model, const state_type& x, int piece) {
    return value_of(model.contact(x, piece).radius);
  }
  static real tension(const Reduced& model, const state_type& x, int piece) {
    return -value_of(model.total_force(model.contact(x, piece)));
  }
  static real compression(const Reduced& model, const state_type& x, int piece) { return -tension(model, x, piece); }

  struct largest {
    real (*observable)(const Reduced&, const state_type&, int);
    maximum<real> found{real(0)};
  };
  struct earlier_step { // what is needed to look into it again
    Method method;
    state_type x;
    int piece;
  };
  struct extremes_part {
    T approach = T(0);
    std::array<largest, 3> others{largest{radius}, largest{tension}, largest{compression}};
    std::optional<earlier_step> earlier;
  };
  struct nothing {};

public:
  void touched(const Reduced& model, const ledger<Reduced>& books, const state_type& x) {
    if constexpr (asked.extremes) {
      parts_.earlier.reset();
      for (auto& each : parts_.others)
        each.found.restart(each.observable(model, x, 0));
    }
    if constexpr (asked.trajectory)
      record(model, books, x, 0);
  }

  /// A step of size h has led from x to `reached`.
  void stepped(flow_type& flow, Method& method, const ledger<Reduced>& books, const state_type& x,
               const state_type& reached, const real& h) {
    const Reduced& model = flow.model;
    if constexpr (asked.extremes) {
      for (auto& each : parts_.others) {
        const auto here = [&](const real& t) -> real {
          return each.observable(model, method.within(flow, x, t), flow.piece);
        };
        const auto before = [&](const real& t) -> real {
          auto& [its_method, its_x, its_piece] = *parts_.earlier;
          const int piece_now = std::exchange(flow.piece, its_piece);
          const real value = each.observable(model, its_method.within(flow, its_x, t), its_piece);
          flow.piece = piece_now;
          return value;
        };
        each.found.step(h, each.observable(model, reached, flow.piece), before, here);
      }
      parts_.earlier.emplace(earlier_step{method, x, flow.piece});
    }
    if constexpr (asked.trajectory) {
      constexpr int rows_a_step = 8;
      for (int i = 1; i < rows_a_step; ++i)
        record(model, books, method.within(flow, x, h * i / rows_a_step), flow.piece);
      record(model, books, reached, flow.piece);
    }
  }

  /// The contact has let go: one more row, of the bodies apart.
  void let_go(const Reduced& model, const ledger<Reduced>& books, const state_type& x, int piece) {
    if constexpr (asked.trajectory) {
      auto apart = model.contact(x, piece);
      apart.radius = apart.root_radius = T(0);
      record_row(model, books, x, apart);
    }
  }

  void turned(const Reduced& model, const state_type& x, int piece) {
    if constexpr (asked.extremes) {
      const T approach = model.whole_approach(model.contact(x, piece));
      if (value_of(approach) > value_of(parts_.approach))
        parts_.approach = approach;
    }
  }

  template <class Outcome>
  void report(Outcome& out) {
    if constexpr (asked.extremes) {
      out.max_approach = parts_.approach;
      out.max_contact_radius = T(parts_.others[0].found.value());
      out.max_tension = T(parts_.others[1].found.value());
      out.max_compression = T(parts_.others[2].found.value());
    }
    if constexpr (asked.trajectory)
      out.trajectory = std::move(rows_);
  }

private:
  void record(const Reduced& model, const ledger<Reduced>& books, const state_type& x, int piece) {
    record_row(model, books, x, model.contact(x, piece));
  }

  void record_row(const Reduced& model, const ledger<Reduced>& books, const state_type& x,
                  const typename Reduced::part& c) {
    const auto put = [](std::vector<double>& column, const T& value) {
      column.push_back(static_cast<double>(value_of(value)));
    };
    const bool touching = value_of(c.radius) > real(0);
    put(rows_.time, x[elapsed_time]);
    put(rows_.mutual_approach, model.whole_approach(c));
    put(rows_.approach_rate, c.rate);
    put(rows_.contact_radius, c.radius);
    put(rows_.elastic_force, model.static_force(c));
    put(rows_.damping_force, touching ? T(model.damping_force(c) + model.rebound_force(c)) : T(0));
    put(rows_.kinetic_energy, model.kinetic_energy(c.rate));
    put(rows_.elastic_energy, model.elastic.stored_energy(model.pair_of(c), c));
    put(rows_.surface_energy, model.surface_energy(c));
    if constexpr (asked.ledger) {
      put(rows_.crack_loss, books.crack_loss_at(x));
      put(rows_.bulk_loss, books.bulk_loss_at(x));
      if constexpr (Reduced::flows)
        put(rows_.plastic_loss, books.plastic_loss_at(x));
    }
  }

  [[no_unique_address]] std::conditional_t<asked.extremes, extremes_part, nothing> parts_;
  [[no_unique_address]] std::conditional_t<asked.trajectory, detail::columns_of<Reduced::flows, std::vector<double>>,
                                           detail::nothing<9>>
      rows_;
};

} // namespace ricochet
