#include "viewer/overlay/pages.h"

#include <imgui/imgui.h>

#include <utility>

namespace hearth {

void Pages::show(std::span<const Page> pages) {
  // A panel that was made anew, for example because letters change their size, counts frames from
  // the start and does not know which page was shown.
  if (ImGui::GetFrameCount() <= std::exchange(frame_, ImGui::GetFrameCount())) turnTo(shown_);
  const std::optional<std::size_t> asked = std::exchange(asked_, std::nullopt);
  if (!ImGui::BeginTabBar("pages")) return;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const ImGuiTabItemFlags flags = asked == i ? ImGuiTabItemFlags_SetSelected : 0;
    if (!ImGui::BeginTabItem(pages[i].name, nullptr, flags)) continue;
    shown_ = i;
    if (ImGui::BeginChild(pages[i].name)) pages[i].show();
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace hearth
