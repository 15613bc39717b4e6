#include "viewer/overlay/view_section.h"

#include <imgui/imgui.h>

#include <array>
#include <string>
#include <vector>

#include "settings/channels.h"

namespace hearth {

namespace {

constexpr float kGroupLetters = 10;  // the width of a group's name, in letters

struct ModeText {
  LightMode mode;
  std::string_view name;
  std::string_view shows;
};
constexpr std::array kModes = {
    ModeText{LightMode::Both, "texture and light", "the level as it is: the key 1"},
    ModeText{LightMode::None, "texture", "textures without light: the key 2"},
    ModeText{LightMode::Only, "light", "light in place of textures: the key 3"},
};

struct GroupText {
  ChannelKind kind;
  std::string_view name;
};
constexpr std::array kGroups = {
    GroupText{ChannelKind::Marks, "marked"},
    GroupText{ChannelKind::Numbers, "numbers"},
    GroupText{ChannelKind::Geometry, "geometry"},
};

/// Radio buttons in lines, and what the one under the pointer shows or, without one, the chosen.
class Choices {
 public:
  /// Buttons of different groups may have the same name.
  void beginGroup(std::string_view name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.data(), name.data() + name.size());
    group_ = std::string(name);
    indent_ = kGroupLetters * ImGui::CalcTextSize("M").x;
    isFirst_ = true;
  }

  /// True where it is clicked.
  bool show(std::string_view name, std::string_view shows, bool isChosen) {
    const std::string label(name);
    placeFor(label);
    ImGui::PushID(group_.data());
    const bool isClicked = ImGui::RadioButton(label.data(), isChosen);
    ImGui::PopID();
    if (isChosen) chosen_ = shows;
    if (ImGui::IsItemHovered()) pointedAt_ = shows;
    return isClicked;
  }

  void showText() const {
    const std::string text(pointedAt_.empty() ? chosen_ : pointedAt_);
    ImGui::TextWrapped("%s", text.data());
  }

 private:
  /// Beside the last button where there is room, else in a new line.
  void placeFor(const std::string& label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width =
        ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label.data()).x;
    const float right = ImGui::GetWindowContentRegionMax().x + ImGui::GetWindowPos().x;
    const float end = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
    if (isFirst_ || end <= right)
      ImGui::SameLine(isFirst_ ? indent_ : 0);
    else
      ImGui::SetCursorPosX(indent_);
    isFirst_ = false;
  }

  std::string group_;
  float indent_ = 0;
  bool isFirst_ = true;
  std::string_view chosen_;
  std::string_view pointedAt_;
};

}  // namespace

void showView(LightMode& mode, std::string_view& channel) {
  Choices choices;
  choices.beginGroup("lit");
  for (const ModeText& text : kModes)
    if (choices.show(text.name, text.shows, channel.empty() && mode == text.mode)) {
      mode = text.mode;
      channel = {};
    }
  const std::vector<ChannelText> channels = channelTexts();
  for (const GroupText& group : kGroups) {
    choices.beginGroup(group.name);
    for (const ChannelText& text : channels)
      if (text.kind == group.kind && choices.show(text.name, text.shows, channel == text.name))
        channel = text.name;
  }
  choices.showText();
}

}  // namespace hearth
