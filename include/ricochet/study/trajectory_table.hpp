#pragma once
#include <ricochet/outcome/outcome.hpp>
#include <ricochet/study/table.hpp>

#include <concepts>

namespace ricochet {

/// Writes the motion that was asked for with trajectory{} as a CSV file, one row a state, losses where the ledger was
/// asked for too. \throws std::runtime_error if the file cannot be written.
template <std::derived_from<trajectory_columns<std::vector<double>>> Columns>
void write_trajectory(const std::filesystem::path& file, const std::string& command, const Columns& motion) {
  struct named {
    column head;
    const std::vector<double>* values;
  };
  std::vector<named> all{{{"time", "s"}, &motion.time},
                         {{"mutual_approach", "m"}, &motion.mutual_approach},
                         {{"approach_rate", "m/s"}, &motion.approach_rate},
                         {{"contact_radius", "m"}, &motion.contact_radius},
                         {{"elastic_force", "N"}, &motion.elastic_force},
                         {{"damping_force", "N"}, &motion.damping_force},
                         {{"kinetic_energy", "J"}, &motion.kinetic_energy},
                         {{"elastic_energy", "J"}, &motion.elastic_energy},
                         {{"surface_energy", "J"}, &motion.surface_energy},
                         {{"crack_loss", "J"}, &motion.crack_loss},
                         {{"bulk_loss", "J"}, &motion.bulk_loss}};
  if constexpr (requires { motion.plastic_loss; })
    all.push_back({{"plastic_loss", "J"}, &motion.plastic_loss});
  std::vector<column> columns;
  for (const named& each : all)
    if (each.values->size() == motion.time.size())
      columns.push_back(each.head);
  table out(file, command, "motion of one collision; losses up to the row, jumps at touch and at letting go included",
            columns);
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    std::vector<double> row;
    for (const named& each : all)
      if (each.values->size() == motion.time.size())
        row.push_back((*each.values)[i]);
    out.row(row);
  }
  out.finish();
}

} // namespace ricochet
