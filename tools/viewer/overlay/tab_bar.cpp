#include "viewer/overlay/tab_bar.h"

#include <imgui/imgui.h>

#include <utility>

namespace hearth {

void TabBar::show(std::span<const Tab> tabs) {
  // A panel that was made anew, for example because letters change their size, counts frames from
  // the start and does not know which tab was shown.
  if (ImGui::GetFrameCount() <= std::exchange(frame_, ImGui::GetFrameCount())) turnTo(shown_);
  const std::optional<std::string> requested = std::exchange(requested_, std::nullopt);
  if (!ImGui::BeginTabBar("tabs")) return;
  for (const Tab& tab : tabs) {
    const ImGuiTabItemFlags flags = requested == tab.name ? ImGuiTabItemFlags_SetSelected : 0;
    if (!ImGui::BeginTabItem(tab.name, nullptr, flags)) continue;
    shown_ = tab.name;
    if (ImGui::BeginChild(tab.name)) tab.show();
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace hearth
