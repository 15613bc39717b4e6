#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "load/limits.h"
#include "viewer/edit/lights_edit.h"
#include "viewer/host/storage.h"

namespace hearth {

/// Edits the lights file of a level in a walk: the file as stored, its text with all edits, and the
/// picked light.
class LightsEditor {
 public:
  LightsEditor(Storage& storage, std::filesystem::path file, const LoadLimits& limits)
      : storage_(&storage), file_(std::move(file)), limits_(limits) {}

  const std::filesystem::path& file() const { return file_; }
  /// Reads the file, unless it is open. A missing file has no lights yet. If the file has mistakes,
  /// `message` is the first, and the editor stays closed until the file is written.
  void open();
  bool isOpen() const { return edit_.has_value(); }

  // These expect that a file is open, unless their comment says otherwise.

  const LightsDescription& lights() const { return edit_->lights(); }
  std::string commentOf(std::size_t light) const { return edit_->commentOf(light); }
  /// The text that the file will get.
  std::string bytes() const { return edit_->bytes(); }

  /// One of the lights, if any.
  std::optional<std::size_t> picked() const { return picked_; }
  void pick(std::optional<std::size_t> light) { picked_ = light; }
  const LightDescription& pickedLight() const { return lights().at(*picked_); }

  // As those of LightsEdit; `message` says why an edit is refused.
  void set(const LightDescription& to);         ///< the light that is picked
  void setComment(const std::string& comment);  ///< of the light that is picked
  void add(const LightDescription& light, const std::string& comment = "");  ///< picked then
  void removePicked();
  void beginDrag() { edit_->beginDrag(); }
  void endDrag() { edit_->endDrag(); }
  bool isDragging() const { return isOpen() && edit_->isDragging(); }
  bool canUndo() const { return edit_->canUndo(); }
  bool canRedo() const { return edit_->canRedo(); }
  void undo();  ///< what there is
  void redo();

  /// Whether there are unsaved edits. False while it is closed.
  bool isUnsaved() const;
  /// Writes the file, unless another program has changed it since it was read.
  void save();
  /// Makes `message` say why it is not saved.
  void refuse(const std::string& why) { message_ = why; }
  /// Whether another program has changed it. Then it is not saved before it is opened again.
  bool hasConflict() const { return hasConflict_; }
  /// Reads the file and drops all edits, unless it has mistakes.
  void openAgain();

  /// Call it when the file has been written, also while closed. Returns whether its lights must be
  /// loaded again: not if it holds the edited text, and not if edits would be lost.
  bool noteWritten();
  /// The text, if it has changed since the last call. Call it also while closed.
  std::optional<std::string> takeText();

  /// Why the last edit was refused, or what was done; else empty.
  const std::string& message() const { return message_; }

 private:
  std::optional<std::string> stored() const;
  bool read();
  void take(const std::optional<std::string>& mistake);
  void keepPickInRange();

  Storage* storage_;
  std::filesystem::path file_;
  LoadLimits limits_;
  std::optional<LightsEdit> edit_;
  std::optional<std::string> saved_;  ///< the file's bytes as they were read or written last
  std::optional<std::size_t> picked_;
  bool hasConflict_ = false;
  bool hasMistakes_ = false;  ///< the file, as it was read last
  bool isNew_ = false;
  std::string message_;
};

}  // namespace hearth
