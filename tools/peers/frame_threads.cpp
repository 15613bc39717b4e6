// What two threads save of a frame.

#include <array>
#include <memory>

#include "math/parallel.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr ImageSize kFullHd{1920, 1080};
constexpr int kTurns = 2;

/// Of frames, milliseconds of their two phases.
class PhaseTimes {
 public:
  /// Of work that does one after the other.
  template <typename Find, typename Color>
  void add(const Clock& clock, Find&& find, Color&& color) {
    const double begin = clock();
    find();
    const double found = clock();
    color();
    const double end = clock();
    colors_.push_back(1e3 * (end - found));
    frames_.push_back(1e3 * (end - begin));
  }

  void clear() { colors_.clear(), frames_.clear(); }

  double color() const { return spreadOf(colors_).median; }
  double frame() const { return spreadOf(frames_).median; }

 private:
  std::vector<double> colors_;
  std::vector<double> frames_;
};

/// Frames of all shots: on one thread, on two, and two at once that have nothing to do with one
/// another, which shows what two threads can gain here. Each shot in all three ways, one after the
/// other.
class ThreadedFrames {
 public:
  explicit ThreadedFrames(const PeerLevel& level)
      : renderer_(level.renderer), cameras_(camerasOf(level.loaded.level)) {
    for (Camera& camera : cameras_) camera.width = kFullHd.width, camera.height = kFullHd.height;
  }

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
  struct Canvas {
    FrameScratch scratch;
    PixelBuffer memory;
  };

  void drawAll(const Clock& clock) {
    for (const Camera& camera : cameras_) {
      draw(camera, nullptr, ofPair_[0], one_, clock);
      draw(camera, &workers_, ofTwo_, two_, clock);
      const auto each = [&](auto&& work) {
        workers_.run(ofPair_.size(), [&](std::size_t i) { work(ofPair_[i]); });
      };
      pair_.add(
          clock, [&] { each([&](Canvas& canvas) { find(camera, nullptr, canvas); }); },
          [&] { each([&](Canvas& canvas) { color(camera, nullptr, canvas); }); });
    }
  }

  void draw(const Camera& camera, Workers* workers, Canvas& canvas, PhaseTimes& times,
            const Clock& clock) const {
    times.add(
        clock, [&] { find(camera, workers, canvas); }, [&] { color(camera, workers, canvas); });
  }

  void find(const Camera& camera, Workers* workers, Canvas& canvas) const {
    renderer_.findSpans(camera, canvas.scratch, workers);
  }
  void color(const Camera& camera, Workers* workers, Canvas& canvas) const {
    renderer_.paintSpans(camera, LightMode::Both, canvas.scratch,
                         canvas.memory.rows(camera.width, camera.height), workers);
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

Prepared prepareThreads(PeerInputs& inputs, double (PhaseTimes::*part)() const) {
  if (availableThreads() < 2)
    return tl::unexpected<std::string>("this machine runs one thread at once");
  return inputs.level(inputs.castleFile()).map([&](const PeerLevel* level) -> Measure {
    return [frames = std::make_shared<ThreadedFrames>(*level), part, &inputs] {
      frames->measure(inputs.clock());
      return frames->figures(part);
    };
  });
}

}  // namespace

Prepared prepareFrameThreads(PeerInputs& inputs) {
  return prepareThreads(inputs, &PhaseTimes::frame);
}

Prepared preparePaintThreads(PeerInputs& inputs) {
  return prepareThreads(inputs, &PhaseTimes::color);
}

}  // namespace hearth
