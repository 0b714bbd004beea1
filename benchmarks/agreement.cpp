// Do roads that share little lead to the same restitution? Tables of the largest differences go to standard output, the
// same to a CSV file; fails where two of ricochet's roads differ by more than the sum of their error estimates.
#include "agreement.hpp"

#include <ricochet/version.hpp>

#include <cstdlib>

namespace {
using namespace agreement;

/// How far two roads are apart where both found an end.
struct gap {
  double largest = 0, most_of_estimates = 0;
  std::size_t scenes = 0, at = 0;
};

/// \param exceeds told of each scene in which two roads with estimates differ by more than their sum, or one has no end
template <class Exceeds>
gap between(const road& one, const road& other, const Exceeds& exceeds) {
  gap found;
  const bool bounded = one.bounded() && other.bounded();
  for (std::size_t i = 0; i < std::min(one.e.size(), other.e.size()); ++i) {
    const double difference = std::abs(one.e[i] - other.e[i]);
    if (bounded) {
      const double allowed = one.estimate[i] + other.estimate[i] + std::numeric_limits<double>::epsilon();
      if (!(difference <= allowed)) // no number exceeds too
        exceeds(i, difference, allowed);
      found.most_of_estimates = std::max(found.most_of_estimates, difference / allowed);
    }
    if (!std::isfinite(difference))
      continue;
    ++found.scenes;
    if (difference > found.largest) {
      found.largest = difference;
      found.at = i;
    }
  }
  return found;
}
} // namespace

agreement::report::report(std::FILE* csv, std::size_t scenes) : count(scenes), csv_(csv) {
  std::fprintf(csv_,
               "# ricochet %s\n# %zu random scenes an instance, the same for all; `scenes` of them in which both found "
               "an end\n# tolerances: ricochet %g, in long double %g, in 50 digits %g; peers %g\n"
               "# units: tolerances, differences and estimates 1 (of the restitution); of_estimates: largest "
               "difference over the sum of both error estimates, none with peers\n"
               "instance,road,tolerance,other_road,other_tolerance,scenes,largest_difference,at_scene,of_estimates\n",
               version, count, of_ricochet, of_long_double, of_fifty_digits, of_peers);
}

void agreement::report::add(const std::string& instance, const std::vector<road>& roads,
                            const std::function<std::string(std::size_t)>& scene) {
  std::printf("%s\n  %2s  %-46s %9s %7s %9s\n", instance.c_str(), "", "road", "tolerance", "scenes", "estimate");
  for (std::size_t a = 0; a < roads.size(); ++a) {
    const road& one = roads[a];
    const auto lost = std::count_if(one.e.begin(), one.e.end(), [](double e) { return !std::isfinite(e); });
    std::printf("  %2zu  %-46s %9.0e %7zu", a + 1, one.name.c_str(), one.tolerance, one.e.size());
    if (one.bounded())
      std::printf(" %9.1e", *std::max_element(one.estimate.begin(), one.estimate.end()));
    if (lost)
      std::printf(" no end found in %td", lost);
    std::printf("\n");
  }
  std::printf("  largest differences of the restitution\n    ");
  for (std::size_t b = 0; b + 1 < roads.size(); ++b)
    std::printf(" %7zu", b + 1);
  std::printf("\n");
  double largest = 0, most = 0, largest_of_peers = 0;
  for (std::size_t a = 1; a < roads.size(); ++a) {
    std::printf("  %2zu", a + 1);
    for (std::size_t b = 0; b < a; ++b) {
      const gap found = between(roads[a], roads[b], [&](std::size_t i, double difference, double allowed) {
        if (++disagreements <= 20)
          std::fprintf(stderr, "%s, scene %zu: %s e = %.17g, %s e = %.17g: %.2e apart, estimates allow %.2e\n  %s\n",
                       instance.c_str(), i, roads[b].name.c_str(), roads[b].e[i], roads[a].name.c_str(), roads[a].e[i],
                       difference, allowed, scene(i).c_str());
      });
      std::printf(" %7.1e", found.largest);
      std::fprintf(csv_, "\"%s\",\"%s\",%g,\"%s\",%g,%zu,%.3e,%zu,", instance.c_str(), roads[b].name.c_str(),
                   roads[b].tolerance, roads[a].name.c_str(), roads[a].tolerance, found.scenes, found.largest,
                   found.at);
      if (roads[a].bounded() && roads[b].bounded()) {
        std::fprintf(csv_, "%.3g", found.most_of_estimates);
        largest = std::max(largest, found.largest);
        most = std::max(most, found.most_of_estimates);
      } else if (b == 0) {
        largest_of_peers = std::max(largest_of_peers, found.largest);
      }
      std::fprintf(csv_, "\n");
    }
    std::printf("\n");
  }
  std::printf(
      "  ricochet's roads are %.1e apart at most, %.2f of the sum of their estimates; peers %.1e from road 1\n\n",
      largest, most, largest_of_peers);
  std::fflush(stdout);
}

int main(int argc, char** argv) {
  const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000;
  if (argc < 2 || count == 0 || count % 40 != 0) {
    std::fprintf(stderr, "Usage: agreement TABLE.csv [SCENES], their number a multiple of 40\n");
    return 2;
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> csv(std::fopen(argv[1], "w"), std::fclose);
  if (!csv) {
    std::fprintf(stderr, "agreement: cannot write %s\n", argv[1]);
    return 2;
  }
  for (const auto& name : contenders::omitted())
    std::printf("omitted: %s\n", name.c_str());
  agreement::report all(csv.get(), count);
  agreement::without_adhesion(all);
  agreement::with_adhesion(all);
  agreement::with_crack_law(all);
  if (all.disagreements == 0) {
    std::printf("all of ricochet's roads agree within their error estimates\n");
    return 0;
  }
  std::printf("%zu pairs of ricochet's roads and scenes differ by more than their error estimates\n",
              all.disagreements);
  return 1;
}
