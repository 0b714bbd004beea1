// Error reached against time for it: every stepper and every peer over tolerances, on each instance. Writes a table to
// standard output; how far it is goes to standard error.
#include "work_precision.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  if (count == 0 || count % 40 != 0) {
    std::fprintf(stderr, "work_precision: the number of scenes has to be a multiple of 40\n");
    return 2;
  }
  for (const auto& name : contenders::omitted())
    std::printf("# omitted: %s\n", name.c_str());
  std::printf(
      "# omitted: packs and Verlet with a crack law; LAMMPS and LIGGGHTS (benchmarks/ratios runs them)\n"
      "# %zu random scenes an instance, the same for all; errors are absolute, of the restitution, against long "
      "double\n"
      "# units: tolerance, errors 1 (tolerance of Verlet: step over contact time); time us for a collision\n"
      "instance,contender,tolerance,largest_error,rms_error,time\n",
      count);
  work_precision::without_adhesion(count);
  work_precision::with_adhesion(count);
  work_precision::with_crack_law(count);
}
