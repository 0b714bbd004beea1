#include <boost/test/unit_test.hpp>

#include <ricochet/number/lanes.hpp>

#include "support/every_law.hpp"

using namespace support;

namespace {

using two_packs = lanes<xsimd::batch<double>, 2>;
using kinds = std::tuple<lanes<xsimd::batch<double>, 1>, two_packs, lanes<xsimd::batch<float>, 1>>;

template <class Lanes, class Function>
Lanes filled(const Function& f) {
  Lanes x;
  for (std::size_t i = 0; i < Lanes::size; ++i)
    x.put(i, static_cast<typename Lanes::real>(f(i)));
  return x;
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(arithmetic_goes_lane_by_lane, Lanes, kinds) {
  using T = typename Lanes::real;
  const auto first = [](std::size_t i) { return T(2) + T(i); };
  const auto second = [](std::size_t i) { return T(1) / (T(3) + T(i)); };
  const Lanes a = filled<Lanes>(first), b = filled<Lanes>(second);
  const constant<Lanes> c = b;
  for (std::size_t i = 0; i < Lanes::size; ++i) {
    const T x = first(i), y = second(i), round_off = 4 * std::numeric_limits<T>::epsilon();
    const auto same = [&](T found, T expected) { return std::abs(found - expected) <= round_off * std::abs(expected); };
    BOOST_TEST((a + b)[i] == x + y);
    BOOST_TEST((a - b)[i] == x - y);
    BOOST_TEST((a * b)[i] == x * y);
    BOOST_TEST((a / b)[i] == x / y);
    BOOST_TEST(same((a / c)[i], x / y));
    BOOST_TEST((-a)[i] == -x);
    BOOST_TEST(sqrt(a)[i] == std::sqrt(x));
    BOOST_TEST(abs(-a)[i] == x);
    BOOST_TEST(min(a, b)[i] == std::min(x, y));
    BOOST_TEST(max(a, b)[i] == std::max(x, y));
    BOOST_TEST(same(pow(a, b)[i], std::pow(x, y)));
    BOOST_TEST(same(cube_root(a)[i], std::cbrt(x)));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(masks_have_a_bit_for_each_lane, Lanes, kinds) {
  using T = typename Lanes::real;
  const Lanes number = filled<Lanes>([](std::size_t i) { return T(i); });
  for (std::size_t i = 0; i < Lanes::size; ++i) {
    const std::uint64_t bit = std::uint64_t(1) << i;
    BOOST_TEST(((number <= Lanes(T(i))) & (number >= Lanes(T(i)))).bits() == bit);
    BOOST_TEST((number < Lanes(T(i))).bits() == bit - 1);
    const auto others = (number > Lanes(T(i))) | (number < Lanes(T(i)));
    BOOST_TEST((~others).bits() == bit);
  }
  const Lanes blended = select<Lanes>(
      number < Lanes(1), [&] { return number + Lanes(10); }, [&] { return -number; });
  BOOST_TEST(blended[0] == T(10));
  BOOST_TEST(blended[Lanes::size - 1] == -T(Lanes::size - 1));
}

BOOST_AUTO_TEST_CASE(one_lane_of_an_object_is_copied) {
  const auto made = [](double offset) {
    std::array<two_packs, 3> x;
    for (std::size_t n = 0; n < 3; ++n)
      x[n] = filled<two_packs>([&](std::size_t i) { return offset + 100. * double(n) + double(i); });
    return x;
  };
  auto to = made(0);
  copy_lane<two_packs>(to, 1, made(1000), 3);
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t i = 0; i < two_packs::size; ++i)
      BOOST_TEST(to[n][i] == (i == 1 ? 1003. : double(i)) + 100. * double(n));
}

BOOST_AUTO_TEST_CASE(every_smooth_law_lane_by_lane) {
  const auto all = contacts();
  const auto lane = [&](std::size_t i) -> const auto& { return all[(7 * i) % all.size()]; };
  const auto pack = [&](double contact_numbers<double>::*member) {
    return filled<two_packs>([&](std::size_t i) { return lane(i).*member; });
  };
  using n = contact_numbers<double>;
  const basic_pair<reduced<two_packs>> pairs{pack(&n::modulus), pack(&n::radius_of_bodies), pack(&n::mass)};
  const configuration<reduced<two_packs>> c{pack(&n::approach), -abs(pack(&n::rate)), pack(&n::radius),
                                            sqrt(pack(&n::radius))};
  const auto in_lanes = [](auto law) {
    return rebind_law<reduced<two_packs>>(law, [](const auto& x) { return two_packs(in_si(x)); });
  };
  const auto in_numbers = [](auto law) {
    return rebind_law<reduced<double>>(law, [](const auto& x) { return in_si(x); });
  };
  const auto agree = [&](auto law, auto value) {
    const two_packs found = value(in_lanes(law), pairs, c);
    for (std::size_t i = 0; i < two_packs::size; ++i) {
      const auto& x = lane(i);
      const basic_pair<reduced<double>> pair{x.modulus, x.radius_of_bodies, x.mass};
      const double expected =
          value(in_numbers(law), pair,
                configuration<reduced<double>>{x.approach, -std::abs(x.rate), x.radius, std::sqrt(x.radius)});
      // A fused product and sum, and a reciprocal, round differently, where forces cancel.
      BOOST_TEST(std::abs(found[i] - expected) <= 1e-14 * (1 + std::abs(expected)));
    }
  };
  using namespace units;
  agree(hertz{}, [](const auto& l, const auto& p, const auto& x) { return l.force(p, x); });
  agree(hertz{}, [](const auto& l, const auto& p, const auto& x) { return l.stored_energy(p, x); });
  agree(kuwabara_kono{0.3 * seconds}, [](const auto& l, const auto& p, const auto& x) { return l.coefficient(p, x); });
  agree(hunt_crossley{0.3 * seconds_per_metre},
        [](const auto& l, const auto& p, const auto& x) { return l.coefficient(p, x); });
  agree(tsuji{0.3}, [](const auto& l, const auto& p, const auto& x) { return l.coefficient(p, x); });
  agree(line_force{0.3 * newtons_per_metre, 0.2 * seconds_per_metre},
        [](const auto& l, const auto& p, const auto& x) { return l.rebound_damping(p, x); });
  agree(dmt{0.3 * joules_per_square_metre},
        [](const auto& l, const auto& p, const auto& x) { return l.potential_energy(p, x); });
  agree(jkr{0.3 * joules_per_square_metre}, [](const auto& l, const auto& p, const auto&) { return l.exit_energy(p); });
}
