// What restitution_map.cpp does not test: durations, packs, files, and pairs and ranges out of the ordinary.
#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/closed_form/contact_duration.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/map/restitution_map.hpp>

#include <numeric>

using namespace support;

namespace {
const ice_case ice;
const speed low = 0.01 * metres_per_second, high = 100.0 * metres_per_second;

std::vector<double> random_speeds(double from, double to, std::size_t count) {
  std::mt19937_64 source(11);
  std::uniform_real_distribution<double> uniform(std::log(from), std::log(to));
  std::vector<double> speeds(count);
  for (double& v : speeds)
    v = std::clamp(std::exp(uniform(source)), from, to);
  return speeds;
}

/// Largest relative error at random speeds, half of them close above the sticking speed, but not within a millionth;
/// there, it is the second number.
template <class Model>
std::array<double, 2> errors_of_duration(const Model& model, const duration_map& map) {
  const double from = std::max(map.low(), map.sticking_speed());
  std::vector<double> speeds = random_speeds(from, map.high(), 120);
  for (double apart = 1e-11; map.sticking_speed() > 0 && apart < 1; apart *= 2.3)
    speeds.push_back(map.sticking_speed() * (1 + apart));
  std::array<double, 2> worst{};
  for (const double v : speeds)
    if (v <= map.high()) {
      const auto out = collide(model, impact{v * metres_per_second}, {.tolerance = 1e-12});
      BOOST_TEST_REQUIRE(out.restitution.has_value());
      double& of = worst[v < map.sticking_speed() * (1 + 1e-6)];
      of = std::max(of, std::abs(map(v) / in_si(out.contact_duration) - 1));
    }
  BOOST_TEST_MESSAGE(map.pieces().size() << " pieces, largest error " << worst[0] << ", within a millionth of the "
                                         << "sticking speed " << worst[1]);
  return worst;
}

std::string refusal_of(const auto& f) {
  try {
    f();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}
} // namespace

BOOST_AUTO_TEST_CASE(durations_are_right_to_their_relative_error) {
  const auto check = [&](const auto& model, double near) {
    for (const double max_error : {1e-5, 1e-8}) {
      const auto map = make_duration_map(model, low, high, {.max_error = max_error});
      const auto [far, within] = errors_of_duration(model, map);
      BOOST_TEST((far <= max_error && within <= std::max(max_error, near)));
      BOOST_TEST((map.largest_error() > 0 && map.largest_error() <= max_error / 2));
    }
  };
  const contact_duration asked;
  check(compose(ice.pair, hertz{}, ice.viscous, asked), 0);
  // What the sticking speed's last digits, 1e-12, make of sqrt(v - v_s), and of the sixth root, as line_force has it.
  check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, asked), 1e-6);
  check(compose(ice.pair, hertz{}, line_force{50.0 * newtons_per_metre, 1e-2 * seconds_per_metre}, asked), 1e-2);
  check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.exact(1e-11 * seconds), asked), 0);
}

BOOST_AUTO_TEST_CASE(the_duration_of_jkr_in_closed_form) {
  const auto map = make_duration_map(compose(ice.pair, hertz{}, ice.adhesive, contact_duration{}), low, high);
  for (const double v : random_speeds(map.sticking_speed() * (1 + 1e-6), map.high(), 200)) {
    const auto exact =
        closed_form::contact_duration(ice.pair, ice.adhesive.work_of_adhesion, v * metres_per_second).value();
    BOOST_TEST(std::abs(map(v) / in_si(exact) - 1) < 1e-8);
  }
  BOOST_TEST((std::isnan(map(map.sticking_speed())) && std::isnan(map(0.02)) && std::isnan(map(101.))));
  BOOST_TEST(duration_map::contact_duration(&map, 5.) == map(5.));
}

BOOST_AUTO_TEST_CASE(packs_and_many_speeds_are_what_single_ones_are) {
  const auto e = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), low, high);
  const auto time =
      make_duration_map(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, contact_duration{}), low, high);
  const auto everywhere = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive), low, low * 10.);
  std::vector<double> speeds = random_speeds(0.001, 1000, 999); // no multiple of a pack
  for (const double v : {e.low(), e.high(), e.sticking_speed(), e.sticking_speed() * (1 + 1e-15), 0., -1., std::nan(""),
                         std::numeric_limits<double>::infinity()})
    speeds.push_back(v);
  for (const auto& piece : e.pieces())
    speeds.insert(speeds.end(), {piece.end, piece.end * (1 - 1e-15)});
  const auto check = [&](const auto& map, const std::vector<double>& values) {
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const double alone = map(speeds[i]);
      BOOST_TEST(((std::isnan(alone) && std::isnan(values[i])) || alone == values[i]));
    }
  };
  std::vector<double> values(speeds.size());
  restitution_map::restitutions(&e, speeds.data(), values.data(), speeds.size());
  check(e, values);
  using pack = xsimd::batch<double>;
  std::fill(values.begin(), values.end(), -1.);
  speeds.resize(speeds.size() / pack::size * pack::size);
  for (std::size_t i = 0; i < speeds.size(); i += pack::size)
    e(pack::load_unaligned(speeds.data() + i)).store_unaligned(values.data() + i);
  check(e, values);
  duration_map::contact_durations(&time, speeds.data(), values.data(), speeds.size());
  check(time, values);
  restitution_map::restitutions(&everywhere, speeds.data(), values.data(), speeds.size());
  check(everywhere, values);
}

BOOST_AUTO_TEST_CASE(from_micrometres_to_kilometres_a_second) {
  const speed slow = 1e-6 * metres_per_second, fast = 1e3 * metres_per_second;
  const auto never = make_restitution_map(compose(ice.pair, hertz{}, ice.viscous), slow, fast);
  BOOST_TEST((never.sticking_speed() == 0 && never(1e-6) > 0.99 && never(1e3) > 0));
  const auto sometimes = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive), slow, fast);
  const double v_s = in_si(closed_form::sticking_speed(ice.pair, ice.adhesive.work_of_adhesion));
  for (const double v : random_speeds(1e-6, 1e3, 500))
    BOOST_TEST(std::abs(sometimes(v) - (v > v_s ? std::sqrt(1 - square(v_s / v)) : 0)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(pairs_that_separate_at_some_speeds_in_between_only) {
  const auto weak =
      compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, thornton_ning{1e8 * pascals}, contact_duration{});
  BOOST_TEST((!collide(weak, impact{low}).restitution && !collide(weak, impact{high}).restitution));
  const auto map = make_restitution_map(weak, low, high);
  double largest = 0;
  for (const double v : random_speeds(0.01, 100, 500)) {
    const double e = collide(weak, impact{v * metres_per_second}, {.tolerance = 1e-11}).restitution.value_or(0);
    largest = std::max(largest, e);
    BOOST_TEST(std::abs(map(v) - e) < 1e-8);
  }
  BOOST_TEST(largest > 0.1);
  BOOST_CHECK_THROW(make_duration_map(weak, low, high), bad_input); // where it sticks again there is none
}

BOOST_AUTO_TEST_CASE(laws_with_joints_and_with_ranges) {
  const auto check = [&](const auto& model) {
    const auto map = make_restitution_map(model, low, high, {.max_error = 1e-6});
    BOOST_TEST((map.sticking_speed() > 0.5 && map.pieces().size() < 40));
    std::vector<double> speeds = random_speeds(map.sticking_speed() * (1 + 1e-6), map.high(), 60);
    for (double apart = 1e-6; apart < 1; apart *= 2.3)
      speeds.push_back(map.sticking_speed() * (1 + apart));
    for (const double v : speeds)
      BOOST_TEST(std::abs(map(v) - *collide(model, impact{v * metres_per_second}, {.tolerance = 1e-9}).restitution) <
                 1e-6);
  };
  check(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.fitted()));
  check(compose(ice.pair, hertz{}, maugis_dugdale{ice.adhesive.work_of_adhesion, 3.0 * nanometres}, ice.viscous));
}

BOOST_AUTO_TEST_CASE(fast_edges) { // of which lanes would take ever shorter steps
  for (const double T : {1e-14, 1e-15, 1e-16}) {
    const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.exact(T * seconds));
    const auto map = make_restitution_map(model, low, high, {.max_error = 1e-6});
    for (const double v : random_speeds(map.sticking_speed() * (1 + 1e-6), map.high(), 40))
      BOOST_TEST(std::abs(map(v) - *collide(model, impact{v * metres_per_second}, {.tolerance = 1e-8}).restitution) <
                 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(the_same_on_any_number_of_threads_and_progress_is_told) {
  const auto model = compose(ice.pair, hertz{}, ice.adhesive, ice.viscous);
  std::size_t calls = 0, done = 0, of = 0;
  const auto two =
      make_restitution_map(model, low, high, {.threads = 2, .progress = [&](std::size_t n, std::size_t all) {
                                                ++calls;
                                                BOOST_TEST((n >= done && n <= all));
                                                done = n, of = all;
                                              }});
  BOOST_TEST((calls > 1 && done == of && done == two.pieces().size()));
  const auto one = make_restitution_map(model, low, high, {.threads = 1});
  BOOST_REQUIRE(one.pieces().size() == two.pieces().size());
  for (std::size_t i = 0; i < one.pieces().size(); ++i)
    BOOST_TEST(one.pieces()[i].c == two.pieces()[i].c);
  const auto refuse = [](std::size_t, std::size_t) { throw std::domain_error("enough"); };
  BOOST_CHECK_THROW(make_restitution_map(model, low, high, {.progress = refuse}), std::domain_error);
}

BOOST_AUTO_TEST_CASE(a_file_says_what_is_in_it_and_when_it_is_damaged) {
  const auto made = make_restitution_map(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous), low, high,
                                         {.max_error = 1e-4, .about = "two grains of ice"});
  const auto file = std::filesystem::temp_directory_path() / "ricochet_speed_map_test.txt";
  made.save(file);
  const auto loaded = restitution_map::load(file);
  BOOST_TEST((loaded.largest_error() == made.largest_error() && loaded.sticking_speed() == made.sticking_speed()));
  BOOST_TEST(loaded.description() == made.description());
  BOOST_TEST(made.description().starts_with("two grains of ice, reduced_modulus = "));
  for (const char* part : {"reduced_mass = ", " kg, work_of_adhesion = 0.74 ", "bulk_time = 1.6e-10 s"})
    BOOST_TEST(made.description().find(part) != std::string::npos);

  std::string text;
  {
    std::ifstream in(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(in), {});
  }
  BOOST_TEST(text.starts_with(std::string("# ricochet ") + version + " restitution map, format 2\n# of: two grains"));
  BOOST_TEST(text.find("# largest error found: ") != std::string::npos);
  const auto refused = [&](const std::string& as, const char* why) {
    std::ofstream(file, std::ios::binary) << as;
    const std::string what = refusal_of([&] { restitution_map::load(file); });
    BOOST_TEST_CONTEXT(why) {
      BOOST_TEST(what.find(why) != std::string::npos, what);
      BOOST_TEST(what.find(file.string()) != std::string::npos);
    }
  };
  const auto replaced = [&](std::string what, const std::string& by, std::string in) {
    const std::size_t at = in.find(what);
    BOOST_REQUIRE(at != std::string::npos);
    return in.replace(at, what.size(), by);
  };
  /// As by someone who computes the checksum anew.
  const auto checked = [](const std::string& all) {
    const std::string body = all.substr(0, all.rfind("checksum "));
    return body + "checksum " + detail::checksum_of(body) + "\n";
  };
  refused("", "is no map");
  refused("speed,restitution\n", "is no map");
  refused(text.substr(0, text.size() / 2), "is not whole");
  refused(text.substr(0, text.size() - 1), "is not whole");
  refused(text + "1", "is not whole");
  refused(replaced("0.74", "0.75", text), "is damaged");
  refused(replaced("\n0.01 100", "\n0.01 101", text), "is damaged");
  refused(replaced("restitution map", "contact duration map", text), "is a contact duration map");
  refused(replaced("format 2", "format 1", text), "is of format 1");
  refused(checked(replaced("\n0.01 100", "\n0.01 nan", text)), "has no number");
  refused(checked(replaced("\n0.01 100", "\n0.01 1e999", text)), "has no number");
  refused(checked(replaced("\n0.01 100", "\n0.01 ice", text)), "has no number");
  refused(checked(replaced("\n0.01 100", "\n0.01 101", text)), "it ends at 100 m/s");
  refused(checked(replaced("\n0.01 100", "\n-1 100", text)), "low speed of the map = -1");
  const std::string count = " " + std::to_string(made.pieces().size()) + " \n";
  const auto counted = [&](const std::string& n) {
    const std::size_t at = text.find('\n', text.find("\n0.01 100") + 1);
    std::string other = text;
    const std::size_t from = other.rfind(' ', at - 1) + 1;
    return other.replace(from, at - from, n);
  };
  refused(checked(counted("1000")), "has no number");
  refused(checked(counted("1e18")), "says that it holds");
  refused(checked(counted("2.5")), "says that it holds");
  refused(checked(counted("1")), "goes on behind its end");
  std::filesystem::remove(file);
  BOOST_TEST(refusal_of([&] { restitution_map::load(file); }).starts_with("cannot read"));
  BOOST_TEST(refusal_of([&] { made.save("/nowhere/map.txt"); }).starts_with("cannot write"));
}

BOOST_AUTO_TEST_CASE(bad_maps_are_refused) {
  const auto model = compose(ice.pair, hertz{}, ice.viscous);
  BOOST_CHECK_THROW(make_restitution_map(model, low, high, {.about = "two\nlines"}), bad_input);
  BOOST_CHECK_THROW((restitution_map(1, 2, 0, 0, {{1, 2, true, {}}})), bad_input); // no root of nothing
  BOOST_CHECK_THROW((restitution_map(1, 4, 1, 0, {{1, 2, false, {}}, {2, 4, true, {}}})), bad_input); // plain one first
  BOOST_CHECK_THROW((restitution_map(1, 2, 3, 0, {})), bad_input);
  BOOST_CHECK_THROW((restitution_map(1, 2, 0, std::nan(""), {{1, 2, false, {}}})), bad_input);
  BOOST_CHECK_NO_THROW((restitution_map(1, 4, 1, 0, {{1, 2, true, {}}, {2, 4, false, {}}})));
}
