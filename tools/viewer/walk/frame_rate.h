#pragma once

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
  /// back. Gives the mean once a second. After a second in which nothing was drawn it starts anew.
  std::optional<Mean> count(double begin, double end) {
    if (frames_ == 0 || begin < end_ || begin > end_ + 1) *this = FrameRate(begin);
    end_ = end;
    drawSeconds_ += end - begin;
    ++frames_;
    const double seconds = end - begin_;
    if (seconds < 1) return std::nullopt;
    const Mean mean{drawSeconds_ / frames_, frames_ / seconds};
    frames_ = 0;
    return mean;
  }

  FrameRate() = default;

 private:
  explicit FrameRate(double begin) : begin_(begin) {}

  double begin_ = 0;
  double end_ = 0;
  double drawSeconds_ = 0;
  int frames_ = 0;
};

}  // namespace hearth
