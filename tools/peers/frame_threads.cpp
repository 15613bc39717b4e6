// What two threads save of a frame.

#include <array>
#include <memory>

#include "math/parallel.h"
#include "peers/frame_phases.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr ImageSize kFullHd{1920, 1080};
constexpr ImageSize k4K{3840, 2160};
constexpr int kTurns = 2;

/// All shots in this size.
std::vector<Camera> camerasIn(ImageSize size, const PeerLevel& level) {
  std::vector<Camera> cameras = camerasOf(level.loaded.level);
  for (Camera& camera : cameras) camera.width = size.width, camera.height = size.height;
  return cameras;
}

/// Frames of all shots: on one thread, on two, and two at once that have nothing to do with one
/// another, which shows what two threads can gain here. Each shot in all three ways, one after the
/// other.
class ThreadedFrames {
 public:
  explicit ThreadedFrames(const PeerLevel& level)
      : renderer_(level.renderer), cameras_(camerasIn(kFullHd, level)) {}

  void measure(const Clock& clock) {
    drawAll(clock);  // caches that others have used are warm again
    for (PhaseTimes* times : {&one_, &two_, &pair_}) times->clear();
    for (int i = 0; i < kTurns; ++i) drawAll(clock);
  }

  /// `part` is color() or frame().
  Figures figures(double (PhaseTimes::*part)() const) const {
    const double one = (one_.*part)();
    const double two = (two_.*part)();
    return {one / two, one, two, 2 * one / (pair_.*part)()};
  }

 private:
  void drawAll(const Clock& clock) {
    for (const Camera& camera : cameras_) {
      ofPair_[0].draw(renderer_, camera, nullptr, one_, clock);
      ofTwo_.draw(renderer_, camera, &workers_, two_, clock);
      const auto each = [&](auto&& work) {
        workers_.run(ofPair_.size(), [&](std::size_t i) { work(ofPair_[i]); });
      };
      pair_.add(
          clock, [&] { each([&](Canvas& canvas) { canvas.find(renderer_, camera, nullptr); }); },
          [&] { each([&](Canvas& canvas) { canvas.color(renderer_, camera, nullptr); }); });
    }
  }

  const Renderer& renderer_;
  std::vector<Camera> cameras_;
  Canvas ofTwo_;
  std::array<Canvas, 2> ofPair_;  ///< the first one for frames on one thread, too
  Workers workers_{2};
  PhaseTimes one_;
  PhaseTimes two_;
  PhaseTimes pair_;
};

/// Frames of all shots in full HD on one thread, and each in 4K on two right after it.
class LargeFrames {
 public:
  explicit LargeFrames(const PeerLevel& level)
      : renderer_(level.renderer),
        small_(camerasIn(kFullHd, level)),
        large_(camerasIn(k4K, level)) {}

  Figures measure(const Clock& clock) {
    drawAll(clock);  // caches that others have used are warm again
    ofSmall_.clear();
    ofLarge_.clear();
    for (int i = 0; i < kTurns; ++i) drawAll(clock);
    return {ofLarge_.frame() / ofSmall_.frame(), ofLarge_.frame(), ofSmall_.frame(),
            ofLarge_.find(), ofLarge_.color()};
  }

 private:
  void drawAll(const Clock& clock) {
    for (std::size_t i = 0; i < small_.size(); ++i) {
      canvas_.draw(renderer_, small_[i], nullptr, ofSmall_, clock);
      largeCanvas_.draw(renderer_, large_[i], &workers_, ofLarge_, clock);
    }
  }

  const Renderer& renderer_;
  std::vector<Camera> small_;
  std::vector<Camera> large_;
  Canvas canvas_;
  Canvas largeCanvas_;
  Workers workers_{2};
  PhaseTimes ofSmall_;
  PhaseTimes ofLarge_;
};

/// The castle, on machines that run two threads at once.
tl::expected<const PeerLevel*, std::string> castleForThreads(PeerInputs& inputs) {
  if (availableThreads() < 2)
    return tl::unexpected<std::string>("this machine runs one thread at once");
  return inputs.level(inputs.castleFile());
}

Prepared prepareThreads(PeerInputs& inputs, double (PhaseTimes::*part)() const) {
  return castleForThreads(inputs).map([&](const PeerLevel* level) -> Measure {
    return [frames = std::make_shared<ThreadedFrames>(*level), part, &inputs] {
      frames->measure(inputs.clock());
      return frames->figures(part);
    };
  });
}

}  // namespace

Prepared prepareLargeFrames(PeerInputs& inputs) {
  return castleForThreads(inputs).map([&](const PeerLevel* level) -> Measure {
    return [frames = std::make_shared<LargeFrames>(*level), &inputs] {
      return frames->measure(inputs.clock());
    };
  });
}

Prepared prepareFrameThreads(PeerInputs& inputs) {
  return prepareThreads(inputs, &PhaseTimes::frame);
}

Prepared preparePaintThreads(PeerInputs& inputs) {
  return prepareThreads(inputs, &PhaseTimes::color);
}

}  // namespace hearth
