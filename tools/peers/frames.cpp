// Frames of the tutorial and the castle.

#include <memory>

#include "peers/kernel_frames.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr PictureSize kSmall{320, 200};
constexpr PictureSize kLarge{1920, 1080};

/// Small frames are over so soon that a whole round of them is drawn again.
constexpr int kSmallRounds = 20;
constexpr int kLargeRounds = 2;

/// Frames of all shots in one size, on one thread.
class ShotFrames {
 public:
  ShotFrames(const Scene& scene, PictureSize size, int rounds)
      : scene_(scene), cameras_(camerasOf(scene.loaded.level)), rounds_(rounds), frames_(size, 1) {}

  FrameBench measure(const Clock& clock) {
    drawAll(clock);  // caches that others have used are warm again
    frames_.begin();
    for (int i = 0; i < rounds_; ++i) drawAll(clock);
    return frames_.result();
  }

 private:
  void drawAll(const Clock& clock) {
    for (const Camera& camera : cameras_) frames_.draw(scene_.renderer, camera, clock);
  }

  const Scene& scene_;
  std::vector<Camera> cameras_;
  int rounds_;
  FrameTimes frames_;
};

/// Large frames, and what the kernel takes for their spans.
class KernelTimes {
 public:
  explicit KernelTimes(const Scene& scene) : scene_(scene), kernel_(scene, kLarge) {}

  struct Times {
    FrameBench frame;
    double kernel;  ///< milliseconds
  };
  Times measure(const Clock& clock) {
    std::vector<double> ofKernel;
    drawAll(clock, ofKernel);  // warms the caches
    frames_.begin();
    ofKernel.clear();
    for (int i = 0; i < kLargeRounds; ++i) drawAll(clock, ofKernel);
    return {frames_.result(), spreadOf(ofKernel).median};
  }

 private:
  void drawAll(const Clock& clock, std::vector<double>& ofKernel) {
    const std::vector<Camera> cameras = camerasOf(scene_.loaded.level);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      frames_.draw(scene_.renderer, cameras[i], clock);
      const double begin = clock();
      drawKernelFrame(kernel_.frames()[i], strip_, pixels_);
      ofKernel.push_back(1e3 * (clock() - begin));
    }
  }

  const Scene& scene_;
  KernelFrames kernel_;
  FrameTimes frames_{kLarge, 1};
  std::vector<Pixel> strip_;
  std::vector<Pixel> pixels_;
};

Prepared prepareWrites(tl::expected<const Scene*, std::string> scene, const Clock& clock) {
  return scene.map([&](const Scene* of) -> Measure {
    const auto frames = std::make_shared<ShotFrames>(*of, kLarge, kLargeRounds);
    return [frames, &clock] {
      const FrameBench frame = frames->measure(clock);
      return Figures{frame.writes(), frame.milliseconds.median, frame.writeMilliseconds.median,
                     frame.findMilliseconds.median, frame.colorMilliseconds.median};
    };
  });
}

}  // namespace

Prepared prepareTutorialFrame(PeerInputs& inputs) {
  return inputs.scene(inputs.tutorialFile()).map([&](const Scene* scene) -> Measure {
    const auto frames = std::make_shared<ShotFrames>(*scene, kSmall, kSmallRounds);
    return [frames, &inputs] {
      const FrameBench frame = frames->measure(inputs.clock());
      return Figures{frame.milliseconds.median, frame.findMilliseconds.median,
                     frame.colorMilliseconds.median};
    };
  });
}

Prepared prepareKeepWrites(PeerInputs& inputs) {
  return prepareWrites(inputs.scene(inputs.keepFile()), inputs.clock());
}

Prepared prepareGreyKeepWrites(PeerInputs& inputs) {
  return prepareWrites(inputs.greyScene(inputs.keepFile()), inputs.clock());
}

Prepared prepareKernel(PeerInputs& inputs) {
  return inputs.scene(inputs.keepFile()).map([&](const Scene* scene) -> Measure {
    const auto times = std::make_shared<KernelTimes>(*scene);
    return [times, &inputs] {
      const auto [frame, kernel] = times->measure(inputs.clock());
      return Figures{frame.milliseconds.median / kernel, frame.milliseconds.median, kernel,
                     frame.findMilliseconds.median, frame.colorMilliseconds.median - kernel};
    };
  });
}

}  // namespace hearth
