#include <boost/test/unit_test.hpp>

#include <ricochet/study/table.hpp>

#include <cmath>
#include <sstream>

namespace {
const std::filesystem::path file = std::filesystem::temp_directory_path() / "ricochet_table_test" / "rows.csv";
std::string content() {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}
} // namespace

BOOST_AUTO_TEST_CASE(a_table_says_what_is_in_it_and_gets_its_name_when_finished) {
  std::filesystem::remove_all(file.parent_path());
  ricochet::table out(file, "some command", "two columns", {{"speed", "m/s"}, {"restitution", "1"}});
  out.row({0.1, 1. / 3});
  out.row({8, std::nan("")});
  BOOST_TEST(!std::filesystem::exists(file));
  out.finish();
  BOOST_TEST(content() ==
             "# ricochet " + std::string(ricochet::version) +
                 "\n# command: some command\n# two columns\n# units: speed [m/s] restitution [1]\nspeed,restitution\n"
                 "0.10000000000000001,0.33333333333333331\n8,\n");
  BOOST_TEST(!std::filesystem::exists(file.string() + ".part"));
}

BOOST_AUTO_TEST_CASE(rows_of_the_wrong_length_and_files_that_cannot_be_are_refused) {
  ricochet::table out(file, "c", "a", {{"a", "1"}});
  BOOST_CHECK_THROW(out.row({1, 2}), std::runtime_error);
  std::ofstream(file.parent_path() / "plain") << "no directory";
  BOOST_CHECK_THROW(ricochet::table(file.parent_path() / "plain" / "rows.csv", "c", "a", {{"a", "1"}}), std::exception);
}
