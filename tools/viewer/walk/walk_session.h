#pragma once

#include <cmath>
#include <vector>

#include "level/scene.h"
#include "walk/bob.h"
#include "walk/recording.h"
#include "walk/walker.h"

namespace hearth {

/// A running walk. It holds the last two states of the walker, between which the view is
/// interpolated, and all inputs if it keeps them.
class WalkSession {
 public:
  enum class Memory { None, Inputs };

  WalkSession(const Scene& scene, const Walker& start, Memory memory)
      : scene_(scene), memory_(memory), before_(start), after_(start) {}

  void tick(const WalkInput& input) {
    before_ = after_;
    gaitBefore_ = gait_;
    after_ = walked(scene_, after_, input);
    gait_ = walkedOn(gait_, before_, after_);
    if (memory_ == Memory::Inputs) inputs_.push_back(input);
  }

  /// Goes on in another scene from where `walker` stands in it.
  void goOnIn(const Scene& scene, const Walker& walker) {
    scene_ = scene;
    before_ = after_ = walker;
    gaitBefore_ = gait_ = {};
  }

  bool isKept() const { return memory_ == Memory::Inputs; }
  /// Whether no more inputs can be kept.
  bool isFull() const { return inputs_.size() >= kMaxRecordedTicks; }

  const Walker& walker() const { return after_; }
  /// The eye `fraction` of a tick after the tick before the last. So the view lags by a tick at
  /// most, and moves evenly at any frame rate.
  Eye eye(double fraction) const { return eyeBetween(scene_, before_, after_, fraction); }
  /// The same, with a head bob of this strength (0..1).
  Eye eye(double fraction, double bob) const {
    if (bob == 0) return eye(fraction);
    const Gait gait{std::lerp(gaitBefore_.stride, gait_.stride, fraction),
                    std::lerp(gaitBefore_.swing, gait_.swing, fraction)};
    return bobbed(scene_, eye(fraction), gait, bob);
  }
  const std::vector<WalkInput>& inputs() const { return inputs_; }

 private:
  Scene scene_;
  Memory memory_;
  Walker before_;
  Walker after_;
  Gait gaitBefore_;
  Gait gait_;
  std::vector<WalkInput> inputs_;
};

}  // namespace hearth
