#include "math/parallel.h"

#include <algorithm>
#include <utility>

#include "math/check.h"

namespace hearth {

int availableThreads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

Workers::Workers(int threads) {
  CHECK(threads >= 1, threads);
  for (int i = 1; i < threads; ++i)
    helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
}

void Workers::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  {
    const std::scoped_lock lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    busy_ = helpers_.size();
    ++pieces_;
  }
  begun_.notify_all();
  drain();
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Workers::help(const std::stop_token& stop) {
  for (std::size_t seen = 0;; ++seen) {
    {
      std::unique_lock lock(mutex_);
      if (!begun_.wait(lock, stop, [&] { return pieces_ > seen; })) return;
    }
    drain();
    const std::scoped_lock lock(mutex_);
    if (--busy_ == 0) done_.notify_one();
  }
}

void Workers::drain() {
  try {
    for (std::size_t i = next_++; i < count_; i = next_++) (*work_)(i);
  } catch (...) {
    next_ = count_;  // the other threads stop after what they are at
    const std::scoped_lock lock(mutex_);
    if (!thrown_) thrown_ = std::current_exception();
  }
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const auto most = static_cast<int>(
      std::clamp<std::size_t>(count, 1, static_cast<std::size_t>(std::max(1, threads))));
  Workers(most).run(count, work);
}

}  // namespace hearth
