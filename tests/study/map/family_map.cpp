#include <boost/test/unit_test.hpp>

#include <ricochet/closed_form/viscoelastic_hertz.hpp>
#include <ricochet/collide.hpp>
#include <ricochet/study/map/jkr_map.hpp>

using namespace ricochet;
using namespace ricochet::units;

namespace {
const contact_pair unit_pair{
    .reduced_modulus = 1.0 * pascals, .reduced_radius = 1.0 * metres, .reduced_mass = 1.0 * kilograms};
const auto adhesive_family = [](double p) {
  return compose(unit_pair, hertz{}, jkr{1.0 * joules_per_square_metre}, kuwabara_kono{p * seconds});
};
using adhesive_model = std::invoke_result_t<decltype(adhesive_family), double>;
constexpr family_map::interval dampings{1e-4, 0.25}, speeds{1, 1e4};

double even_in_logarithm(const family_map::interval& i, auto& source) {
  return std::clamp(std::exp(std::uniform_real_distribution(std::log(i.low), std::log(i.high))(source)), i.low, i.high);
}

const family_map& coarse() {
  static const family_map map = make_jkr_map(dampings, speeds);
  return map;
}

std::string refusal_of(const auto& f) {
  try {
    f();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

/// Largest errors at random places all over and close above the sticking speed; within a millionth of it, that of e^2.
void is_right(const family_map& map, double max_error) {
  std::mt19937_64 source(3);
  std::vector<scene<adhesive_model>> scenes;
  std::vector<std::array<double, 2>> at;
  const auto look = [&](double v, double p) {
    if (!(v <= map.speeds().high))
      return;
    at.push_back({v, p});
    scenes.push_back({adhesive_family(p), {v * metres_per_second}});
  };
  for (int i = 0; i < 6000; ++i)
    look(even_in_logarithm(map.speeds(), source), even_in_logarithm(map.parameters(), source));
  for (int i = 0; i < 2000; ++i) {
    const double p = even_in_logarithm(map.parameters(), source);
    look(map.sticking_speed(p) * (1 + even_in_logarithm({1e-9, 1}, source)), p);
  }
  const auto outcomes = collide(scenes, {.tolerance = max_error / 100});
  double worst = 0, worst_near = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto [v, p] = at[i];
    const double e = outcomes[i].restitution.value_or(0), mapped = map(v, p);
    BOOST_TEST_REQUIRE((mapped >= 0 && mapped <= 1));
    if (std::abs(v / map.sticking_speed(p) - 1) < 1e-6)
      worst_near = std::max(worst_near, std::abs(mapped * mapped - e * e));
    else
      worst = std::max(worst, std::abs(mapped - e));
  }
  BOOST_TEST_MESSAGE(map.patches() << " patches, " << map.threshold().size()
                                   << " pieces of the sticking speed: largest "
                                   << "error " << worst << ", next to the threshold of e^2 " << worst_near);
  BOOST_TEST((worst <= max_error && worst_near <= max_error));
  BOOST_TEST((map.largest_error() > 0 && map.largest_error() <= max_error / 2));
}
} // namespace

BOOST_AUTO_TEST_CASE(right_to_its_error) {
  is_right(coarse(), 1e-6);
  is_right(make_jkr_map({1e-2, 0.1}, {3, 100}, {.max_error = 1e-8}), 1e-8);
}

BOOST_AUTO_TEST_CASE(any_pair_by_its_two_groups) {
  std::mt19937_64 source(5);
  std::vector<scene<adhesive_model>> scenes;
  std::vector<double> mapped;
  while (scenes.size() < 1000) {
    const double R = even_in_logarithm({1e-9, 1}, source), density = even_in_logarithm({10, 2e4}, source);
    const contact_pair pair{.reduced_modulus = even_in_logarithm({1e4, 1e12}, source) * pascals,
                            .reduced_radius = R * metres,
                            .reduced_mass = density * R * R * R * kilograms};
    const jkr adhesion{even_in_logarithm({1e-5, 10}, source) * joules_per_square_metre};
    const kuwabara_kono bulk{even_in_logarithm({1e-16, 1e-2}, source) * seconds};
    const speed v = even_in_logarithm({1e-6, 1e3}, source) * metres_per_second;
    const double e = restitution_by(coarse(), pair, adhesion, bulk, v);
    const jkr_groups groups = groups_of(pair, adhesion, bulk, v);
    const bool inside = groups.speed >= speeds.low && groups.speed <= speeds.high && groups.damping >= dampings.low &&
                        groups.damping <= dampings.high;
    BOOST_TEST_REQUIRE(std::isnan(e) != inside);
    if (inside) {
      scenes.push_back({compose(pair, hertz{}, adhesion, bulk), {v}});
      mapped.push_back(e);
    }
  }
  std::size_t separated = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto out = collide(scenes[i].model, scenes[i].impact);
    separated += out.restitution.has_value();
    BOOST_TEST(std::abs(mapped[i] - out.restitution.value_or(0)) < 1e-6);
  }
  BOOST_TEST((separated > 200 && separated < 990)); // of both
}

BOOST_AUTO_TEST_CASE(the_sticking_speed_as_a_function_of_the_parameter) {
  for (const double p : {1e-4, 1e-3, 0.01, 0.08, 0.25}) {
    const auto found = sticking_speed(adhesive_family(p), 3.0 * metres_per_second, 100.0 * metres_per_second, 1e-11);
    BOOST_TEST(std::abs(coarse().sticking_speed(p) / in_si(found.value()) - 1) < 1e-8);
  }
  BOOST_TEST(std::abs(coarse().sticking_speed(1e-4) / 3.766 - 1) < 1e-2); // closed form without damping
  BOOST_TEST((std::isnan(coarse().sticking_speed(1e-5)) && std::isnan(coarse().sticking_speed(1))));
  BOOST_TEST(coarse()(coarse().sticking_speed(0.01) * (1 - 1e-12), 0.01) == 0);
  BOOST_TEST(family_map::restitution(&coarse(), 20, 0.01) == coarse()(20, 0.01));
  for (const auto& [v, p] : {std::pair{0.99, 0.01}, {1.01e4, 0.01}, {10., 0.9e-4}, {10., 0.26}, {std::nan(""), 0.01}})
    BOOST_TEST(std::isnan(coarse()(v, p)));
  BOOST_TEST((coarse()(1, 1e-4) == 0 && coarse()(1e4, 1e-4) > 0.9 && coarse()(1e4, 0.25) > 0));
}

BOOST_AUTO_TEST_CASE(damping_so_strong_that_all_stick) { // at no speed a pair of p > 0.4375 separates
  const auto map = make_jkr_map({0.05, 3}, {1, 100}, {.max_error = 1e-4});
  const auto [least, most] = map.separating_parameters();
  BOOST_TEST((least == 0.05 && most > 0.37 && most < 0.44));
  BOOST_TEST((map.sticking_speed(most) > 100 && std::isinf(map.sticking_speed(1)) && map(100, 1) == 0));
  std::mt19937_64 source(3);
  for (int i = 0; i < 300; ++i) {
    const double v = even_in_logarithm({1, 100}, source), p = even_in_logarithm({0.05, 3}, source);
    const double e =
        collide(adhesive_family(p), impact{v * metres_per_second}, {.tolerance = 1e-6}).restitution.value_or(0);
    BOOST_TEST(std::abs(map(v, p) - e) < 1e-4);
  }
  const auto none = make_jkr_map({1, 3}, {1, 100});
  BOOST_TEST((none(50, 2) == 0 && none.patches() == 0 && std::isnan(none(50, 4))));
}

BOOST_AUTO_TEST_CASE(a_family_that_never_sticks) {
  const auto family = [](double p) { return compose(unit_pair, hertz{}, kuwabara_kono{p * seconds}); };
  const auto map =
      make_family_map(family, 1e-3, 1, 1e-3 * metres_per_second, 100.0 * metres_per_second, {.max_error = 1e-8});
  std::mt19937_64 source(3);
  for (int i = 0; i < 1000; ++i) {
    const double v = even_in_logarithm({1e-3, 100}, source), p = even_in_logarithm({1e-3, 1}, source);
    const double y = closed_form::damping_number(unit_pair, p * seconds, v * metres_per_second);
    BOOST_TEST(std::abs(map(v, p) - closed_form::viscoelastic_restitution_to_zero_force(y)) < 1e-8);
  }
  BOOST_TEST(map.sticking_speed(0.1) == 0);
}

BOOST_AUTO_TEST_CASE(the_same_on_any_number_of_threads_and_as_loaded) {
  std::size_t calls = 0, done = 0, of = 0;
  const auto two = make_jkr_map(dampings, {2, 50},
                                {.max_error = 1e-4, .threads = 2, .progress = [&](std::size_t n, std::size_t all) {
                                   ++calls, done = n, of = all;
                                 }});
  BOOST_TEST((calls > 1 && done == of && done <= two.patches()));
  const auto one = make_jkr_map(dampings, {2, 50}, {.max_error = 1e-4, .threads = 1});
  const auto file = std::filesystem::temp_directory_path() / "ricochet_family_map_test.txt";
  two.save(file);
  const auto loaded = family_map::load(file);
  BOOST_TEST((loaded.patches() == two.patches() && loaded.largest_error() == two.largest_error()));
  BOOST_TEST((loaded.description() == two.description() && two.description().starts_with("hertz, jkr and kuwabara")));
  std::mt19937_64 source(3);
  for (int i = 0; i < 2000; ++i) {
    const double v = even_in_logarithm({2, 50}, source), p = even_in_logarithm(dampings, source);
    BOOST_TEST_REQUIRE((one(v, p) == two(v, p) && loaded(v, p) == two(v, p)));
  }

  std::string text;
  {
    std::ifstream in(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(in), {});
  }
  const auto refused = [&](std::string as, const std::string& why, bool checked) {
    if (checked) {
      as.resize(as.rfind("checksum "));
      as += "checksum " + detail::checksum_of(as) + "\n";
    }
    std::ofstream(file, std::ios::binary) << as;
    const std::string what = refusal_of([&] { family_map::load(file); });
    BOOST_TEST(what.find(why) != std::string::npos, what << " does not say: " << why);
    BOOST_TEST(what.find(file.string()) != std::string::npos);
  };
  const auto last_node_changed = [&](const std::string& to) {
    const std::size_t end = text.rfind("\nchecksum"), begin = text.rfind('\n', end - 1) + 1;
    return text.substr(0, begin) + to + text.substr(end);
  };
  refused(text.substr(0, text.size() / 2), "is not whole", false);
  refused(last_node_changed("3"), "is damaged", false);
  refused(last_node_changed("0"), "lacks some", true); // halves, and then there is nothing
  refused(last_node_changed("7"), "a node of kind 7", true);
  refused(last_node_changed("2 1 2 3"), "has no number", true);
  refused(last_node_changed("3 3"), "goes on behind its end", true);
  std::string other = text;
  refused(other.replace(other.find("family map"), 10, "restitution map"), "is a restitution map, not a family map",
          false);
  std::filesystem::remove(file);
  BOOST_TEST(refusal_of([&] { family_map::load(file); }).starts_with("cannot read"));
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(make_jkr_map({0.1, 0.1}, speeds), bad_input);
  BOOST_CHECK_THROW(make_jkr_map({0, 0.1}, speeds), bad_input);
  BOOST_CHECK_THROW(make_jkr_map(dampings, {10, 1}), bad_input);
  BOOST_CHECK_THROW(make_jkr_map(dampings, speeds, {.max_error = 1e-10}), bad_input);
  BOOST_TEST(refusal_of([] {
               make_jkr_map(dampings, speeds, {.max_error = 1e-6, .most_patches = 3});
             }).find("more than 3 p") != std::string::npos);
  BOOST_CHECK_THROW(groups_of(unit_pair, jkr{}, kuwabara_kono{}, 1.0 * metres_per_second), bad_input);
  const auto partly = [](double w) { // ever less adhesion: some of these pairs stick at a nanometre a second only
    return compose(unit_pair, hertz{}, jkr{w * joules_per_square_metre}, kuwabara_kono{});
  };
  BOOST_TEST(refusal_of([&] {
               make_family_map(partly, 1e-12, 1, 1.0 * metres_per_second, 10.0 * metres_per_second);
             }).find("or nowhere") != std::string::npos);
  BOOST_CHECK_THROW((family_map({1, 2}, {1, 2}, {1, 2}, {0, 1}, 0, {}, {})), bad_input); // no tree
  BOOST_CHECK_THROW((family_map({1, 2}, {1, 2}, {1, 3}, {0, 1}, 0, {}, {{family_map::node::patch}})), bad_input);
}
