#include "support/baked_room.h"

#include <cmath>
#include <utility>
#include <vector>

#include "math/check.h"
#include "support/level_text.h"

namespace hearth::test {

BakedRoom::BakedRoom(std::string_view levelText, std::string_view lightsText, int threads)
    : BakedRoom(levelFrom(levelText, lightsText), threads) {}

BakedRoom::BakedRoom(LoadedLevel loaded, int threads)
    : loaded_(std::move(loaded)), light_(bake(loaded_.scene(), loaded_.level.bake, threads)) {}

double BakedRoom::at(SurfaceKind kind, Vec3 p, std::string_view sector, int channel) const {
  const std::optional<SurfaceId> id = surfaceAt(kind, p, sector);
  CHECK(id, name(kind), p.x, p.y, p.z);
  const auto& lightmap = light_.lightmaps[id->index()];
  const Vec2 texels = light_.surfaces[id->index()]->grid.toTexels(p);
  return lightmap ? lightmap->sample(texels.x, texels.y, channel) : 0;
}

std::optional<SurfaceId> BakedRoom::surfaceAt(SurfaceKind kind, Vec3 p,
                                              std::string_view sector) const {
  constexpr double kNear = 1e-6;
  for (const SurfaceId id : scene().shownSurfaces()) {
    const Surface& surface = level()[id];
    const auto& lit = light_.surfaces[id.index()];
    if (surface.kind != kind || !lit || std::abs(lit->distanceInFront(p)) > kNear) continue;
    if (!sector.empty() && level()[surface.sector].name != sector) continue;
    const Vec2 texels = lit->grid.toTexels(p);
    if (lit->outline.contains(texels) || length(lit->outline.nearest(texels) - texels) < kNear)
      return id;
  }
  return std::nullopt;
}

BakedLight withAllTexels(BakedLight light) {
  for (auto& map : light.lightmaps) {
    if (!map || !map->isUniform()) continue;
    const std::vector<std::uint8_t> one = std::exchange(map->levels, {});
    for (std::int64_t i = 0; i < map->rect.count(); ++i)
      map->levels.insert(map->levels.end(), one.begin(), one.end());
  }
  return light;
}

}  // namespace hearth::test
