#include "viewer/overlay/collapsible_section.h"

#include <imgui/imgui.h>

#include <algorithm>

namespace hearth {

bool CollapsibleSection::show(const char* name) {
  if (framesLeft_ == kFramesToScroll) ImGui::SetNextItemOpen(true);
  const bool isOpen = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
  if (framesLeft_ > 0) ImGui::SetScrollHereY(0);
  framesLeft_ = std::max(0, framesLeft_ - 1);
  return isOpen;
}

}  // namespace hearth
