#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "math/check.h"
#include "walk/bob.h"
#include "walk/recording.h"
#include "walk/walker.h"

namespace hearth {

/// A running walk. It holds the last two states of the walker, between which the view is
/// interpolated, and all inputs if it records them.
class WalkSession {
 public:
  enum class Record { No, Yes };

  WalkSession(const Scene& scene, const Walker& start, Record record)
      : scene_(scene), isRecording_(record == Record::Yes), previous_(start), current_(start) {}

  void tick(const WalkInput& input) {
    CHECK(!isFull(), inputs_.size());
    previous_ = current_;
    previousGait_ = currentGait_;
    current_ = walked(scene_, current_, input);
    currentGait_ = walkedOn(currentGait_, previous_, current_);
    if (isRecording_) inputs_.push_back(input);
    ++ticks_;
  }

  /// Goes on in another scene from where `walker` stands in it. Not while recording: the recording
  /// would not lead there.
  void continueIn(const Scene& scene, const Walker& walker) {
    CHECK(!isRecording_, inputs_.size());
    scene_ = scene;
    previous_ = current_ = walker;
    previousGait_ = currentGait_ = {};
  }

  bool isRecording() const { return isRecording_; }
  /// Whether the recording is as long as it may be.
  bool isFull() const { return inputs_.size() >= kMaxRecordedTicks; }

  const Walker& walker() const { return current_; }
  /// The eye between the previous tick (0) and the latest (1). So the view is at most a tick late,
  /// and moves evenly at any frame rate.
  Eye eye(double fraction) const { return eyeBetween(scene_, previous_, current_, fraction); }
  /// The same, with a head bob of this strength (0..1).
  Eye eye(double fraction, double bob) const {
    if (bob == 0) return eye(fraction);
    const Gait gait{std::lerp(previousGait_.stride, currentGait_.stride, fraction),
                    std::lerp(previousGait_.swing, currentGait_.swing, fraction)};
    return bobbed(scene_, eye(fraction), gait, bob);
  }
  /// How long the walk has lasted, in the moment that `eye(fraction)` shows.
  double seconds(double fraction) const {
    return ticks_ == 0 ? 0 : (static_cast<double>(ticks_ - 1) + fraction) / kTicksPerSecond;
  }
  const std::vector<WalkInput>& inputs() const { return inputs_; }

 private:
  Scene scene_;
  bool isRecording_;
  Walker previous_;
  Walker current_;
  Gait previousGait_;
  Gait currentGait_;
  std::vector<WalkInput> inputs_;
  std::int64_t ticks_ = 0;
};

}  // namespace hearth
