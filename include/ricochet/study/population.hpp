// What becomes of many collisions whose sizes, speeds or materials are distributed.
#pragma once
#include <ricochet/batch/batch.hpp>
#include <ricochet/study/table.hpp>

#include <boost/math/distributions/binomial.hpp>

#include <random>

namespace ricochet {

/// seed: of the random numbers. tolerance, max_evaluations, threads, progress: as in batch_options.
struct population_options {
  std::uint64_t seed = 1;
  double tolerance = 1e-6;
  long max_evaluations = batch_options{}.max_evaluations;
  unsigned threads = 0;
  progress_callback progress = {};
};

/// A number estimated from a sample, and the interval that holds the true one with the confidence asked for.
struct sampled {
  double value, low, high;
};

/// How many collisions of a sample ended how.
struct population_counts {
  std::size_t separated = 0, captured = 0;
  std::size_t uncertain = 0;              ///< of both: so near the threshold that they may stick or not
  std::size_t unresolved = 0, failed = 0; ///< \see ending
};

/// Collisions of a population: their restitutions, zero for pairs that stick, and how many could not be resolved, or
/// failed, which are in nothing else.
class population_sample {
public:
  population_sample(std::vector<double> restitutions, const population_counts& counts)
      : restitutions_(std::move(restitutions)), counts_(counts) {
    std::sort(restitutions_.begin(), restitutions_.end());
  }

  const population_counts& counts() const { return counts_; }
  const std::vector<double>& restitutions() const { return restitutions_; } ///< in ascending order

  /// Share of the pairs that stick, with Clopper & Pearson's interval. confidence: 0 to below 1
  sampled captured_fraction(double confidence = 0.95) const {
    require("confidence", confidence, range{.high = 1});
    using distribution = boost::math::binomial_distribution<>;
    const double n = double(size()), k = double(counts_.captured), outside = (1 - confidence) / 2;
    return {k / n, distribution::find_lower_bound_on_p(n, k, outside),
            distribution::find_upper_bound_on_p(n, k, outside)};
  }

  /// Restitution that a share p of the pairs stays below, with an interval from order statistics, whatever the
  /// distribution; its ends are 0 and 1 where the sample is too small to tell. p: above 0, below 1
  sampled quantile(double p, double confidence = 0.95) const {
    require("p", p, range{.high = 1, .low_included = false});
    require("confidence", confidence, range{.high = 1});
    using namespace boost::math::policies;
    using rounded_down = boost::math::binomial_distribution<double, policy<discrete_quantile<integer_round_down>>>;
    using rounded_up = boost::math::binomial_distribution<double, policy<discrete_quantile<integer_round_up>>>;
    const double n = double(size()), outside = (1 - confidence) / 2;
    const rounded_down below(n, p);    // how many of the sample are below the true quantile
    const auto at = [&](double rank) { // from 1
      return rank < 1 ? 0. : rank > n ? 1. : restitutions_[std::size_t(rank) - 1];
    };
    const double few = boost::math::quantile(below, outside);
    const double many = boost::math::quantile(complement(rounded_up(n, p), outside));
    double rank = std::max(1., std::ceil(n * p));
    if ((rank - 1) / n >= p) // n p is a whole number but for round-off
      --rank;
    return {at(std::max(1., rank)), at(cdf(below, few) <= outside ? few + 1 : 0), at(many + 1)};
  }

  /// Share of the pairs with no larger a restitution.
  double share_up_to(double e) const {
    return double(std::upper_bound(restitutions_.begin(), restitutions_.end(), e) - restitutions_.begin()) /
           double(size());
  }

  /// Shares of all pairs that rebound with a restitution in each of so many equal parts of [0, 1].
  std::vector<double> histogram(std::size_t parts) const {
    require("parts", double(parts), range{.low = 1});
    std::vector<double> shares(parts);
    const double each = 1 / double(size());
    for (const double e : std::span(restitutions_).subspan(counts_.captured))
      shares[std::min(parts - 1, std::size_t(e * double(parts)))] += each;
    return shares;
  }

  /// Mean restitution, and mean of its square, the share of kinetic energy that is left, each with its standard error
  /// below and above (not an interval of a chosen confidence); pairs that stick count as zero.
  sampled mean() const {
    return mean_of(0, [](double e) { return e; });
  }
  sampled mean_square() const {
    return mean_of(0, [](double e) { return e * e; });
  }
  /// Mean restitution of the pairs that do not stick. \throws bad_input if all do
  sampled mean_of_rebounding() const {
    if (size() == counts_.captured)
      throw bad_input("population: no collision of the sample rebounds");
    return mean_of(counts_.captured, [](double e) { return e; });
  }

  /// The distribution as a table: restitution, and share of the pairs up to it, in steps of `steps` equal shares.
  void write(const std::filesystem::path& file, const std::string& command, const std::string& about,
             std::size_t steps = 200) const {
    require("steps", double(steps), range{.low = 1});
    table out(file, command, about, {{"restitution", "1"}, {"share_up_to", "1"}});
    for (std::size_t i = 0; i <= steps; ++i) {
      const double e = restitutions_[std::min(size() - 1, i * size() / steps)];
      out.row({e, share_up_to(e)});
    }
    out.finish();
  }

private:
  std::size_t size() const {
    if (restitutions_.empty())
      throw bad_input("population: no collision of the sample is resolved");
    return restitutions_.size();
  }

  template <class Function>
  sampled mean_of(std::size_t first, const Function& f) const { // of the first in ascending order, and all after it
    double sum = 0, squares = 0;
    const double n = double(size() - first);
    const auto some = std::span(restitutions_).subspan(first);
    for (const double e : some)
      sum += f(e);
    for (const double e : some)
      squares += square(f(e) - sum / n);
    const double error = n > 1 ? std::sqrt(squares / (n * (n - 1))) : std::numeric_limits<double>::infinity();
    return {sum / n, sum / n - error, sum / n + error};
  }

  std::vector<double> restitutions_;
  population_counts counts_;
};

/// `count` collisions drawn at random, in batches. draw(random) makes a scene from an std::mt19937_64; its model has no
/// tangential law; it is called by several threads at once, and keeps nothing from one call to the next (make
/// std:: distributions inside it). The k-th is the same whatever `count` and the number of threads are.
/// \throws bad_input if count is 0, and, with the member's number, if draw or collide() refuse a scene
template <class Draw>
population_sample sample_population(const Draw& draw, std::size_t count, const population_options& options = {}) {
  using scene_type = std::invoke_result_t<const Draw&, std::mt19937_64&>;
  require("count", double(count), range{.low = 1});
  constexpr std::size_t stream = 256, chunk = 256 * stream; // collisions of one stream of random numbers; in memory
  detail::admit(collide_options{.tolerance = options.tolerance, .max_evaluations = options.max_evaluations});
  std::vector<double> restitutions;
  restitutions.reserve(count);
  population_counts counts;
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t here = std::min(chunk, count - first);
    std::vector<std::vector<scene_type>> drawn((here + stream - 1) / stream);
    detail::share(drawn.size(), 1, options.threads, {}, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        const std::uint64_t number = first / stream + i;
        std::seed_seq seed{std::uint32_t(options.seed), std::uint32_t(options.seed >> 32), std::uint32_t(number),
                           std::uint32_t(number >> 32)};
        std::mt19937_64 random(seed);
        for (std::size_t k = i * stream; k < std::min((i + 1) * stream, here); ++k)
          try {
            drawn[i].push_back(draw(random));
            detail::admit<decltype(drawn[i].back().model)>(drawn[i].back().impact);
          } catch (const bad_input& e) {
            throw bad_input("member " + std::to_string(first + k) + ": " + e.what());
          }
      }
    });
    std::vector<scene_type> scenes;
    scenes.reserve(here);
    for (const auto& each : drawn)
      scenes.insert(scenes.end(), each.begin(), each.end());
    batch_options how{
        .tolerance = options.tolerance, .max_evaluations = options.max_evaluations, .threads = options.threads};
    if (options.progress)
      how.progress = [&](std::size_t done, std::size_t) { options.progress(first + done, count); };
    for (const auto& out : collide(scenes, how)) {
      const bool separated = out.ending == ending::separated, captured = out.ending == ending::captured;
      counts.separated += separated;
      counts.captured += captured;
      counts.uncertain += (separated || captured) && !out.ending_is_certain;
      counts.unresolved += out.ending == ending::unresolved;
      counts.failed += out.ending == ending::failed;
      if (separated || captured)
        restitutions.push_back(out.restitution.value_or(0));
    }
  }
  return {std::move(restitutions), counts};
}

} // namespace ricochet
