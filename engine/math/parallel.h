#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace hearth {

/// All cores of the machine.
int availableThreads();

/// Threads that wait for work in pieces of a millisecond, so that work that comes again and again
/// starts no threads and takes no memory. One thread at a time may give them work.
class Workers {
 public:
  /// At least one. The thread that calls `run` is one of them, so one worker starts no thread.
  explicit Workers(int threads);

  int threads() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls work(i) for every i in [0, count) in no fixed order. `work` must write only to data of
  /// i. If it throws, the first exception is rethrown once all threads have stopped; the remaining
  /// indices are then left out.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void help(const std::stop_token& stop);
  void drain();

  const std::function<void(std::size_t)>* work_ = nullptr;  ///< of the piece at hand
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::exception_ptr thrown_;

  std::mutex mutex_;  ///< guards what follows, and all of the above while no thread is at work
  std::condition_variable_any begun_;
  std::condition_variable done_;
  std::size_t pieces_ = 0;             ///< begun so far
  std::size_t busy_ = 0;               ///< helpers that are not done with the piece at hand
  std::vector<std::jthread> helpers_;  ///< last: they are stopped before what they use is gone
};

/// The same, with threads that end with the work.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace hearth
