#include <boost/test/unit_test.hpp>

#include "support/reference_rows.hpp"

#include <ricochet/study/trajectory_table.hpp>

using namespace support;

namespace {
std::string header_of(const std::filesystem::path& file, std::size_t& rows) {
  std::ifstream in(file);
  std::string line, header;
  for (rows = 0; std::getline(in, line);)
    if (line[0] != '#')
      header.empty() ? void(header = line) : void(++rows);
  return header;
}
} // namespace

BOOST_AUTO_TEST_CASE(a_trajectory_is_written_with_its_energies_and_its_losses_where_asked_for) {
  const ice_case ice;
  const auto file = std::filesystem::temp_directory_path() / "ricochet_trajectory_test.csv";
  const impact fast{8.0 * metres_per_second};
  std::size_t rows = 0;
  const auto bare = collide(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, trajectory{}), fast);
  write_trajectory(file, "test", bare.trajectory);
  const std::string columns = "time,mutual_approach,approach_rate,contact_radius,elastic_force,damping_force,"
                              "kinetic_energy,elastic_energy,surface_energy";
  BOOST_TEST(header_of(file, rows) == columns);
  BOOST_TEST(rows == bare.trajectory.time.size());
  const auto full =
      collide(compose(ice.pair, hertz{}, ice.adhesive, ice.viscous, ice.fitted(), trajectory{}, energy_ledger{}), fast);
  write_trajectory(file, "test", full.trajectory);
  BOOST_TEST(header_of(file, rows) == columns + ",crack_loss,bulk_loss");
  const auto flowing = collide(compose(ice.pair, hertz{}, ice.adhesive, thornton_ning_contact{200.0 * megapascals},
                                       trajectory{}, energy_ledger{}),
                               fast);
  write_trajectory(file, "test", flowing.trajectory);
  BOOST_TEST(header_of(file, rows) == columns + ",crack_loss,bulk_loss,plastic_loss");
  std::filesystem::remove(file);
}
