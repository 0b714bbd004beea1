// Boost.Test's own code and main(), compiled once for all test programs.
#define BOOST_TEST_MODULE ricochet
#include <boost/test/included/unit_test.hpp>
