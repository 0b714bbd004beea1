// 01 Bounce: two bodies, one law, one impact.
//
// Without adhesion and damping the spheres return all of their energy; what is left to know is how long they are in
// contact. Here the closed form answers; nothing is integrated (0 evaluations).
//
// Try next: another radius, a flat_wall instead of the second sphere, a negative radius (and read the message).
#include <ricochet/collide.hpp>
#include <ricochet/law/elastic/hertz.hpp>

#include <cstdio>

int main() {
  using namespace ricochet;
  using namespace ricochet::units;

  const sphere bead{.solid = materials::steel, .radius = 1.5 * millimetres};
  const flat_wall plate{.solid = materials::steel};
  const auto model = compose(between(bead, plate), hertz{}, contact_duration{});
  const auto out = collide(model, impact{.speed = 0.5 * metres_per_second});

  std::printf("%s, e = %g, in contact for %.4g microseconds, %ld evaluations\n", name_of(out.ending), *out.restitution,
              1e6 * in_si(out.contact_duration), out.evaluations);
  return out.ending == ending::separated && *out.restitution == 1 ? 0 : 1;
}
