#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "load/limits.h"
#include "load/read/description.h"
#include "viewer/edit/edit_history.h"

namespace hearth {

/// The text of a lights file while it is edited. Its lights are counted as LightsDescription does.
/// Edits keep the order, spelling and blanks of all other text. The text always loads, apart from
/// the places of lights: only a level knows where there is air.
class LightsEdit {
 public:
  /// Of a file's bytes; `file` is how messages name it. The error is the first mistake in them.
  static tl::expected<LightsEdit, std::string> open(std::string_view bytes, std::string file,
                                                    const LoadLimits& limits = {});

  /// The text to write into the file.
  std::string bytes() const;
  const LightsDescription& lights() const { return lights_; }
  /// The first comment of a light; empty without one.
  std::string commentOf(std::size_t light) const;

  // Edits, each an undo step by itself. They change nothing where the text would not load any more,
  // and then say why.

  /// Writes the keys in which `to` differs from the light.
  std::optional<std::string> set(std::size_t light, const LightDescription& to);
  /// Sets the comment that `commentOf` returns; an empty one is removed.
  std::optional<std::string> setComment(std::size_t light, const std::string& comment);
  /// Adds a light, a sun or an emitter at the end of those of its kind, or the sky: its comment, if
  /// any, its position or direction, and all that differs from the defaults.
  std::optional<std::string> add(const LightDescription& light, const std::string& comment = "");
  std::optional<std::string> remove(std::size_t light);

  /// Until the drag ends each edit replaces the one before, so that all are one step.
  void beginDrag() { history_.beginStep(); }
  void endDrag() { history_.endStep(); }
  bool isDragging() const { return history_.isInStep(); }

  bool canUndo() const { return history_.canUndo(); }
  bool canRedo() const { return history_.canRedo(); }
  void undo();  ///< expects that it can
  void redo();

 private:
  LightsEdit(std::string text, std::string file, const LoadLimits& limits, bool hasByteOrderMark)
      : file_(std::move(file)),
        limits_(limits),
        hasByteOrderMark_(hasByteOrderMark),
        history_(std::move(text)) {}

  template <typename Change>
  std::optional<std::string> edit(Change&& change);
  std::optional<std::string> read();
  /// Writes what differs into the text.
  void changeSpot(std::size_t light, const Spot& from, const Spot& to);
  std::size_t offsetOf(std::size_t light) const { return lights_.at(light).place.offset; }
  void addMember(std::string_view key, std::string_view value);
  void addEmitter(const std::string& texture, const std::string& value);

  std::string file_;
  LoadLimits limits_;
  bool hasByteOrderMark_;
  EditHistory history_;
  LightsDescription lights_;         ///< as the text has them
  std::size_t list_ = 0;             ///< where the array of lights begins
  std::optional<std::size_t> suns_;  ///< where that of suns begins, if there is one
  std::optional<std::size_t> emit_;  ///< where the object of emitters begins, if there is one
};

/// A coordinate as a drag gives it, in whole millimetres.
double toMillimetres(double metres);

/// The first comment of the object of a JSON text that begins at `object`; empty without one.
std::string commentAt(std::string_view json, std::size_t object);

/// What a light is called: `3 lamp posts`, its number in its file and its comment. Without one
/// `light 3`, `sun 4`, `sky` or `emitter lava`.
std::string lightName(std::size_t light, const LightSource& source, const std::string& comment);

}  // namespace hearth
