#include <boost/test/unit_test.hpp>

#include <ricochet/batch/share.hpp>

#include <stdexcept>
#include <string>

using ricochet::detail::share;

BOOST_AUTO_TEST_CASE(every_number_is_worked_on_once) {
  for (const unsigned threads : {0u, 1u, 3u})
    for (const std::size_t count : {0u, 1u, 7u, 1000u}) {
      std::vector<int> touched(count, 0);
      std::size_t told = 0;
      share(
          count, 7, threads,
          [&](std::size_t done, std::size_t of) {
            told = std::max(told, done);
            BOOST_TEST(of == count);
          },
          [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
              ++touched[i];
          });
      BOOST_TEST(std::count(touched.begin(), touched.end(), 1) == std::ptrdiff_t(count));
      BOOST_TEST(told == count);
    }
}

BOOST_AUTO_TEST_CASE(the_first_fault_is_thrown) {
  for (int repetition = 0; repetition < 20; ++repetition)
    try {
      share(1000, 1, 4, {}, [](std::size_t first, std::size_t) {
        if (first % 100 == 37)
          throw std::runtime_error(std::to_string(first));
      });
      BOOST_ERROR("nothing was thrown");
    } catch (const std::runtime_error& fault) {
      BOOST_TEST(std::string(fault.what()) == "37");
    }
}
