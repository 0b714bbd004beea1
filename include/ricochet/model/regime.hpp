// In which regime an impact lies, and whether the laws composed are made for it.
#pragma once
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/regime.hpp>
#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/model/contact_model.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet {

/// The dimensionless numbers that say which laws an impact calls for. Absent: the model or the question does not have
/// it.
struct regime_report {
  bool uses_jkr = false, uses_dmt = false;
  double speed_over_sound = 0;              ///< of the impact over sqrt(E*/density) of the softer-sounding body
  double strain = 0;                        ///< largest contact radius without adhesion and losses, over R
  std::optional<double> tabor_number;       ///< JKR above 5, DMT below 0.1
  std::optional<double> speed_over_capture; ///< over the sticking speed of JKR without other losses
  std::optional<double> speed_over_yield;   ///< over the yield speed of the model's plasticity law
  std::optional<double> bulk_loss_scale;    ///< T_vis over its quasi-static limit for the bulk [Krijt 2013 (A.2)]
  std::optional<double> edge_loss_scale;    ///< T_vis over its quasi-static limit for the edge [Krijt 2013 (A.4)]
  std::optional<double> cohesive_zone;      ///< length of the cohesive zone at G = w over that contact radius

  /// One sentence for each law used outside its range; empty if there is none.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    const auto warn = [&](bool when, const char* what, double value, const char* consequence) {
      if (when)
        all.push_back(std::string(what) + " is " + shown(value) + ": " + consequence);
    };
    warn(speed_over_sound > 0.1, "the impact's speed over that of sound", speed_over_sound,
         "above 0.1, waves carry energy away and contact mechanics fails");
    warn(strain > 0.3, "the largest contact radius over R", strain,
         "above 0.3, the bodies are no half-spaces in contact");
    if (tabor_number && uses_jkr)
      warn(*tabor_number < 5, "the Tabor number", *tabor_number,
           *tabor_number < 0.1 ? "below 0.1, dmt describes adhesion and jkr does not"
                               : "between 0.1 and 5, neither jkr nor dmt describes adhesion well; maugis_dugdale does");
    if (tabor_number && uses_dmt)
      warn(*tabor_number > 0.1, "the Tabor number", *tabor_number,
           *tabor_number > 5 ? "above 5, jkr describes adhesion and dmt does not"
                             : "between 0.1 and 5, neither jkr nor dmt describes adhesion well; maugis_dugdale does");
    if (cohesive_zone)
      warn(*cohesive_zone > 0.1, "the cohesive zone over the contact radius", *cohesive_zone,
           "above 0.1, the crack law's short zone is not short");
    if (speed_over_yield)
      warn(*speed_over_yield > 100, "the impact's speed over the yield speed", *speed_over_yield,
           "above 100, plastic flow is not enclosed by elastic material, as the law takes it to be");
    return all;
  }
};

/// \param interaction_range z0 (m), for the Tabor number of a model without a crack law; zero leaves it out.
/// \param poissons_ratio for the bulk's limit; zero leaves it out.
/// \throws bad_input if the speed is not positive, or the pair does not know its bodies (between() makes one that
/// does).
template <class Model>
regime_report regime_of(const Model& model, speed v, length interaction_range = {}, double poissons_ratio = 0) {
  require("speed", v, positive);
  require("interaction_range", interaction_range, non_negative);
  require("poissons_ratio", poissons_ratio, poissons_ratio_range);
  const contact_pair& pair = model.pair;
  require("radius of the first body", pair.bodies.radius_1, positive);
  regime_report r;
  const auto sound = [&](mass m, length radius) {
    const density rho = m / (4 * pi<double>() / 3 * radius * radius * radius);
    return std::sqrt(in_si(pair.reduced_modulus) / in_si(rho));
  };
  double slowest = sound(pair.bodies.mass_1, pair.bodies.radius_1);
  if (!std::isinf(in_si(pair.bodies.radius_2)))
    slowest = std::min(slowest, sound(pair.bodies.mass_2, pair.bodies.radius_2));
  r.speed_over_sound = in_si(v) / slowest;
  const length radius = [&] {
    if constexpr (requires { model.elastic.max_approach(pair, v); })
      return length(sqrt(pair.reduced_radius * model.elastic.max_approach(pair, v)));
    else
      return closed_form::max_contact_radius(pair, v);
  }();
  r.strain = radius / pair.reduced_radius;
  const duration time = closed_form::contact_time(pair, v);

  using adhesion = std::remove_cvref_t<decltype(model.adhesion)>;
  r.uses_jkr = Model::adhesive;
  if constexpr (requires { model.adhesion.work_of_adhesion; }) {
    r.uses_dmt = attraction_law<adhesion>;
    const energy_per_area w = model.adhesion.work_of_adhesion;
    if (in_si(w) > 0) {
      r.speed_over_capture = v / closed_form::sticking_speed(pair, w);
      length z0 = interaction_range;
      if constexpr (requires { model.adhesion.interaction_range; })
        z0 = model.adhesion.interaction_range;
      if constexpr (requires { model.crack.interaction_range; }) {
        z0 = model.crack.interaction_range;
        const duration relaxation = model.crack.relaxation_time;
        r.edge_loss_scale = relaxation / closed_form::quasi_static_edge_limit(pair, w, z0, radius, time);
        if (poissons_ratio > 0)
          r.bulk_loss_scale = relaxation / closed_form::quasi_static_bulk_limit(poissons_ratio, time);
        // pi E* w/(4 sigma_0^2) at beta = 1, sigma_0 = w/z0 [Krijt 2013 after (13)]
        r.cohesive_zone = pi<double>() / 4 * (pair.reduced_modulus * z0 * z0 / w) / radius;
      }
      if (in_si(z0) > 0)
        r.tabor_number = closed_form::tabor_number(pair, w, z0);
    }
  }
  if constexpr (requires { model.plasticity.yield_strength; })
    r.speed_over_yield = v / closed_form::yield_speed(pair, model.plasticity.yield_strength);
  return r;
}

} // namespace ricochet
