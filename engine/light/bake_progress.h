#pragma once

#include <atomic>
#include <cstdint>

namespace hearth {

/// How far a bake is, in texels. The threads of the bake write it; any other may read it meanwhile.
class BakeProgress {
 public:
  /// Of the whole bake; 0 until its surfaces are known.
  std::int64_t texels() const { return texels_.load(std::memory_order_relaxed); }
  std::int64_t texelsDone() const { return done_.load(std::memory_order_relaxed); }

  void begin(std::int64_t texels) { texels_.store(texels, std::memory_order_relaxed); }
  /// More are to be done than was known when it began.
  void extend(std::int64_t texels) { texels_.fetch_add(texels, std::memory_order_relaxed); }
  void add(std::int64_t texels) { done_.fetch_add(texels, std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> texels_ = 0;
  std::atomic<std::int64_t> done_ = 0;
};

/// Counts the texels of one surface as done, in equal steps; its end counts those that are left.
class SurfaceProgress {
 public:
  SurfaceProgress(BakeProgress& bake, std::int64_t texels, std::int64_t steps)
      : bake_(bake), texels_(texels), steps_(steps) {}
  SurfaceProgress(const SurfaceProgress&) = delete;
  SurfaceProgress& operator=(const SurfaceProgress&) = delete;
  ~SurfaceProgress() { countTo(texels_); }

  void step() { countTo(texels_ * ++step_ / steps_); }

 private:
  void countTo(std::int64_t texels) {
    bake_.add(texels - counted_);
    counted_ = texels;
  }

  BakeProgress& bake_;
  std::int64_t texels_;
  std::int64_t steps_;
  std::int64_t step_ = 0;
  std::int64_t counted_ = 0;
};

}  // namespace hearth
