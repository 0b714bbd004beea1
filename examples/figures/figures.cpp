// The numbers behind the figures of Krijt et al. 2013 and of Brach & Dunn 1995, each computed anew, and behind one of
// the measurements of Kharaz et al. 2001, one CSV file a figure; the .gp files of the same names draw them. Krijt's
// figure 4 is drawn from restitution_curves.csv.
//
// usage: figures [output directory]
#include "figures.hpp"

#include <chrono>
#include <cstdio>

int main(int count, char** arguments) {
  const std::string directory = count > 1 ? arguments[1] : "out/figures";
  if (count > 2 || directory.starts_with("-")) {
    std::fprintf(stderr, "usage: figures [output directory]\n");
    return 2;
  }
  try {
    const auto begin = std::chrono::steady_clock::now();
    figures::krijt_2013(directory);
    figures::brach_dunn_1995(directory);
    figures::kharaz_2001(directory);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::printf("computed in %.1f s; written to %s\n", taken.count(), directory.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figures: %s\n", error.what());
    return 1;
  }
}
