#pragma once

namespace hearth {

/// A section of the panel, open at first.
class CollapsibleSection {
 public:
  /// Opens it, and scrolls the panel to its top.
  void reveal() { framesLeft_ = kFramesToScroll; }
  /// Whether it is being brought into view.
  bool isRevealed() const { return framesLeft_ > 0; }

  /// Returns whether it is open. Expects a frame of ImGui.
  bool show(const char* name);

 private:
  /// A panel scrolls no farther than its length in the frame before.
  static constexpr int kFramesToScroll = 3;

  int framesLeft_ = 0;
};

}  // namespace hearth
