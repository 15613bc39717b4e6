#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "text/json_text.h"

namespace hearth {

/// A text with all its edits, in steps that can be undone and redone without limit.
class EditHistory {
 public:
  explicit EditHistory(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }

  /// All replacements until the step ends are undone together. A step without a net change leaves
  /// no trace.
  void beginStep();
  void endStep();
  bool isInStep() const { return isInStep_; }
  /// Call it within a step. `before` is the text there now.
  void replace(const Replacement& replacement);
  /// The replacements of the current step so far.
  void takeBackStep();

  bool canUndo() const { return !isInStep_ && done_ > 0; }
  bool canRedo() const { return !isInStep_ && done_ < steps_.size(); }
  /// Expects that there is something to undo, or to redo.
  void undo();
  void redo();

 private:
  using Step = std::vector<Replacement>;  ///< each of the text that those before it have left

  void apply(const Step& step);
  void revert(const Step& step);

  std::string text_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;  ///< the steps that the text has
  Step open_;
  bool isInStep_ = false;
};

}  // namespace hearth
