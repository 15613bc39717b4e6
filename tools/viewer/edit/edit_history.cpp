#include "viewer/edit/edit_history.h"

#include <utility>

#include "math/check.h"

namespace hearth {

void EditHistory::beginStep() {
  CHECK(!isInStep_, done_);
  isInStep_ = true;
}

void EditHistory::endStep() {
  isInStep_ = false;
  if (open_.empty()) return;
  steps_.resize(done_);
  steps_.push_back(std::exchange(open_, {}));
  ++done_;
}

void EditHistory::replace(const Replacement& replacement) {
  CHECK(isInStep_, replacement.offset);
  if (replacement.before == replacement.after) return;
  apply({replacement});
  open_.push_back(replacement);
}

void EditHistory::takeBackStep() {
  revert(open_);
  open_.clear();
}

void EditHistory::undo() {
  CHECK(canUndo(), done_);
  revert(steps_[--done_]);
}

void EditHistory::redo() {
  CHECK(canRedo(), done_);
  apply(steps_[done_++]);
}

void EditHistory::apply(const Step& step) {
  for (const Replacement& part : step) text_.replace(part.offset, part.before.size(), part.after);
}

void EditHistory::revert(const Step& step) {
  for (auto part = step.rbegin(); part != step.rend(); ++part)
    text_.replace(part->offset, part->after.size(), part->before);
}

}  // namespace hearth
