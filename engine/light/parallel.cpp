#include "light/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace hearth {

int availableThreads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto drain = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i)
    helpers.emplace_back(drain);
  drain();
}

}  // namespace hearth
