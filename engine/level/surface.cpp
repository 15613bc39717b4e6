#include "level/surface.h"

namespace hearth {

std::string_view name(SurfaceKind kind) {
  constexpr std::array<std::string_view, kSurfaceKindCount> kNames = {"solid wall",
                                                                      "lower step",
                                                                      "upper step",
                                                                      "stack solid",
                                                                      "stack lower step",
                                                                      "stack upper step",
                                                                      "floor sidewall",
                                                                      "ceiling sidewall",
                                                                      "middle texture",
                                                                      "floor",
                                                                      "ceiling",
                                                                      "sloped floor",
                                                                      "sloped ceiling",
                                                                      "camera sprite",
                                                                      "fixed sprite",
                                                                      "flat sprite",
                                                                      "mesh",
                                                                      "sky ceiling",
                                                                      "sky floor",
                                                                      "sky upper step",
                                                                      "sky lower step"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace hearth
