// Frames of the tutorial and the castle.

#include <memory>

#include "hearth/bench/kernel_frames.h"
#include "hearth/bench/peer_inputs.h"
#include "hearth/bench/peer_rows.h"
#include "math/parallel.h"

namespace hearth {

namespace {

constexpr PictureSize kSmall{320, 200};
constexpr PictureSize kLarge{1920, 1080};

/// Small frames are over so soon that a whole round of them is drawn again.
constexpr int kSmallRounds = 20;
constexpr int kLargeRounds = 2;

/// Frames of one size on several numbers of threads, each shot with one after the other.
class ShotFrames {
 public:
  ShotFrames(const Scene& scene, PictureSize size, const std::vector<int>& threadCounts, int rounds)
      : scene_(scene), cameras_(camerasOf(scene.loaded.level)), rounds_(rounds) {
    for (const int threads : threadCounts) frames_.emplace_back(size, threads);
  }

  /// By the numbers of threads.
  std::vector<FrameBench> measure(const Clock& clock) {
    drawAll(clock);  // caches that others have used are warm again
    for (FrameTimes& frames : frames_) frames.begin();
    for (int i = 0; i < rounds_; ++i) drawAll(clock);
    std::vector<FrameBench> results;
    for (const FrameTimes& frames : frames_) results.push_back(frames.result());
    return results;
  }

 private:
  void drawAll(const Clock& clock) {
    for (const Camera& camera : cameras_)
      for (FrameTimes& frames : frames_) frames.draw(scene_.renderer, camera, clock);
  }

  const Scene& scene_;
  std::vector<Camera> cameras_;
  int rounds_;
  std::vector<FrameTimes> frames_;
};

/// The second phase of large frames, on one thread and on two.
class PaintTimes {
 public:
  explicit PaintTimes(const Scene& scene)
      : scene_(scene), cameras_(camerasOf(scene.loaded.level)) {}

  /// One thread's milliseconds, and those of two.
  std::pair<double, double> measure(const Clock& clock) {
    std::vector<double> one;
    std::vector<double> two;
    for (int round = 0; round <= kLargeRounds; ++round)
      for (const Camera& camera : cameras_) {
        const double ofOne = paint(camera, 1, clock);
        const double ofTwo = paint(camera, 2, clock);
        if (round == 0) continue;  // warms the caches
        one.push_back(ofOne);
        two.push_back(ofTwo);
      }
    return {spreadOf(one).median, spreadOf(two).median};
  }

 private:
  double paint(Camera camera, int threads, const Clock& clock) {
    camera.width = kLarge.width;
    camera.height = kLarge.height;
    scene_.renderer.findSpans(camera, scratch_, picture_);
    const double begin = clock();
    scene_.renderer.paintSpans(camera, LightMode::Both, scratch_, picture_, threads);
    return 1e3 * (clock() - begin);
  }

  const Scene& scene_;
  std::vector<Camera> cameras_;
  FrameScratch scratch_;
  Image picture_;
};

/// Large frames, and what the kernel takes for their spans.
class KernelTimes {
 public:
  explicit KernelTimes(const Scene& scene) : scene_(scene), kernel_(scene, kLarge) {}

  /// A frame's milliseconds, and the kernel's.
  std::pair<double, double> measure(const Clock& clock) {
    std::vector<double> ofFrames;
    std::vector<double> ofKernel;
    const std::vector<Camera> cameras = camerasOf(scene_.loaded.level);
    for (int round = 0; round <= kLargeRounds; ++round)
      for (std::size_t i = 0; i < cameras.size(); ++i) {
        const double frame = drawFrame(cameras[i], clock);
        const double begin = clock();
        drawKernelFrame(kernel_.frames()[i], strip_, pixels_);
        const double kernel = 1e3 * (clock() - begin);
        if (round == 0) continue;  // warms the caches
        ofFrames.push_back(frame);
        ofKernel.push_back(kernel);
      }
    return {spreadOf(ofFrames).median, spreadOf(ofKernel).median};
  }

 private:
  double drawFrame(Camera camera, const Clock& clock) {
    camera.width = kLarge.width;
    camera.height = kLarge.height;
    const double begin = clock();
    scene_.renderer.draw(camera, LightMode::Both, scratch_, picture_);
    return 1e3 * (clock() - begin);
  }

  const Scene& scene_;
  KernelFrames kernel_;
  FrameScratch scratch_;
  Image picture_;
  std::vector<Pixel> strip_;
  std::vector<Pixel> pixels_;
};

std::optional<std::string> missingThreads() {
  if (availableThreads() >= 2) return std::nullopt;
  return "this machine runs one thread at once";
}

}  // namespace

Prepared prepareTutorialFrame(PeerInputs& inputs) {
  return inputs.scene(inputs.tutorialFile()).map([&](const Scene* scene) -> Measure {
    const auto frames = std::make_shared<ShotFrames>(*scene, kSmall, std::vector{1}, kSmallRounds);
    return [frames, &inputs] {
      return Figures{frames->measure(inputs.clock()).front().milliseconds.median};
    };
  });
}

Prepared prepareKeepWrites(PeerInputs& inputs) {
  return inputs.scene(inputs.keepFile()).map([&](const Scene* scene) -> Measure {
    const auto frames = std::make_shared<ShotFrames>(*scene, kLarge, std::vector{1}, kLargeRounds);
    return [frames, &inputs] {
      const FrameBench frame = frames->measure(inputs.clock()).front();
      return Figures{frame.writes(), frame.milliseconds.median, frame.writeMilliseconds.median};
    };
  });
}

Prepared prepareKernel(PeerInputs& inputs) {
  return inputs.scene(inputs.keepFile()).map([&](const Scene* scene) -> Measure {
    const auto times = std::make_shared<KernelTimes>(*scene);
    return [times, &inputs] {
      const auto [frame, kernel] = times->measure(inputs.clock());
      return Figures{frame / kernel, frame, kernel};
    };
  });
}

Prepared prepareFrameThreads(PeerInputs& inputs) {
  if (const auto missing = missingThreads()) return tl::unexpected(*missing);
  return inputs.scene(inputs.keepFile()).map([&](const Scene* scene) -> Measure {
    const auto frames =
        std::make_shared<ShotFrames>(*scene, kLarge, std::vector{1, 2}, kLargeRounds);
    return [frames, &inputs] {
      const std::vector<FrameBench> found = frames->measure(inputs.clock());
      const double one = found[0].milliseconds.median;
      const double two = found[1].milliseconds.median;
      return Figures{one / two, one, two};
    };
  });
}

Prepared preparePaintThreads(PeerInputs& inputs) {
  if (const auto missing = missingThreads()) return tl::unexpected(*missing);
  return inputs.scene(inputs.keepFile()).map([&](const Scene* scene) -> Measure {
    const auto times = std::make_shared<PaintTimes>(*scene);
    return [times, &inputs] {
      const auto [one, two] = times->measure(inputs.clock());
      return Figures{one / two, one, two};
    };
  });
}

}  // namespace hearth
