#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ricochet {

/// Told now and then, by one thread at a time, how much is done, and of how much.
using progress_callback = std::function<void(std::size_t done, std::size_t of)>;

namespace detail {

/// 0: as many as the machine has.
inline std::size_t thread_count(unsigned threads) {
  return threads ? threads : std::max(1u, std::thread::hardware_concurrency());
}

/// work(first, last) for parts of the numbers below `count`, on so many threads. Throws
/// what the first of the parts threw that threw something.
template <class Work>
void share(std::size_t count, std::size_t part, unsigned threads, const progress_callback& progress, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0, failed = count;
  std::exception_ptr failure;
  std::mutex telling;
  const auto run = [&] {
    for (std::size_t first; (first = next.fetch_add(part)) < count;) {
      const std::size_t last = std::min(first + part, count);
      try {
        work(first, last);
        if (progress) {
          const std::lock_guard lock(telling);
          progress(done += last - first, count);
        }
      } catch (...) {
        const std::lock_guard lock(telling);
        next = count;
        if (first < failed) {
          failed = first;
          failure = std::current_exception();
        }
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(thread_count(threads), (count + part - 1) / part); ++i)
      others.emplace_back(run);
    run();
  }
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace detail
} // namespace ricochet
