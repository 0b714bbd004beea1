// Makes examples/fit_restitution/ice.csv: restitutions of water-ice grains as the exact crack law has them, with noise.
#include <ricochet/collide.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/study/sweep.hpp>

#include <cstdio>
#include <random>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;
  const sphere grain{.solid = materials::water_ice, .radius = 2.0 * micrometres};
  const duration relaxation_time = 1.2e-11 * seconds;
  const auto model =
      compose(between(grain, grain), hertz{}, jkr{0.7 * joules_per_square_metre},
              greenwood{.relaxation_time = relaxation_time, .modulus_ratio = 0.02, .interaction_range = 0.3 * nanometres},
              kuwabara_kono{bulk_time_of_krijt(relaxation_time, 0.25)}, thornton_ning{300.0 * megapascals});
  std::puts("# Made up: e of two water-ice grains of radius 2 um with w = 0.7 J/m^2, T_vis = 1.2e-11 s, Y = 300 MPa and");
  std::puts("# normal noise of standard deviation 0.01 (CMake target synthetic_curve).\nspeed,restitution,error");
  std::mt19937_64 source(1);
  std::normal_distribution<double> noise(0, 0.01);
  for (const speed& v : logarithmic_speeds(2.0 * metres_per_second, 60.0 * metres_per_second, 24)) {
    if (const auto e = collide(model, impact{v}).restitution)
      std::printf("%.4g,%.4f,0.01\n", in_si(v), *e + noise(source));
    else
      std::printf("%.4g,captured,0.01\n", in_si(v));
  }
}
