#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "math/check.h"
#include "walk/bob.h"
#include "walk/moving_level.h"
#include "walk/recording.h"
#include "walk/walker.h"

namespace hearth {

/// A running walk. It holds the last two states of the walker and of the level's movers, between
/// which the view is interpolated, and all inputs if it records them.
class WalkSession {
 public:
  enum class Record { No, Yes };

  WalkSession(MovingLevel level, const Walker& start, Record record)
      : level_(std::move(level)),
        isRecording_(record == Record::Yes),
        previous_(start),
        current_(start),
        previousShares_(level_.shares().begin(), level_.shares().end()) {}

  void tick(const WalkInput& input) {
    CHECK(!isFull(), inputs_.size());
    previous_ = current_;
    previousGait_ = currentGait_;
    std::ranges::copy(level_.shares(), previousShares_.begin());
    push();
    current_ = level_.ticked(current_, input);
    currentGait_ = walkedOn(currentGait_, previous_, current_);
    if (isRecording_) inputs_.push_back(input);
    ++ticks_;
  }

  /// Goes on in another version of the level from where `walker` stands in it. Not while recording:
  /// the recording would not lead there.
  void continueIn(MovingLevel level, const Walker& walker) {
    level_ = std::move(level);
    held_.reset();
    continueAt(walker);
  }
  /// Goes on from another place.
  void continueAt(const Walker& walker) {
    CHECK(!isRecording_, inputs_.size());
    previous_ = current_ = walker;
    previousGait_ = currentGait_ = {};
    previousShares_.assign(level_.shares().begin(), level_.shares().end());
  }

  /// From now on a hand holds this mover, or none. Not while recording: the recording would not
  /// lead there.
  void hold(const std::optional<MoverShare>& held) {
    CHECK(!isRecording_ || !held, inputs_.size());
    held_ = held;
    push();
  }

  /// As it is since the latest tick.
  const MovingLevel& level() const { return level_; }

  bool isRecording() const { return isRecording_; }
  /// Whether the recording is as long as it may be.
  bool isFull() const { return inputs_.size() >= kMaxRecordedTicks; }

  const Walker& walker() const { return current_; }
  /// The eye between the previous tick (0) and the latest (1). So the view is at most a tick late,
  /// and moves evenly at any frame rate.
  /// `shown` is the level at that moment.
  Eye eye(const Scene& shown, double fraction) const {
    return eyeBetween(shown, previous_, current_, fraction);
  }
  /// The same, with a head bob of this strength (0..1).
  Eye eye(const Scene& shown, double fraction, double bob) const {
    if (bob == 0) return eye(shown, fraction);
    const Gait gait{std::lerp(previousGait_.stride, currentGait_.stride, fraction),
                    std::lerp(previousGait_.swing, currentGait_.swing, fraction)};
    return bobbed(shown, eye(shown, fraction), gait, bob);
  }
  /// The shares of the level's movers at that moment, into `shares`.
  void findShares(double fraction, std::vector<double>& shares) const {
    shares.resize(previousShares_.size());
    for (std::size_t i = 0; i < shares.size(); ++i)
      shares[i] = std::lerp(previousShares_[i], level_.shares()[i], fraction);
  }
  /// How long the walk has lasted, in the moment that `eye` shows.
  double seconds(double fraction) const {
    return ticks_ == 0 ? 0 : (static_cast<double>(ticks_ - 1) + fraction) / kTicksPerSecond;
  }
  const std::vector<WalkInput>& inputs() const { return inputs_; }

 private:
  void push() {
    if (held_) current_ = level_.pushed(current_, *held_);
  }

  MovingLevel level_;
  bool isRecording_;
  Walker previous_;
  Walker current_;
  std::vector<double> previousShares_;  ///< by mover
  Gait previousGait_;
  Gait currentGait_;
  std::optional<MoverShare> held_;
  std::vector<WalkInput> inputs_;
  std::int64_t ticks_ = 0;
};

}  // namespace hearth
