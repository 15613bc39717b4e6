#pragma once

#include <limits>
#include <optional>

namespace hearth {

/// The mean of the frames of the last second.
class FrameRate {
 public:
  struct Mean {
    double drawSeconds;
    double framesPerSecond;
  };

  /// Counts a frame that was drawn from `begin` to `end`, in seconds of a clock that may be set
  /// back. Gives the mean once a second. After a second in which nothing was drawn, and after the
  /// clock was set back, it starts anew.
  std::optional<Mean> count(double begin, double end) {
    const bool isNext = end_ <= begin && begin <= end_ + 1 && begin <= end;
    end_ = end;
    if (!isNext) {
      startAt(end);
      return std::nullopt;
    }
    drawSeconds_ += end - begin;
    ++frames_;
    const double seconds = end - start_;
    if (seconds < 1) return std::nullopt;
    const Mean mean{drawSeconds_ / frames_, frames_ / seconds};
    startAt(end);
    return mean;
  }

 private:
  /// From the end of one frame to the end of another there are as many waits as frames.
  void startAt(double end) {
    start_ = end;
    drawSeconds_ = 0;
    frames_ = 0;
  }

  double start_ = 0;  ///< the end of the frame before the first that is counted
  double end_ = -std::numeric_limits<double>::infinity();  ///< of the last frame
  double drawSeconds_ = 0;
  int frames_ = 0;
};

}  // namespace hearth
