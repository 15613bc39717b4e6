// Frames of the tutorial and the castle.

#include <memory>

#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr ImageSize kSmall{320, 200};
constexpr ImageSize kLarge{1920, 1080};

/// Small frames are over so soon that a whole round of them is drawn again.
constexpr int kSmallRounds = 20;
constexpr int kLargeRounds = 2;

/// Frames of all shots in one size, on one thread.
class ShotFrames {
 public:
  ShotFrames(const PeerLevel& level, ImageSize size, int rounds)
      : level_(level), cameras_(camerasOf(level.loaded.level)), rounds_(rounds), frames_(size) {}

  FrameBench measure(const Clock& clock) {
    drawAll(clock);  // caches that others have used are warm again
    frames_.begin();
    for (int i = 0; i < rounds_; ++i) drawAll(clock);
    return frames_.result();
  }

 private:
  void drawAll(const Clock& clock) {
    for (const Camera& camera : cameras_) frames_.draw(level_.renderer, camera, clock);
  }

  const PeerLevel& level_;
  std::vector<Camera> cameras_;
  int rounds_;
  FrameTimes frames_;
};

Prepared prepareWrites(tl::expected<const PeerLevel*, std::string> level, const Clock& clock) {
  return level.map([&](const PeerLevel* of) -> Measure {
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
  return inputs.level(inputs.tutorialFile()).map([&](const PeerLevel* level) -> Measure {
    const auto frames = std::make_shared<ShotFrames>(*level, kSmall, kSmallRounds);
    return [frames, &inputs] {
      const FrameBench frame = frames->measure(inputs.clock());
      return Figures{frame.milliseconds.median, frame.findMilliseconds.median,
                     frame.colorMilliseconds.median};
    };
  });
}

Prepared prepareCastleWrites(PeerInputs& inputs) {
  return prepareWrites(inputs.level(inputs.castleFile()), inputs.clock());
}

Prepared prepareWhiteLitCastleWrites(PeerInputs& inputs) {
  return prepareWrites(inputs.whiteLitLevel(inputs.castleFile()), inputs.clock());
}

}  // namespace hearth
