#include "viewer/edit/lights_editor.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace hearth {

namespace {

/// Of a file that is made by the first light.
constexpr std::string_view kNoLights = "[\n]\n";

}  // namespace

void LightsEditor::open() {
  if (!isOpen() && !hasMistakes_) read();
}

void LightsEditor::openAgain() { isNew_ |= read(); }

std::optional<std::string> LightsEditor::stored() const {
  auto bytes = storage_->read(file_, limits_.fileBytes);
  return bytes ? std::optional(*std::move(bytes)) : std::nullopt;
}

/// The file takes the place of what there is, unless it has mistakes.
bool LightsEditor::read() {
  const std::optional<std::string> there = stored();
  auto edit = LightsEdit::open(there.value_or(std::string(kNoLights)), file_.string(), limits_);
  hasMistakes_ = !edit;
  message_ = edit ? "" : edit.error();
  if (!edit) return false;
  edit_ = *std::move(edit);
  saved_ = there;
  hasConflict_ = false;
  keepPickInRange();
  return true;
}

void LightsEditor::keepPickInRange() {
  if (picked_ && *picked_ >= lights().count()) picked_.reset();
}

void LightsEditor::take(const std::optional<std::string>& mistake) {
  message_ = mistake.value_or("");
  isNew_ = true;
  keepPickInRange();
}

void LightsEditor::set(const LightDescription& to) { take(edit_->set(*picked_, to)); }

void LightsEditor::setComment(const std::string& comment) {
  take(edit_->setComment(*picked_, comment));
}

void LightsEditor::add(const LightDescription& light, const std::string& comment) {
  const auto mistake = edit_->add(light, comment);
  const LightsDescription& all = lights();
  if (!mistake)
    picked_ = (light.source.isEmitter() ? all.count()
               : light.source.isSky     ? all.firstEmitter()
               : light.source.sun       ? all.firstSky()
                                        : all.firstSun()) -
              1;
  take(mistake);
}

void LightsEditor::removePicked() { take(edit_->remove(*std::exchange(picked_, std::nullopt))); }

void LightsEditor::undo() {
  if (!canUndo()) return;
  edit_->undo();
  take({});
}

void LightsEditor::redo() {
  if (!canRedo()) return;
  edit_->redo();
  take({});
}

bool LightsEditor::isUnsaved() const {
  return isOpen() && edit_->bytes() != (saved_ ? std::string_view(*saved_) : kNoLights);
}

void LightsEditor::save() {
  if (!isUnsaved()) {
    message_ = "nothing has been changed";
    return;
  }
  const std::string bytes = edit_->bytes();
  const std::optional<std::string> there = stored();
  hasConflict_ = there != saved_ && there != bytes;
  if (hasConflict_) {
    message_ = fmt::format("{} was changed by another program since it was read: not saved",
                           file_.filename().string());
    return;
  }
  const auto written = storage_->write(file_, bytes);
  if (written) saved_ = bytes;
  message_ = written ? fmt::format("saved {}", file_.filename().string()) : written.error();
}

bool LightsEditor::noteWritten() {
  hasMistakes_ = false;
  if (!isOpen()) return true;
  const std::optional<std::string> there = stored();
  if (there == edit_->bytes()) {
    saved_ = there;
    hasConflict_ = false;
    return false;
  }
  if (there == saved_) return false;
  if (isUnsaved()) {
    hasConflict_ = true;
    message_ = fmt::format("{} was changed by another program, and has edits here",
                           file_.filename().string());
    return false;
  }
  if (!read()) edit_.reset();
  return true;
}

std::optional<std::string> LightsEditor::takeText() {
  if (!std::exchange(isNew_, false) || !isOpen()) return std::nullopt;
  return edit_->bytes();
}

}  // namespace hearth
