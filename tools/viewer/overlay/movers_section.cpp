#include "viewer/overlay/movers_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

// The widths of columns, in letters.
constexpr float kShareWidth = 12;
constexpr float kHeightWidth = 9;
constexpr float kTriggerWidth = 9;
constexpr float kSpeedWidth = 11;

/// Metres a second. The loader takes less and more, which is of no use in a drag.
constexpr double kLeastMoverSpeed = 0.01;
constexpr double kMostMoverSpeed = 1000;
constexpr float kSpeedPerPixel = 0.02F;

/// By MoverTrigger: what starts a mover.
constexpr std::array kTriggerTips{
    "Only walls that name it start it.",
    "The use key starts it, in its sectors and at their walls.",
    "It starts when the player's feet enter one of its zones.",
    "It moves by itself, for ever.",
};
static_assert(kTriggerTips.size() == kMoverTriggerNames.size());

/// To the centimetre, without a negative zero.
std::string metres(double z) { return fmt::format("{:.2f} m", std::round(100 * z) / 100 + 0.0); }

double zOf(const Scene& scene, const Mover& mover) {
  const Sector& sector = scene[mover.sectors.front()];
  return mover.part == FlatPart::Floor ? scene.zFloor(sector) : scene.zCeiling(sector);
}

void showReason(const MoverPermissions& permissions) {
  if (!permissions.canMove)
    showWrapped("This walk is recorded or replayed: movers cannot be dragged or edited.");
  else if (!permissions.canWrite)
    showWrapped(
        "This walk takes its light from a file, and does not load the level again: triggers and "
        "speeds cannot be edited.");
}

void showMoverName(const Mover& mover) {
  ImGui::AlignTextToFramePadding();
  showText(mover.name);
  const std::size_t count = mover.sectors.size();
  showTip(fmt::format("{}\nThe {} of {} sector{}, which moves to {}.", mover.name, name(mover.part),
                      count, count == 1 ? "" : "s", metres(mover.to)));
}

/// The loader refuses the trigger `enter` without zones.
void showTriggers(MoverTrigger& trigger, bool hasZones) {
  for (std::size_t i = 0; i < kMoverTriggerNames.size(); ++i) {
    const auto choice = static_cast<MoverTrigger>(i);
    const bool canChoose = choice != MoverTrigger::Enter || hasZones;
    ImGui::BeginDisabled(!canChoose);
    if (ImGui::Selectable(kMoverTriggerNames.at(i).data(), choice == trigger)) trigger = choice;
    ImGui::EndDisabled();
    showTip(canChoose ? kTriggerTips.at(i) : "It has no zones: name them in the level's file.");
  }
}

void showTrigger(MoverTrigger& trigger, bool hasZones) {
  const auto index = static_cast<std::size_t>(trigger);
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##trigger", kMoverTriggerNames.at(index).data())) {
    showTip(kTriggerTips.at(index));
    return;
  }
  showTriggers(trigger, hasZones);
  ImGui::EndCombo();
}

void setUpColumns() {
  const auto setUp = [](const char* name, float width) {
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, letters(width));
  };
  ImGui::TableSetupScrollFreeze(0, 1);  // the headers stay
  ImGui::TableSetupColumn("mover", ImGuiTableColumnFlags_WidthStretch);
  setUp("share", kShareWidth);
  setUp("height", kHeightWidth);
  setUp("trigger", kTriggerWidth);
  setUp("speed", kSpeedWidth);
  ImGui::TableHeadersRow();
}

}  // namespace

void MoversSection::forget() {
  held_.reset();  // movers may have other indices
  written_.reset();
}

MoverEdit MoversSection::current(const Mover& mover) const {
  return written_ && written_->name == mover.name ? *written_ : editOf(mover);
}

std::optional<MoverEdit> MoversSection::show(const MoversSubject& subject) {
  held_.reset();
  showReason(subject.permissions);
  std::optional<MoverEdit> chosen = showTable(subject);
  // The row of a number that is dragged may have been scrolled away.
  if (drag_ && !ImGui::IsAnyItemActive()) chosen = endedDrag(subject.scene.level());
  return chosen;
}

/// A list of hundreds of movers shows as fast as one of few: only rows in sight are laid out.
std::optional<MoverEdit> MoversSection::showTable(const MoversSubject& subject) {
  std::optional<MoverEdit> chosen;
  if (!ImGui::BeginTable("movers", 5, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg))
    return chosen;
  setUpColumns();
  const std::vector<Mover>& movers = subject.scene.level().movers;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(movers.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto index = static_cast<std::size_t>(row);
      ImGui::PushID(row);
      const MoverEdit edit = showRow(subject, index);
      ImGui::PopID();
      if (edit != current(movers[index])) chosen = edit;
    }
  ImGui::EndTable();
  return chosen;
}

/// Returns what the mover is to be.
MoverEdit MoversSection::showRow(const MoversSubject& subject, std::size_t index) {
  const Mover& mover = subject.scene.level().movers[index];
  MoverEdit edit = current(mover);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  showMoverName(mover);
  ImGui::TableNextColumn();
  showShare(subject, index);
  ImGui::TableNextColumn();
  showText(metres(zOf(subject.scene, mover)));
  ImGui::BeginDisabled(!subject.permissions.canWrite);
  ImGui::TableNextColumn();
  showTrigger(edit.trigger, !mover.zones.empty());
  ImGui::TableNextColumn();
  showSpeed(edit);
  ImGui::EndDisabled();
  return edit;
}

void MoversSection::showShare(const MoversSubject& subject, std::size_t index) {
  auto share = static_cast<float>(subject.shares[index]);
  ImGui::BeginDisabled(!subject.permissions.canMove);
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderFloat("##share", &share, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::EndDisabled();
  if (ImGui::IsItemActive())
    held_ = MoverShare{index, std::round(1000 * static_cast<double>(share)) / 1000};
  else
    showTip(
        "0 where the level has it, 1 at the other end. Drag it: the mover rests there until "
        "something starts it, and stops before it crushes you.");
}

/// Its number is that of the drag until that ends.
void MoversSection::showSpeed(MoverEdit& edit) {
  const bool isDragged = drag_ && drag_->name == edit.name;
  double speed = isDragged ? drag_->speed : edit.speed;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::DragScalar("##speed", ImGuiDataType_Double, &speed, kSpeedPerPixel, &kLeastMoverSpeed,
                        &kMostMoverSpeed, "%.3g m/s", ImGuiSliderFlags_AlwaysClamp))
    drag_ = SpeedDrag{edit.name, speed};
  if (ImGui::IsItemActive()) return;
  showTip("Drag it, or click to type a number. It is written when you let go.");
  if (drag_ && drag_->name == edit.name) edit.speed = std::exchange(drag_, std::nullopt)->speed;
}

std::optional<MoverEdit> MoversSection::endedDrag(const Level& level) {
  const SpeedDrag ended = *std::exchange(drag_, std::nullopt);
  const auto mover = std::ranges::find(level.movers, ended.name, &Mover::name);
  if (mover == level.movers.end()) return std::nullopt;
  MoverEdit edit = current(*mover);
  edit.speed = ended.speed;
  return edit != current(*mover) ? std::optional(edit) : std::nullopt;
}

}  // namespace hearth
