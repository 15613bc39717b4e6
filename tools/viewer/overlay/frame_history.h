#pragma once

#include <array>
#include <cstddef>

namespace hearth {

/// Where the time of a frame went, in seconds.
struct FrameParts {
  double find = 0;   ///< finding spans
  double paint = 0;  ///< painting them
  double cover = 0;  ///< drawing over it: map, text, overlay
  double show = 0;   ///< handing it to the window, and waiting for the display

  double sum() const { return find + paint + cover + show; }
};

/// The last frames.
class FrameHistory {
 public:
  static constexpr std::size_t kMax = 200;

  void add(const FrameParts& frame) {
    frames_[count_ % kMax] = frame;
    ++count_;
  }

  std::size_t size() const { return count_ < kMax ? count_ : kMax; }
  /// 0 is the oldest.
  const FrameParts& at(std::size_t age) const { return frames_[(count_ - size() + age) % kMax]; }

 private:
  std::array<FrameParts, kMax> frames_{};
  std::size_t count_ = 0;  ///< of all that came
};

}  // namespace hearth
