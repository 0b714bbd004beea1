// 13 Population (builds on 09): spheres of many sizes, as they come from a bottle.
//
// Silver-coated glass spheres meet steel as in figure 6 of Brach & Dunn 1995. Their damping was fitted to one size at one
// speed; what a beam of all sizes does, how many stick and how e scatters, follows. That sizes are lognormal, nine
// tenths of them between those of the figure's curves, 5 and 13 um, is an assumption: the paper has their mean, 8.6 um
// (here 8.4), and that about nine tenths, by mass, should rebound no faster than those of 13 um.
//
// Try next: spread the speeds too, as the velocities of a gas are; ask at which speed half of the spheres stick.
#include <ricochet/collide.hpp>
#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/study/population.hpp>

#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace ricochet;
  using namespace ricochet::units;
  using closed_form::damping_coefficient_of_brach_dunn;

  const material glass{
      .youngs_modulus = 72.0 * gigapascals, .poissons_ratio = 0.21, .mass_density = 2600.0 * kilograms_per_cubic_metre};
  const material steel{.youngs_modulus = 207.0 * gigapascals,
                       .poissons_ratio = 0.27,
                       .mass_density = 7800.0 * kilograms_per_cubic_metre};

  // [population]
  const auto scene_of = [&](length diameter, speed v) {
    const auto pair = between(sphere{glass, 0.5 * diameter}, flat_wall{steel});
    return scene{compose(pair, hertz{},
                         line_force{.force_per_length = 250.0 * newtons_per_metre,
                                    .rebound_coefficient = damping_coefficient_of_brach_dunn(6.25, pair, v)},
                         hunt_crossley{.damping_coefficient = damping_coefficient_of_brach_dunn(10.45, pair, v)}),
                 impact{.speed = v}};
  };
  const double deviations = 1.6449; // within so many standard deviations lie nine tenths
  const auto beam_of = [&](speed v) {
    return [&, v](std::mt19937_64& random) {
      std::lognormal_distribution<double> diameter(std::log(std::sqrt(5. * 13.)), std::log(13. / 5.) / (2 * deviations));
      return scene_of(diameter(random) * micrometres, v);
    };
  };
  for (const double v : {1.0, 2.0, 2.8, 5.0, 10.0, 30.0}) {
    const population_sample beam = sample_population(beam_of(v * metres_per_second), 20'000);
    const auto stuck = beam.captured_fraction();
    const auto low = beam.quantile(0.05), middle = beam.quantile(0.5), high = beam.quantile(0.95);
    std::printf("%4g m/s: %.1f %% stick (%.1f to %.1f); e of 5, 50 and 95 %% is below %.3f, %.3f, %.3f\n", v,
                100 * stuck.value, 100 * stuck.low, 100 * stuck.high, low.value, middle.value, high.value);
  }
  // [population]

  // Larger spheres rebound faster: quantiles of e are what spheres of the sizes' own quantiles do.
  for (const double v : {5.0, 10.0}) {
    std::printf("%4g m/s: e of one size, 5, 8.06 and 13 um:", v);
    for (const double diameter : {5., std::sqrt(5. * 13.), 13.}) {
      const auto [model, impact] = scene_of(diameter * micrometres, v * metres_per_second);
      std::printf(" %.3f", collide(model, impact).restitution.value_or(0));
    }
    std::printf("\n");
  }

  if (argc > 1)
    sample_population(beam_of(5.0 * metres_per_second), 20'000)
        .write(std::string(argv[1]) + "/population.csv", "13_population " + std::string(argv[1]),
               "restitution of silver-coated glass spheres on steel at 5 m/s, diameters lognormal, nine tenths from 5 to "
               "13 um");
}
