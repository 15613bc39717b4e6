#include "hearth/overlay/view_section.h"

#include <imgui/imgui.h>

#include <array>
#include <string>
#include <utility>

#include "hearth/channels.h"

namespace hearth {

namespace {

constexpr int kColumns = 4;

constexpr std::array kModes = {
    std::pair{"texture and light", LightMode::Both},
    std::pair{"texture", LightMode::None},
    std::pair{"light", LightMode::Only},
};

}  // namespace

void showView(LightMode& mode, std::string_view& channel) {
  if (!ImGui::CollapsingHeader("View")) return;
  for (const auto& [name, shown] : kModes) {
    if (ImGui::RadioButton(name, channel.empty() && mode == shown)) {
      mode = shown;
      channel = {};
    }
    ImGui::SameLine();
  }
  ImGui::NewLine();
  if (!ImGui::BeginTable("channels", kColumns)) return;
  ImGui::PushID("channels");  // of which one is called light, too
  for (const std::string_view name : channelNames()) {
    ImGui::TableNextColumn();
    if (ImGui::RadioButton(std::string(name).data(), channel == name)) channel = name;
  }
  ImGui::PopID();
  ImGui::EndTable();
}

}  // namespace hearth
