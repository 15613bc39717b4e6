#pragma once

#include <imgui/imgui.h>

#include "image/image.h"
#include "math/vec.h"

/// The engine's values as ImGui takes them.
namespace hearth {

inline ImVec2 imVec(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
inline ImU32 imColor(Rgb color) { return IM_COL32(color.r, color.g, color.b, 255); }

}  // namespace hearth
