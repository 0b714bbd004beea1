#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/threshold/threshold_map.hpp>

using namespace support;

namespace {
using place = sought_threshold::place;
const ice_case ice;

std::vector<scene> random_scenes(unsigned seed, int count) {
  scenes source(seed);
  std::vector<scene> all;
  for (int i = 0; i < count; ++i)
    all.push_back(source.next());
  return all;
}

template <class Model>
std::string ending_at(const Model& model, speed v) {
  const auto out = collide(model, impact{v}, {.tolerance = 1e-12});
  return out.ending_is_certain ? name_of(out.ending) : "uncertain";
}

/// The ends of the brackets are what they are called, by collisions as exact as there are.
void are_honest(const auto& family, const std::vector<scene>& points, double width) {
  const auto found = sticking_speeds(family, points, {.relative_width = width});
  std::size_t bracketed = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto model = family(points[i]);
    BOOST_TEST(found[i].reason == "");
    BOOST_TEST(ending_at(model, found[i].below) == "captured");
    if (found[i].at == place::above_fastest)
      continue;
    ++bracketed;
    BOOST_TEST(ending_at(model, found[i].above) == "separated");
    BOOST_TEST(in_si(found[i].above) / in_si(found[i].below) - 1 <= width * 1.0001);
  }
  BOOST_TEST(bracketed > points.size() / 2);
}

/// v_y from the energy that the adhering, elastic contact has at its yield radius and at touch.
speed yield_speed_of_jkr(const contact_pair& pair, const jkr& adhesion, const thornton_ning_contact& flow) {
  const auto model = compose(pair, hertz{}, adhesion);
  const auto energy_at = [&](length a) -> energy {
    const length approach = hertz::load_free_approach(pair, a) - adhesion.flattening(pair) * boost::units::root<2>(a);
    return model.elastic.stored_energy(pair, {approach, speed{}, a, boost::units::root<2>(a)}) +
           adhesion.surface_energy(a);
  };
  const length touch = boost::units::root<3>(2 * pi<double>() * adhesion.work_of_adhesion * pair.reduced_radius *
                                             pair.reduced_radius / pair.reduced_modulus);
  return boost::units::root<2>(
      2.0 * (energy_at(flow.yield_radius(pair, adhesion.flattening(pair))) - energy_at(touch)) / pair.reduced_mass);
}

bool holds(const sought_threshold& found, speed exact) { return found.below < exact && exact < found.above; }
} // namespace

BOOST_AUTO_TEST_CASE(jkr_sticks_up_to_the_closed_form) {
  const auto points = random_scenes(1, 500);
  for (const double width : {1e-3, 1e-9, 1e-12}) {
    const auto found = sticking_speeds([](const scene& s) { return static_jkr(s); }, points, {.relative_width = width});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const speed exact = closed_form::sticking_speed(points[i].pair, points[i].work_of_adhesion);
      BOOST_TEST(holds(found[i], exact));
      BOOST_TEST(in_si(found[i].above) / in_si(found[i].below) - 1 <= width * 1.0001);
    }
  }
}

BOOST_AUTO_TEST_CASE(brackets_are_honest) {
  are_honest([](const scene& s) { return viscous_jkr(s); }, random_scenes(2, 60), 1e-9);
  are_honest([](const scene& s) { return yielding_jkr(s); }, random_scenes(3, 30), 1e-7);
  are_honest([](const scene& s) { return viscoelastic_jkr_fit(s); }, random_scenes(4, 30), 1e-3);
  are_honest([](const scene& s) { return viscoelastic_jkr_fit(s); }, random_scenes(5, 20), 1e-9);
  are_honest([](const scene& s) { return viscous_jkr(s, thornton_ning{s.yield_strength}); }, random_scenes(6, 60),
             1e-6);
}

BOOST_AUTO_TEST_CASE(viscoelastic_brackets_overlap_those_of_the_single_search) {
  struct point {
    length radius;
    duration relaxation_time;
  };
  const auto table = std::make_shared<const greenwood_table>(0.02);
  const auto family = [&](const point& p) {
    const sphere grain{.solid = materials::water_ice, .radius = p.radius};
    greenwood edge = ice.exact(p.relaxation_time);
    edge.table = table;
    return compose(between(grain, grain), hertz{}, ice.adhesive, edge,
                   kuwabara_kono{bulk_time_of_krijt(p.relaxation_time, 0.25)});
  };
  std::vector<point> points;
  for (const double T : {1e-13, 1e-12, 1e-11, 1e-10})
    for (const double R : {0.4, 2.0, 9.0})
      points.push_back({R * micrometres, T * seconds});
  const auto found = sticking_speeds(family, points, {.relative_width = 1e-7});
  long all = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all += found[i].collisions;
    if (points[i].radius < 1.0 * micrometres && points[i].relaxation_time > 5e-11 * seconds) {
      BOOST_TEST((found[i].at == place::above_fastest)); // a tenth of the speed of sound
      BOOST_TEST(std::abs(in_si(found[i].below) - 0.1 * std::sqrt(in_si(ice.pair.reduced_modulus) / 1000)) < 1e-9);
      BOOST_TEST(ending_at(family(points[i]), found[i].below) == "captured");
      continue;
    }
    const auto alone = sticking_speed(family(points[i]), 0.05 * metres_per_second, 190.0 * metres_per_second, 1e-8);
    BOOST_TEST(in_si(found[i].below) < in_si(alone.smallest_separated));
    BOOST_TEST(in_si(found[i].above) > in_si(alone.largest_captured));
  }
  BOOST_TEST(all < 20 * long(points.size()));
}

BOOST_AUTO_TEST_CASE(where_there_is_no_threshold_the_result_says_so) {
  const auto of = [](const auto& model, const threshold_options& options = {}) {
    return sticking_speeds([&](int) { return model; }, std::vector{0}, options)[0];
  };
  const auto hard = of(compose(ice.pair, hertz{}, ice.viscous));
  BOOST_TEST((hard.at == place::below_slowest));
  BOOST_TEST(in_si(hard.below) == 0);
  BOOST_TEST((in_si(hard.above) > 0 && in_si(hard.above) < 1e-6));
  BOOST_TEST(!hard.value());
  BOOST_TEST((of(compose(ice.pair, hertz{}, jkr{})).at == place::below_slowest)); // w = 0
  BOOST_TEST((of(compose(ice.pair, hertz{}, jkr{}, ice.exact(1e-11 * seconds))).at == place::below_slowest));
  BOOST_TEST((of(compose(ice.pair, hertz{}, dmt{ice.adhesive.work_of_adhesion})).at == place::below_slowest));
  BOOST_TEST((of(compose(ice.pair, hertz{}, tsuji{3}, end_at_zero_overlap{})).at == place::above_fastest));
  const auto limited = of(compose(ice.pair, hertz{}, ice.adhesive), {.fastest = 0.5 * metres_per_second});
  BOOST_TEST((limited.at == place::above_fastest));
  BOOST_TEST(in_si(limited.below) == 0.5);
  const auto from = of(compose(ice.pair, hertz{}, ice.adhesive), {.slowest = 10.0 * metres_per_second});
  BOOST_TEST((from.at == place::below_slowest));
  BOOST_TEST(in_si(from.above) == 10);
}

BOOST_AUTO_TEST_CASE(adhesion_without_an_edge_has_thresholds_too) {
  const auto damped = [](const scene& s) {
    return compose(s.pair, hertz{}, dmt{s.work_of_adhesion}, kuwabara_kono{s.bulk_time});
  };
  are_honest(damped, random_scenes(7, 30), 1e-6);
  const auto dugdale = [](const scene& s) {
    return compose(s.pair, hertz{}, maugis_dugdale{s.work_of_adhesion, 3e-10 * metres});
  };
  are_honest(dugdale, random_scenes(8, 20), 1e-6);
}

BOOST_AUTO_TEST_CASE(an_uncertain_ending_makes_the_bracket_wider_not_wrong) {
  // The law of a slow edge: between 16 and 64 m/s the bodies ring on for longer than so many evaluations.
  const auto family = [](duration T) { return compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T)); };
  const std::vector<duration> points{1e-5 * seconds};
  const auto found = sticking_speeds(family, points, {.max_evaluations = 30'000})[0];
  BOOST_TEST_MESSAGE("slow edge: between " << in_si(found.below) << " and " << in_si(found.above) << " m/s, "
                                           << found.collisions << " collisions: " << found.reason);
  BOOST_REQUIRE(found.value());
  BOOST_TEST(in_si(found.above) > 1.1 * in_si(found.below));
  BOOST_TEST(found.reason.find("unresolved") != std::string::npos);
  BOOST_TEST(ending_at(family(points[0]), found.below) == "captured");
  BOOST_TEST(ending_at(family(points[0]), found.above) == "separated");
}

BOOST_AUTO_TEST_CASE(a_bad_point_is_named_and_the_others_are_found) {
  const auto family = [](double w) { return compose(ice.pair, hertz{}, jkr{w * joules_per_square_metre}); };
  const auto found = sticking_speeds(family, std::vector{0.1, -1.0, 0.2});
  BOOST_TEST((found[0].value() && found[2].value()));
  BOOST_TEST((found[1].at == place::failed));
  BOOST_TEST(found[1].reason.find("work_of_adhesion = -1") != std::string::npos);
  contact_pair stranger = ice.pair; // a pair that does not know its bodies knows no speed of sound
  stranger.bodies = {};
  const auto of_stranger = [&](double w) { return compose(stranger, hertz{}, jkr{w * joules_per_square_metre}); };
  BOOST_TEST((sticking_speeds(of_stranger, std::vector{0.1})[0].at == place::failed));
  BOOST_TEST(
      sticking_speeds(of_stranger, std::vector{0.1}, {.fastest = 100.0 * metres_per_second})[0].value().has_value());
}

BOOST_AUTO_TEST_CASE(threads_change_nothing_and_progress_is_told) {
  const auto points = random_scenes(9, 40);
  const auto family = [](const scene& s) { return viscous_jkr(s); };
  const auto one = sticking_speeds(family, points, {.threads = 1});
  std::size_t told = 0, of = 0;
  const auto many = sticking_speeds(family, points, {.threads = 5, .progress = [&](std::size_t done, std::size_t all) {
                                                       BOOST_TEST(done > told);
                                                       told = done;
                                                       of = all;
                                                     }});
  BOOST_TEST(told == points.size());
  BOOST_TEST(of == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    BOOST_TEST((one[i].below == many[i].below && one[i].above == many[i].above));
    BOOST_TEST(one[i].collisions == many[i].collisions);
  }
}

BOOST_AUTO_TEST_CASE(bad_options_are_refused) {
  const auto family = [](double w) { return compose(ice.pair, hertz{}, jkr{w * joules_per_square_metre}); };
  const auto refuses = [&](const threshold_options& options) {
    BOOST_CHECK_THROW(sticking_speeds(family, std::vector{0.1}, options), bad_input);
  };
  refuses({.relative_width = 1e-13});
  refuses({.relative_width = 0.2});
  refuses({.slowest = 0.0 * metres_per_second});
  refuses({.fastest = -1.0 * metres_per_second});
  refuses({.slowest = 2.0 * metres_per_second, .fastest = 1.0 * metres_per_second});
  refuses({.max_evaluations = 0});
  BOOST_TEST(sticking_speeds(family, std::vector<double>{}).empty());
}

BOOST_AUTO_TEST_CASE(without_adhesion_contacts_yield_at_the_closed_form) {
  const auto points = random_scenes(10, 60);
  for (const double width : {1e-3, 1e-6, 1e-10}) {
    const auto within = yield_speeds([](const scene& s) { return yielding_hertz(s); }, points,
                                     {.relative_width = width, .fastest = 1e5 * metres_per_second});
    const auto added = yield_speeds([](const scene& s) { return static_jkr(s, thornton_ning{s.yield_strength}); },
                                    points, {.relative_width = width, .fastest = 1e5 * metres_per_second});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const speed exact = closed_form::yield_speed(points[i].pair, points[i].yield_strength);
      BOOST_TEST(holds(within[i], exact));
      BOOST_TEST(in_si(within[i].above) / in_si(within[i].below) - 1 <= width * 1.0001);
      BOOST_TEST(holds(added[i], exact));
      BOOST_TEST(added[i].collisions == 0); // nothing has to move
    }
  }
}

BOOST_AUTO_TEST_CASE(adhesion_lowers_the_yield_speed_to_that_of_its_energy) {
  const auto points = random_scenes(11, 100);
  const auto strong = [](const scene& s) { return thornton_ning_contact{1.5 * s.yield_strength}; };
  int bracketed = 0, at_once = 0;
  for (const double width : {1e-4, 1e-9}) {
    const auto found = yield_speeds([&](const scene& s) { return static_jkr(s, strong(s)); }, points,
                                    {.relative_width = width, .fastest = 1e5 * metres_per_second});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const scene& s = points[i];
      const speed exact = yield_speed_of_jkr(s.pair, jkr{s.work_of_adhesion}, strong(s));
      if (in_si(exact) > 0) {
        BOOST_TEST(holds(found[i], exact));
        BOOST_TEST((exact < closed_form::yield_speed(s.pair, strong(s).yield_strength)));
        ++bracketed;
      } else { // adhesion alone, which draws the bodies together from rest
        BOOST_TEST((found[i].at == place::below_slowest));
        ++at_once;
      }
    }
  }
  BOOST_TEST_MESSAGE(bracketed << " yield speeds, " << at_once << " contacts that yield however slowly they meet");
  BOOST_TEST(bracketed > 50);
  BOOST_TEST(at_once > 0);
}

BOOST_AUTO_TEST_CASE(a_scan_of_speeds_finds_the_same_yield_speed) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, kuwabara_kono{3e-11 * seconds},
                             thornton_ning_contact{.yield_strength = 250.0 * megapascals});
  const auto found = yield_speed(model, 0.1 * metres_per_second, 100.0 * metres_per_second);
  const auto undamped = yield_speed(compose(ice.pair, hertz{}, ice.adhesive, model.plasticity), 0.1 * metres_per_second,
                                    100.0 * metres_per_second);
  BOOST_TEST((undamped.smallest_yielding < found.largest_elastic)); // what damping takes, is not there to yield
  int elastic = 0, yielding = 0;
  for (double v = 0.5; v < 20; v *= 1.003) {
    const bool yields = in_si(collide(model, impact{v * metres_per_second}).residual_approach) > 0;
    BOOST_TEST(yields == (v > in_si(found.value())));
    ++(yields ? yielding : elastic);
  }
  BOOST_TEST((elastic > 100 && yielding > 100));
}

BOOST_AUTO_TEST_CASE(brackets_without_a_yield_speed_are_refused) {
  const auto model = compose(ice.pair, hertz{}, thornton_ning_contact{.yield_strength = 250.0 * megapascals});
  const speed exact = closed_form::yield_speed(ice.pair, model.plasticity.yield_strength);
  BOOST_CHECK_THROW(yield_speed(model, 1.1 * exact, 10.0 * exact), bad_input);
  BOOST_CHECK_THROW(yield_speed(model, 0.1 * exact, 0.9 * exact), bad_input);
  BOOST_CHECK_THROW(yield_speed(model, 10.0 * exact, 0.1 * exact), bad_input);
  BOOST_CHECK_THROW(yield_speed(model, 0.1 * exact, 10.0 * exact, 1e-11), bad_input);
  BOOST_CHECK_THROW(yield_speeds([&](int) { return model; }, std::vector{0}, {.relative_width = 1e-11}), bad_input);
  const auto weak = yield_speeds(
      [&](double Y) { return compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{Y * pascals}); },
      std::vector{1e7, 2.5e8});
  BOOST_TEST((weak[0].at == place::failed)); // would yield while adhesion draws it together
  BOOST_TEST(weak[0].reason.find("yield_strength") != std::string::npos);
  BOOST_TEST(weak[1].value().has_value());
}
