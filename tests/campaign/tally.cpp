#include "tally.hpp"

#include <algorithm>
#include <numeric>

namespace campaign {

void keep_larger(record& largest, const record& other) {
  if (other.value > largest.value || (other.value == largest.value && other.index < largest.index))
    largest = other;
}

void tally::add(std::uint64_t index, verdict is, const finding& found) {
  ++count[std::size_t(is)];
  evaluations += found.evaluations;
  keep_larger(most_evaluations, {index, double(found.evaluations)});
  if (is == verdict::certified)
    keep_larger(largest_residual, {index, std::abs(found.ledger_residual)});
  if (is != verdict::certified && is != verdict::near && is != verdict::refused) {
    const std::string& said = is == verdict::wrong ? found.wrong : found.reason;
    auto words = said.substr(0, said.find_first_of("0123456789")); // so that like ones are counted together
    if (words.ends_with('-'))
      words.pop_back();
    const std::string kind = verdict_names[std::size_t(is)] + (words.empty() ? "" : ": " + words);
    const auto [place, is_new] = reasons.try_emplace(kind, 0, index);
    ++place->second.first;
    place->second.second = std::min(place->second.second, index);
  }
}

void tally::merge(const tally& other) {
  for (std::size_t i = 0; i < count.size(); ++i)
    count[i] += other.count[i];
  for (const auto& [kind, seen] : other.reasons) {
    auto& here = reasons.try_emplace(kind, 0, seen.second).first->second;
    here.first += seen.first;
    here.second = std::min(here.second, seen.second);
  }
  keep_larger(most_evaluations, other.most_evaluations);
  keep_larger(largest_residual, other.largest_residual);
  keep_larger(largest_error, other.largest_error);
  evaluations += other.evaluations;
  compared += other.compared;
}

long tally::total() const { return std::accumulate(count.begin(), count.end(), 0L); }

} // namespace campaign
