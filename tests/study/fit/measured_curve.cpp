#include <boost/test/unit_test.hpp>

#include <ricochet/study/fit/measured_curve.hpp>

#include <sstream>

using namespace ricochet;

namespace {
measured_curve read(const std::string& text) {
  std::istringstream in(text);
  return read_measurements(in, "data.csv");
}

void refused(const std::string& text, const std::string& sentence) {
  BOOST_CHECK_EXCEPTION(read(text), bad_input, [&](const bad_input& e) {
    BOOST_TEST(e.what() == sentence);
    return true;
  });
}
} // namespace

BOOST_AUTO_TEST_CASE(measurements_and_what_else_the_file_says) {
  const auto curve = read("\xEF\xBB\xBF# spheres: glass\r\n#material of the wall: steel\n\n"
                          "speed, restitution,error,\"note, free\"\r\n"
                          "0.5,captured,0.01,\"stuck, twice\"\n"
                          " 2 ,0.75,0.02,\n"
                          "# between rows, too\n"
                          "1e1,1.01,2e-2,fast");
  BOOST_TEST(curve.comments ==
                 (std::vector<std::string>{"spheres: glass", "material of the wall: steel", "between rows, too"}),
             boost::test_tools::per_element());
  BOOST_TEST(curve.columns == (std::vector<std::string>{"speed", "restitution", "error", "note, free"}),
             boost::test_tools::per_element());
  BOOST_TEST(curve.data.size() == 3);
  BOOST_TEST(in_si(curve.data[0].speed) == 0.5);
  BOOST_TEST(!curve.data[0].restitution.has_value());
  BOOST_TEST(curve.data[0].error == 0.01);
  BOOST_TEST(*curve.data[1].restitution == 0.75);
  BOOST_TEST(in_si(curve.data[2].speed) == 10);
  BOOST_TEST(curve.cells[0][3] == "stuck, twice");
  BOOST_TEST(curve.cells[1][3] == "");
  BOOST_TEST(curve.lines == (std::vector<std::size_t>{5, 6, 8}), boost::test_tools::per_element());
  BOOST_TEST(read("speed,restitution\n1,0.5\n").data[0].error == 0); // none is known
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_named) {
  refused("", "data.csv: there are no measurements in it");
  refused("speed,restitution\n", "data.csv, line 1: there are no measurements in it");
  refused("speed,e\n1,0.5\n", "data.csv, line 1: there is no column restitution in its header, \"speed,e\"");
  refused("speed,restitution,speed\n", "data.csv, line 1: there are two columns speed");
  const std::string header = "speed,restitution,error\n";
  refused(header + "1,0.5\n", "data.csv, line 2: 2 cells for 3 columns");
  refused(header + "1,,0.1\n",
          "data.csv, line 2: column restitution, value \"\": not a number, with a decimal point and no "
          "unit; of a pair that stuck, write captured");
  refused(header + "1,0.5,0.1\n1 m/s,0.5,0.1\n",
          "data.csv, line 3: column speed, value \"1 m/s\": not a number, with a decimal "
          "point and no unit");
  refused(header + "1,5,0,5,0,1\n", "data.csv, line 2: 6 cells for 3 columns; numbers have a decimal point");
  refused("speed;restitution\n", "data.csv, line 1: there is no column speed in its header, \"speed;restitution\"; "
                                 "columns are separated by commas, numbers have a decimal point");
  refused(header + "1,-0.5,0.1\n", "data.csv, line 2: restitution = -0.5 is outside [0, 1.5)");
  refused(header + "0,0.5,0.1\n", "data.csv, line 2: speed = 0 is outside (0, inf)");
  refused(header + "1,0.5,0\n", "data.csv, line 2: error = 0 is outside (0, inf)");
  refused(header + "1,nan,0.1\n", "data.csv, line 2: restitution = nan is outside [0, 1.5)");
  refused(header + "inf,0.5,0.1\n", "data.csv, line 2: speed = inf is outside (0, inf)");
  BOOST_CHECK_THROW(read_measurements(std::filesystem::path("no such file.csv")), std::runtime_error);
}
