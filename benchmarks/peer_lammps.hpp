// 1000 separate pairs of spheres in LAMMPS, `pair granular`, as its manual has it: Hertz with the damping of Kuwabara
// and Kono (`hertz`, `damping viscoelastic`), velocity Verlet with a fixed step, contacts that end at zero overlap.
#pragma once
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace peer {

/// Pairs of equal spheres that touch and meet at this speed; ten kinds of them, in SI.
struct pairs_of_spheres {
  static constexpr std::size_t kinds = 10, count = 1000;
  double radius = 1e-3, mass_density = 1000, speed = 0.1, reduced_modulus = 16e6 / 3;

  double mass() const { return 4. / 3 * std::numbers::pi * radius * radius * radius * mass_density; }
  double contact_time() const { // Hertz's
    const double m = mass() / 2, R = radius / 2;
    return 2.8682656992 * std::pow(m * m / (R * reduced_modulus * reduced_modulus * speed), 0.2);
  }
};

/// Restitution of each pair, and seconds on the wall for as many steps as a Hertzian contact takes.
struct discrete_elements_result {
  std::vector<double> restitution;
  double seconds = 0;
};

/// A discrete-element code run in a directory of its own, which is removed.
class discrete_elements_run {
public:
  explicit discrete_elements_run(const pairs_of_spheres& pairs) : pairs_(pairs) {
    std::string name = std::filesystem::temp_directory_path() / "ricochet_XXXXXX";
    if (!mkdtemp(name.data()))
      throw std::runtime_error("no directory for a discrete-element run: " + name);
    directory_ = name;
    write_data();
  }
  ~discrete_elements_run() { std::filesystem::remove_all(directory_); }
  discrete_elements_run(const discrete_elements_run&) = delete;

  static bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
  }

  /// `commands` up to the runs, of which there are two: as long as a Hertzian contact, and until all are apart.
  /// `format`: how the code says that an output's format follows.
  discrete_elements_result operator()(const std::string& program, const std::string& commands, double steps_per_contact,
                                      const std::string& format = "format line") const {
    std::ofstream input(directory_ / "input");
    input << commands << "timestep " << pairs_.contact_time() / steps_per_contact << "\nrun " << long(steps_per_contact)
          << "\nrun " << long(2 * steps_per_contact) << "\nwrite_dump all custom velocities id vx modify sort id "
          << format << " \"%d %.17g\"\n";
    input.close();
    const std::string run = "cd " + directory_.string() + " && OMP_NUM_THREADS=1 " + program +
                            " -in input -log log -screen none >output 2>&1";
    if (std::system(run.c_str()) != 0)
      return {};
    return {restitution(), first_loop_time()};
  }

private:
  void write_data() const {
    std::ofstream data(directory_ / "data");
    const double apart = 10 * pairs_.radius;
    const std::size_t side = 32; // pairs in a row
    data << "pairs\n\n"
         << 2 * pairs_.count << " atoms\n"
         << pairs_.kinds << " atom types\n\n0 " << apart * double(side) << " xlo xhi\n0 " << apart * double(side)
         << " ylo yhi\n0 " << apart << " zlo zhi\n\nAtoms\n\n";
    data.precision(17);
    const auto each = [&](const auto& write) {
      for (std::size_t i = 0; i < pairs_.count; ++i)
        for (const int sign : {-1, 1})
          write(2 * i + (sign > 0 ? 2 : 1), i, sign);
    };
    each([&](std::size_t id, std::size_t i, int sign) {
      data << id << ' ' << i % pairs_.kinds + 1 << ' ' << 2 * pairs_.radius << ' ' << pairs_.mass_density << ' '
           << (double(i % side) + 0.5) * apart + sign * pairs_.radius << ' ' << (double(i / side) + 0.5) * apart << ' '
           << apart / 2 << '\n';
    });
    data << "\nVelocities\n\n";
    each([&](std::size_t id, std::size_t, int sign) {
      data << id << ' ' << -sign * pairs_.speed / 2 << " 0 0 0 0 0\n";
    });
  }

  std::vector<double> restitution() const {
    std::ifstream dump(directory_ / "velocities");
    std::string line;
    while (std::getline(dump, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
    }
    std::vector<double> e;
    long id;
    for (double left, right; dump >> id >> left >> id >> right;)
      e.push_back((right - left) / pairs_.speed);
    return e;
  }

  double first_loop_time() const {
    std::ifstream log(directory_ / "log");
    for (std::string line; std::getline(log, line);)
      if (double seconds; std::sscanf(line.c_str(), "Loop time of %lf", &seconds) == 1)
        return seconds;
    return 0;
  }

  pairs_of_spheres pairs_;
  std::filesystem::path directory_;
};

/// `bulk_times` of the kinds, in seconds.
inline discrete_elements_result lammps(const pairs_of_spheres& pairs, const std::vector<double>& bulk_times,
                                       double steps_per_contact) {
  std::ostringstream commands;
  commands.precision(17);
  commands << "units si\natom_style sphere\nboundary p p p\nnewton off\ncomm_modify vel yes\nread_data data\n"
              "pair_style granular\n";
  const auto coefficients = [&](const std::string& kind, double A) {
    commands << "pair_coeff " << kind << " hertz " << 4. / 3 * pairs.reduced_modulus << ' '
             << 2 * A * pairs.reduced_modulus / (pairs.mass() / 2)
             << " tangential linear_nohistory 0 0 damping viscoelastic\n";
  };
  coefficients("* *", 0);
  for (std::size_t kind = 0; kind < bulk_times.size(); ++kind)
    coefficients(std::to_string(kind + 1) + ' ' + std::to_string(kind + 1), bulk_times[kind]);
  commands << "neighbor " << pairs.radius << " bin\nfix 1 all nve/sphere\nthermo 1000000\n";
  return discrete_elements_run(pairs)("lmp", commands.str(), steps_per_contact);
}

} // namespace peer
