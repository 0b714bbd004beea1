#include <boost/test/unit_test.hpp>

#include <ricochet/number/xsimd.hpp>

#include "support/every_law.hpp"

using namespace support;

namespace {

using packs = std::tuple<xsimd::batch<double>, xsimd::batch<float>>;

/// Packs whose lanes hold different contacts, so that neighbouring lanes lie in different pieces of the crack laws.
template <class Pack>
contact_numbers<Pack> gathered(std::size_t first, std::vector<contact_numbers<typename Pack::value_type>>& lanes) {
  using T = typename Pack::value_type;
  const auto all = contacts();
  for (std::size_t i = 0; i < Pack::size; ++i) // 7 is prime to the number of contacts: far apart
    lanes.push_back(all[(first + 7 * i) % all.size()].template in<T>([](double x) { return static_cast<T>(x); }));
  const auto pack = [&](T contact_numbers<T>::*member) {
    std::array<T, Pack::size> values;
    for (std::size_t i = 0; i < Pack::size; ++i)
      values[i] = lanes[i].*member;
    return Pack::load_unaligned(values.data());
  };
  using n = contact_numbers<T>;
  return {pack(&n::modulus),          pack(&n::radius_of_bodies), pack(&n::mass),
          pack(&n::work_of_adhesion), pack(&n::approach),         pack(&n::rate),
          pack(&n::radius),           pack(&n::root_ratio)};
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(every_law_lane_by_lane, Pack, packs) {
  using T = typename Pack::value_type;
  T worst = 0;
  for (std::size_t first = 0; first < contacts().size(); ++first) {
    std::vector<contact_numbers<T>> lanes;
    const auto found = values_in_the_loop(gathered<Pack>(first, lanes));
    for (std::size_t i = 0; i < Pack::size; ++i) {
      const auto expected = values_in_the_loop(lanes[i]);
      BOOST_TEST_REQUIRE(found.size() == expected.size());
      for (std::size_t j = 0; j < found.size(); ++j)
        worst = std::max(worst, std::abs(found[j].get(i) / expected[j] - 1));
    }
  }
  BOOST_TEST_MESSAGE("largest deviation in ulp: " << worst / std::numeric_limits<T>::epsilon());
  BOOST_TEST(worst <= 4 * std::numeric_limits<T>::epsilon()); // log and pow of the packs differ by some ulp from libm's
}

BOOST_AUTO_TEST_CASE_TEMPLATE(constants_and_select, Pack, packs) {
  using T = typename Pack::value_type;
  BOOST_TEST(pi<Pack>().get(0) == pi<T>());
  BOOST_TEST(number_traits<Pack>::euler_gamma().get(Pack::size - 1) == number_traits<T>::euler_gamma());
  std::array<T, Pack::size> values;
  for (std::size_t i = 0; i < Pack::size; ++i)
    values[i] = i % 2 ? T(1) : T(-1);
  const Pack x = Pack::load_unaligned(values.data());
  const Pack blended = select<Pack>(
      x > Pack(0), [&] { return x + Pack(1); }, [&] { return x - Pack(1); });
  for (std::size_t i = 0; i < Pack::size; ++i)
    BOOST_TEST(blended.get(i) == (i % 2 ? T(2) : T(-2)));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(function_of_real_numbers, Pack, packs) {
  using T = typename Pack::value_type;
  struct {
    T value(T x) const { return x * x; }
  } squared;
  std::array<T, Pack::size> values;
  for (std::size_t i = 0; i < Pack::size; ++i)
    values[i] = static_cast<T>(i + 2);
  const Pack result = evaluate<Pack>(squared, Pack::load_unaligned(values.data()));
  for (std::size_t i = 0; i < Pack::size; ++i)
    BOOST_TEST(result.get(i) == static_cast<T>((i + 2) * (i + 2)));
}
