#include "viewer/overlay/figures_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "math/spread.h"
#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

constexpr double kBytesPerMiB = 1 << 20;

/// In lines of text.
constexpr float kGraphLines = 4;

struct Part {
  double FrameParts::*seconds;
  std::string_view name;
  ImU32 color;
};
/// From the bottom of the graph to its top.
constexpr std::array kParts = {
    Part{&FrameParts::find, "find", IM_COL32(96, 160, 255, 255)},
    Part{&FrameParts::paint, "paint", IM_COL32(112, 208, 112, 255)},
    Part{&FrameParts::cover, "cover", IM_COL32(255, 200, 80, 255)},
    Part{&FrameParts::show, "show", IM_COL32(160, 128, 128, 255)},
};

/// In whole pixels: rectangles stay sharp.
float wholePixels(double pixels) { return static_cast<float>(std::floor(pixels)); }

/// A bar for each frame, the newest at the right.
void showGraph(const FrameHistory& frames) {
  double longest = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) longest = std::max(longest, frames.at(i).sum());
  const double scale = scaleFor(longest);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x,
                    wholePixels(kGraphLines * ImGui::GetTextLineHeight())};
  const float bottom = from.y + size.y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, {from.x + size.x, bottom}, IM_COL32(0, 0, 0, 255));
  const float bar = std::max(1.0F, wholePixels(size.x / FrameHistory::kMax));
  float left = from.x + size.x - bar * static_cast<float>(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i, left += bar) {
    if (left < from.x) continue;
    double seconds = 0;
    float top = bottom;
    for (const Part& part : kParts) {
      const float below = top;
      seconds += frames.at(i).*part.seconds;
      top = bottom - wholePixels(std::min(1.0, seconds / scale) * size.y);
      list.AddRectFilled({left, top}, {left + bar, below}, part.color);
    }
  }
  const std::string label = fmt::format("{:g} ms", 1e3 * scale);
  list.AddText({from.x + ImGui::GetStyle().ItemInnerSpacing.x, from.y}, IM_COL32_WHITE,
               label.data());
  ImGui::Dummy(size);
}

void showParts(const FrameHistory& frames) {
  if (frames.size() == 0) return;
  const auto medianMs = [&frames](auto partOf) {
    std::vector<double> milliseconds;
    for (std::size_t i = 0; i < frames.size(); ++i)
      milliseconds.push_back(1e3 * partOf(frames.at(i)));
    return spreadOf(std::move(milliseconds));
  };
  const Spread sum = medianMs([](const FrameParts& frame) { return frame.sum(); });
  showText(fmt::format("frame {:.2f} ms, 95 of 100 within {:.2f}", sum.median, sum.p95));
  for (const Part& part : kParts) {
    const Spread spread =
        medianMs([&part](const FrameParts& frame) { return frame.*part.seconds; });
    ImGui::PushStyleColor(ImGuiCol_Text, part.color);
    showText(fmt::format("{} {:.2f}", part.name, spread.median));
    ImGui::PopStyleColor();
    if (&part != &kParts.back()) ImGui::SameLine(0, 2 * ImGui::GetFontSize());
  }
}

void showCounters(const FrameCounters& counters) {
  if (!ImGui::BeginTable("counters", 4)) return;
  for (const FrameCounter& counter : counters) {
    ImGui::TableNextColumn();
    showText(std::string(counter.name));
    ImGui::TableNextColumn();
    const std::string count = fmt::format("{:.0f}", counter.mean);
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(count.data()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room));
    showText(count);
  }
  ImGui::EndTable();
}

void showBake(const std::optional<StageProgress>& bake) {
  if (!bake) return showText("bake: none under way");
  ImGui::ProgressBar(static_cast<float>(percentOf(*bake)) / 100, {-1, 0},
                     progressText(*bake).data());
}

}  // namespace

double scaleFor(double longest) {
  constexpr double kLeast = 1e-3;
  double scale = kLeast;
  while (true) {
    for (const double step : {1.0, 2.0, 5.0})
      if (step * scale >= longest || !std::isfinite(longest)) return step * scale;
    scale *= 10;
  }
}

void showFigures(const Figures& figures) {
  showGraph(figures.frames);
  showParts(figures.frames);
  ImGui::Separator();
  showCounters(figures.counters);
  ImGui::Separator();
  showBake(figures.bake);
  showText(fmt::format("memory {:.1f} MiB, of it lightmaps {:.2f}",
                       figures.residentBytes / kBytesPerMiB,
                       static_cast<double>(figures.lightmapBytes) / kBytesPerMiB));
}

}  // namespace hearth
