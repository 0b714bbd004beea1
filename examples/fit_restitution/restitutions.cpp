#include "restitutions.hpp"
#include "solve_with.hpp"

#include <ricochet/batch/batch.hpp>

#include <limits>
#include <map>

namespace fit_restitution {

namespace {

using namespace collisions;
using laws = usual_laws;

template <class Outcome>
double restitution_of(const Outcome& out) {
  return out.ending == ricochet::ending::separated  ? *out.restitution
         : out.ending == ricochet::ending::captured ? 0
                                                    : std::numeric_limits<double>::quiet_NaN();
}

template <class Few, class... All>
bool is_one_of(const std::variant<All...>& law) {
  return std::visit(
      []<class Law>(const Law&) { return std::is_constructible_v<Few, std::in_place_type_t<Law>, const Law&>; }, law);
}

/// Is this file to solve it?
bool runs_in_batches(const scene& scene) {
  return is_one_of<laws::elastic>(scene.elastic) && is_one_of<laws::adhesion>(scene.adhesion) &&
         is_one_of<laws::crack>(scene.crack) && is_one_of<laws::damping>(scene.damping) &&
         std::holds_alternative<no_law>(scene.tangential) &&
         !std::holds_alternative<ricochet::thornton_ning_contact>(scene.plasticity);
}

/// Scenes that have these laws, or none, in these roles.
template <class Elastic, class Adhesion, class Crack, class Damping, class End>
std::vector<double> solve_alike(std::span<const scene> scenes, double tolerance, unsigned threads) {
  const auto laws_of = [](const scene& each) {
    return std::tuple_cat(if_present(std::get<Elastic>(each.elastic)), if_present(std::get<Adhesion>(each.adhesion)),
                          if_present(std::get<Crack>(each.crack)), if_present(std::get<Damping>(each.damping)),
                          if_present(std::get<End>(each.end)));
  };
  const auto solve = [&]<class... Present>(const Present&...) -> std::vector<double> {
    if constexpr (ricochet::composable<Present...>) {
      const auto model_of = [](const scene& each, const Present&... laws) {
        return ricochet::compose(each.pair, laws...);
      };
      std::vector<ricochet::scene<std::invoke_result_t<decltype(model_of), const scene&, const Present&...>>> batch;
      for (const scene& each : scenes)
        batch.push_back({std::apply(model_of, std::tuple_cat(std::tie(each), laws_of(each))),
                         ricochet::impact{each.speed}});
      auto outcomes = ricochet::collide(batch, {.tolerance = tolerance, .threads = threads});
      std::vector<double> e;
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (const auto* plastic = std::get_if<ricochet::thornton_ning>(&scenes[i].plasticity))
          ricochet::add_plastic_loss(outcomes[i], plastic->loss(scenes[i].pair, scenes[i].speed));
        e.push_back(restitution_of(outcomes[i]));
      }
      return e;
    } else {
      throw std::logic_error("laws that do not go together");
    }
  };
  return std::apply(solve, laws_of(scenes[0]));
}

std::vector<double> solve_batch(std::span<const scene> scenes, double tolerance, unsigned threads) {
  const scene& first = scenes[0];
  return std::visit([&]<class... Roles>(
                        const Roles&...) { return solve_alike<Roles...>(scenes, tolerance, threads); },
                    one_of<laws::elastic>(first.elastic), one_of<laws::adhesion>(first.adhesion),
                    one_of<laws::crack>(first.crack), one_of<laws::damping>(first.damping),
                    one_of<laws::end>(first.end));
}

} // namespace

std::vector<double> restitutions(std::span<const scene> scenes, double tolerance, unsigned threads) {
  std::vector<double> e(scenes.size());
  std::map<std::array<std::size_t, 5>, std::vector<std::size_t>> alike;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const scene& each = scenes[i];
    if (runs_in_batches(each))
      alike[{each.elastic.index(), each.adhesion.index(), each.crack.index(), each.damping.index(), each.end.index()}]
          .push_back(i);
    else
      others.push_back(i);
  }
  for (const auto& [composition, members] : alike) {
    std::vector<scene> batch;
    for (const std::size_t i : members)
      batch.push_back(scenes[i]);
    const std::vector<double> found = solve_batch(batch, tolerance, threads);
    for (std::size_t k = 0; k < members.size(); ++k)
      e[members[k]] = found[k];
  }
  ricochet::detail::share(others.size(), 1, threads, {}, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      e[others[k]] = restitution_of(solve_automatic(scenes[others[k]], tolerance));
  });
  return e;
}

} // namespace fit_restitution
