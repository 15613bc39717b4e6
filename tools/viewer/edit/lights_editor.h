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

/// The lights file of a level that is walked, as it is edited there: the file as stored, its text
/// with all edits, and the light that is picked.
class LightsEditor {
 public:
  LightsEditor(Storage& storage, std::filesystem::path file, const LoadLimits& limits)
      : storage_(&storage), file_(std::move(file)), limits_(limits) {}

  const std::filesystem::path& file() const { return file_; }
  /// Reads the file, unless it is open; one that is not there has no lights yet. Where it has
  /// mistakes `message` is the first, and the editor stays closed until the file is written.
  void open();
  bool isOpen() const { return edit_.has_value(); }

  // These expect that a file is open, unless their comment says otherwise.

  const LightsDescription& lights() const { return edit_->lights(); }
  std::string commentOf(std::size_t light) const { return edit_->commentOf(light); }
  /// What the file is to hold.
  std::string bytes() const { return edit_->bytes(); }

  /// One of the lights, if any.
  std::optional<std::size_t> picked() const { return picked_; }
  void pick(std::optional<std::size_t> light) { picked_ = light; }
  const LightDescription& pickedLight() const { return lights().lights[*picked_]; }

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

  /// Whether there are edits that are not in the file. None while it is closed.
  bool isUnsaved() const;
  /// Writes the file at once and whole, unless somebody else has changed it since it was read.
  void save();
  /// Says why it is not saved.
  void refuse(const std::string& why) { message_ = why; }
  /// Somebody else has changed it, so that it is not saved unless it is opened again.
  bool hasConflict() const { return hasConflict_; }
  /// Reads the file and drops all edits, unless it has mistakes.
  void openAgain();

  /// To be told when the file has been written. Returns whether its lights are to be loaded from it
  /// again: not where it holds what is edited, nor where edits would be lost. Also while closed.
  bool noteWritten();
  /// The text, where it has changed since the last call. Also while closed.
  std::optional<std::string> takeText();

  /// What was refused last, or done; else empty.
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
