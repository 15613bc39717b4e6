#include "viewer/overlay/model_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include "viewer/overlay/widgets.h"

namespace hearth {

std::vector<ModelRow> modelRows(const ModelFigures& figures) {
  const auto& [min, max] = figures.box;
  const Vec3 size = max - min;
  const auto range = [](double from, double to) { return fmt::format("{:g} .. {:g} m", from, to); };
  return {{"vertices", fmt::format("{}", figures.vertices)},
          {"faces", fmt::format("{}, as {} triangles", figures.faces, figures.triangles)},
          {"materials", fmt::format("{}", figures.materials)},
          {"images", fmt::format("{}", figures.images)},
          {"size", fmt::format("{:g} x {:g} x {:g} m", size.x, size.y, size.z)},
          {"x", range(min.x, max.x)},
          {"y", range(min.y, max.y)},
          {"z, up", range(min.z, max.z)}};
}

void showModel(const ModelFigures& figures) {
  if (!ImGui::BeginTable("model", 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const ModelRow& row : modelRows(figures)) {
    ImGui::TableNextColumn();
    showText(std::string(row.name));
    ImGui::TableNextColumn();
    showText(row.words);
  }
  ImGui::EndTable();
}

}  // namespace hearth
