#pragma once

#include <vector>

#include "level/level.h"
#include "walk/recording.h"
#include "walk/walker.h"

namespace hearth {

/// A walk as it goes: the walker of the last two ticks, between which the view lies, and all that
/// was asked for on the way where it is to be kept.
class Journey {
 public:
  enum class Memory { None, Inputs };

  Journey(const Level& level, const Walker& start, Memory memory)
      : level_(&level), memory_(memory), before_(start), after_(start) {}

  void tick(const WalkInput& input) {
    before_ = after_;
    after_ = walked(*level_, after_, input);
    if (memory_ == Memory::Inputs) inputs_.push_back(input);
  }

  /// Goes on in another level from where `walker` stands in it.
  void goOnIn(const Level& level, const Walker& walker) {
    level_ = &level;
    before_ = after_ = walker;
  }

  /// No more can be kept.
  bool isFull() const { return inputs_.size() >= kMostRecordedTicks; }

  const Walker& walker() const { return after_; }
  /// `share` of a tick after the tick before the last. So the view lags by a tick at most, and
  /// moves evenly at any rate of frames.
  Eye eye(double share) const { return eyeBetween(*level_, before_, after_, share); }
  const std::vector<WalkInput>& inputs() const { return inputs_; }

 private:
  const Level* level_;
  Memory memory_;
  Walker before_;
  Walker after_;
  std::vector<WalkInput> inputs_;
};

}  // namespace hearth
