#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "load/link/link.h"

namespace hearth {

namespace {

/// The textures of walls that show others while the walls are on.
class SwitchTextureLinker {
 public:
  explicit SwitchTextureLinker(Linking& linking) : linking_(linking) {}

  void link(SegmentId id) {
    const bool isStandIn = !linking_.walls[linking_.edgeOf[id.index()]];
    if (isStandIn) return;  // for a wall with a mistake, which is reported
    const WallDescription& wall = linking_.describedWall(id);
    const std::span<const WallSurfaces> walls = linking_.level.surfacesOf(linking_.level[id]);
    if (wall.switched) add(id, std::nullopt, wall.switched->on, walls);
    const auto* stack = std::get_if<StackDescription>(&wall.kind);
    if (!stack) return;
    for (std::uint32_t i = 0; i < stack->subWalls.size(); ++i)
      if (const auto& switched = stack->subWalls[i].switched)
        add(id, i, switched->on, walls.subspan(i, 1));
  }

  /// By surface, as the level has them.
  void sort() {
    std::ranges::stable_sort(linking_.level.switchTextures, {}, &SwitchTexture::surface);
  }

 private:
  void add(SegmentId segment, std::optional<std::uint32_t> subWall,
           const std::vector<SwitchTextureDescription>& textures,
           std::span<const WallSurfaces> walls) {
    for (const SwitchTextureDescription& texture : textures) {
      const TextureId off = linking_.textures.idOf(texture.off);
      const TextureId on = linking_.textures.idOf(texture.on);
      bool isWorn = false;
      for (const WallSurfaces& wall : walls)
        for (const auto& surface : {wall.solid, wall.lower, wall.upper}) {
          if (!surface || linking_.level[*surface].mapping.texture != off) continue;
          isWorn = true;
          for (const MoverSwitch& each : linking_.level.switchesOf(segment))
            if (!each.isCrossed && each.subWall == subWall)
              linking_.level.switchTextures.push_back({*surface, each.mover, off, on});
        }
      if (!isWorn && unworn_.insert(texture.off.place).second)
        linking_.report.error(
            texture.off.place,
            fmt::format("no face of this wall has the texture \"{}\"", texture.off.name),
            "name one of its \"texture\", \"upper\" or \"lower\"");
    }
  }

  Linking& linking_;
  std::set<Place> unworn_;  ///< that are reported: a wall may be split into several segments
};

}  // namespace

void linkSwitchTextures(Linking& linking) {
  SwitchTextureLinker linker(linking);
  for (std::size_t i = 0; i < linking.level.segments.size(); ++i) linker.link(SegmentId(i));
  linker.sort();
}

}  // namespace hearth
