#include "math/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace hearth {

int availableThreads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::once_flag isThrown;
  std::exception_ptr thrown;
  const auto drain = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;  // the other threads stop after what they are at
      std::call_once(isThrown, [&] { thrown = std::current_exception(); });
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i)
      helpers.emplace_back(drain);
    drain();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace hearth
